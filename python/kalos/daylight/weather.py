# SPDX-License-Identifier: BSD-3-Clause
"""Weather of a year from an EnergyPlus file (.epw)."""
import csv
import math
from dataclasses import dataclass

import numpy as np

from kalos.errors import KalosError

HEADER_LINES, HOURS = 8, 8760
MONTH_ENDS = np.cumsum([0, 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31])
MONTH, DAY, HOUR, DIRECT, DIFFUSE = 1, 2, 3, 14, 15  # columns
MISSING = 9999  # what the format writes where an irradiance is not known


@dataclass(frozen=True)
class Weather:
    """8760 hours, the first being the one that ends at 1 o'clock of 1 January."""

    place: str
    latitude: float  # degrees north
    longitude: float  # degrees east
    time_zone: float  # hours before UTC
    direct_normal: np.ndarray  # W/m2
    diffuse_horizontal: np.ndarray  # W/m2


def read_epw(path):
    """Raises KalosError for a file that is not one, lacks hours, or has irradiances that are missing or negative."""

    def refuse(where, what):
        raise KalosError(f"{path}: {where}: {what}") from None

    try:
        with open(path, newline="", encoding="utf-8-sig", errors="replace") as file:
            rows = list(csv.reader(file))
    except OSError as error:
        refuse("file", f"cannot be read ({error.strerror}); expected an EnergyPlus weather file")
    if not rows or rows[0][:1] != ["LOCATION"] or len(rows[0]) < 9:
        refuse("line 1", "no LOCATION; expected an EnergyPlus weather file")
    try:
        latitude, longitude, zone = (float(rows[0][i]) for i in (6, 7, 8))
    except ValueError:
        refuse("line 1", "latitude, longitude or time zone is no number; expected degrees and hours")
    if not (abs(latitude) <= 90 and abs(longitude) <= 180 and abs(zone) <= 14):
        refuse("line 1", "latitude, longitude or time zone is out of range; expected up to 90 and 180 degrees and 14 hours")
    hours = [row for row in rows[HEADER_LINES:] if row]
    if len(hours) != HOURS:
        refuse("file", f"has {len(hours)} hours; expected {HOURS}")
    found = np.zeros((2, HOURS))
    for i, row in enumerate(hours):
        where, expected = f"line {HEADER_LINES + i + 1}", time_of(i)
        if len(row) <= DIFFUSE or tuple(map(number, row[MONTH:HOUR + 1])) != expected:
            refuse(where, "not the hour that is expected, month {}, day {}, hour {}".format(*expected))
        for k, (column, name) in enumerate(((DIRECT, "direct normal"), (DIFFUSE, "diffuse horizontal"))):
            value = number(row[column])
            if not 0 <= value < MISSING:
                refuse(where, f"the {name} irradiance is {row[column]}; expected W/m2, 0 or more")
            found[k, i] = value
    return Weather(rows[0][1], latitude, longitude, zone, *found)


def number(text):
    try:
        value = float(text)
    except ValueError:
        return math.nan
    return value


def time_of(i):
    """Month, day and hour (1 to 24, at its end) of hour i of a year."""
    day, hour = divmod(i, 24)
    month = int(np.searchsorted(MONTH_ENDS, day, side="right"))
    return month, day - int(MONTH_ENDS[month - 1]) + 1, hour + 1
