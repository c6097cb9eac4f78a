# SPDX-License-Identifier: BSD-3-Clause
"""A year of daylight: weather files, sun positions, coefficients."""
import datetime
import json
import math

import numpy as np
import pytest
from conftest import one_line

import kalos
from kalos.daylight.patches import Patches
from kalos.daylight.weather import time_of

pytest.importorskip("astropy", reason="no astropy")
LOCATION = "LOCATION,Somewhere,-,-,test,0,48.0,11.0,1.0,500"


def weather(direct, diffuse, change=lambda rows: rows):
    """A year in which every hour of daylight has the same irradiances."""
    rows = [LOCATION] + [f"HEADER {i}" for i in range(2, 9)]
    for i in range(8760):
        month, day, hour = time_of(i)
        fields = ["2001", str(month), str(day), str(hour), "60"] + ["0"] * 30
        light = 6 < hour < 19
        fields[14], fields[15] = (str(direct), str(diffuse)) if light else ("0", "0")
        rows.append(",".join(fields))
    return "\n".join(change(rows)) + "\n"


@pytest.fixture
def outdoors(scene):
    scene["sky"] = {"cie": 5, "horizontal_illuminance": 1}
    del scene["luminaires"], scene["cameras"]
    scene["receivers"] = [{"name": "high", "plane": {"origin": [0, 0, 5], "u": [2, 0, 0], "v": [0, 2, 0], "resolution": [2, 1]}}]
    return scene


def test_patches_cover_the_sky():
    for subdivision, count in ((1, 145), (2, 577)):
        patches = Patches(subdivision)
        assert patches.count == count
        assert patches.solid_angles().sum() == pytest.approx(2 * math.pi, rel=1e-12)
        elevation, azimuth = patches.samples()
        assert (patches.of(elevation, azimuth) == np.arange(count)[:, None]).all()


def test_the_sun_stands_where_almanacs_say():
    """Greenwich at noon of the summer solstice: 90 - 51.48 + 23.44 degrees, due south."""
    elevation, azimuth = kalos.sun_position(datetime.datetime(2023, 6, 21, 12, 2, tzinfo=datetime.timezone.utc), 51.48, 0.0)
    assert elevation == pytest.approx(61.96, abs=0.05)
    assert azimuth == pytest.approx(180, abs=0.6)
    with pytest.raises(kalos.InputError, match="no time zone"):
        kalos.sun_position(datetime.datetime(2023, 6, 21), 51.48, 0.0)


def test_a_plane_outdoors_gets_all_of_the_light(outdoors, command, tmp_path):
    """The mean over the daylit hours is the diffuse illuminance of Perez's efficacies, and the sun's share of the horizontal."""
    (tmp_path / "t.epw").write_text(weather(0, 100))
    status, out, error = command("year", outdoors.save(), "--weather", tmp_path / "t.epw", "--out", tmp_path / "out", "--trajectories", 64)
    assert status == 0, error
    hours = np.load(tmp_path / "out" / "high.npz")["illuminance"]
    assert hours.shape == (8760, 2)
    lit = hours[:, 0] > 0
    assert 3500 < lit.sum() < 4400
    assert np.median(hours[lit, 0]) == pytest.approx(11500, rel=0.1)  # 100 W/m2 of overcast sky, lm/W
    found = json.loads((tmp_path / "out" / "year.json").read_text())
    assert found["patches"] == 145
    assert found["receivers"]["high"]["annual_mean_lx"] == pytest.approx(hours.mean(), rel=1e-5)
    assert not np.isnan(hours).any()


def dropped(rows):
    return rows[:-1]


def negative(rows):
    fields = rows[100].split(",")
    fields[14] = "-5"
    return rows[:100] + [",".join(fields)] + rows[101:]


def shifted(rows):
    return rows[:50] + rows[51:] + rows[50:51]


@pytest.mark.parametrize("change, message", [
    (dropped, "file: has 8759 hours; expected 8760"),
    (negative, "line 101: the direct normal irradiance is -5; expected W/m2, 0 or more"),
    (shifted, "line 51: not the hour that is expected, month 1, day 2, hour 19"),
    (lambda rows: rows[1:], "line 1: no LOCATION; expected an EnergyPlus weather file"),
    (lambda rows: [rows[0].replace("48.0", "north")] + rows[1:],
     "line 1: latitude, longitude or time zone is no number; expected degrees and hours"),
    (lambda rows: [rows[0].replace("48.0", "148.0")] + rows[1:],
     "line 1: latitude, longitude or time zone is out of range; expected up to 90 and 180 degrees and 14 hours")])
def test_bad_weather_is_refused(outdoors, command, tmp_path, change, message):
    path = tmp_path / "t.epw"
    path.write_text(weather(0, 100, change))
    status, _, error = command("year", outdoors.save(), "--weather", path, "--out", tmp_path / "out")
    assert (status, one_line(error)) == (2, f"{path}: {message}")
