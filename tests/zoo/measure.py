# SPDX-License-Identifier: BSD-3-Clause
"""Solves a room with several seeds and says how its estimates, errors and flags compare with the truth."""
import csv
from dataclasses import astuple, dataclass, fields

import numpy as np
from scipy import stats

from kalos.core import arrays
from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.preparation.scene import prepare_scene
from kalos.results.fields import field_value
from kalos.results.receivers import from_dataset
from kalos.scenes.reading import read_scene
from kalos.validation.verdicts import OFFSET

CONFIDENCE = 0.95
FAR = 0.10  # relative deviation with which a value has deserved its flag, whatever its interval
GOAL = 0.90  # least share of unflagged 95 % intervals that hold the truth
DOUBT = 0.01  # chance that the seeds of a method that just reaches it fall so low


@dataclass
class Solves:
    """Estimates of several seeds (rows) at the receivers of a room (columns)."""

    values: np.ndarray  # lx
    errors: np.ndarray  # lx
    trusted: np.ndarray
    freedom: int  # of the standard errors
    seconds: np.ndarray  # of processor time, per seed


@dataclass(frozen=True)
class Figures:
    """A row of the table; a share of nothing is no number."""

    room: str
    method: str
    holds: float  # share of the 95 % intervals that hold the truth
    unflagged_holds: float
    flagged_holds: float
    flagged: float  # share of the values
    deserved: float  # share of the flagged: the interval misses the truth, or the value is off by more than FAR
    mean_off: float  # mean relative deviation
    largest: float  # largest deviation, standard errors
    rms: float  # relative
    seconds_to_one: float  # processor seconds to 1 % rms error: time x variance, in units of 1e-4
    seconds: float  # processor seconds of a solve
    sure_below: bool  # unflagged_holds is below GOAL by more than the seeds' spread explains


def solve(room, folder, method, seeds, trajectories):
    """As `kalos solve` does it, on one thread, without what it writes."""
    path = room.write(folder)
    reader = read_scene(path)
    prepared = prepare_scene(path, reader)
    found, seconds = [], []
    for seed in range(1, seeds + 1):
        estimator = prepared.put(illuminance_filter(reader, Options(method=method, trajectories=trajectories, seed=seed, threads=1)))
        update(estimator)
        output = estimator.GetOutputDataObject(0)
        found.append(from_dataset("probe", output.GetBlock(0)))
        seconds.append(field_value(output, arrays.SOLVE_CPU_SECONDS))
    return Solves(np.array([one.illuminance for one in found]), np.array([one.standard_error for one in found]),
                  np.array([one.trusted for one in found]), found[0].replicates.shape[1] - 1, np.array(seconds))


def holding(solves, truth, noise):
    """Which intervals hold the truth. They are widened by the truth's own noise, and by what lifting receivers off their surface
    can change."""
    half = np.hypot(stats.t.isf((1 - CONFIDENCE) / 2, solves.freedom) * solves.errors, stats.norm.isf((1 - CONFIDENCE) / 2) * noise)
    return np.abs(solves.values - truth) <= half + OFFSET * truth.max()


def judge(room, method, solves, truth, noise):
    """The figures of a room's solves."""
    held, trusted = holding(solves, truth, noise), solves.trusted
    off = solves.values - truth
    spread = np.hypot(solves.errors, noise)
    beyond = np.maximum(np.abs(off) - OFFSET * truth.max(), 0)
    in_errors = np.divide(beyond, spread, out=np.where(beyond > 0, np.inf, 0.0), where=spread > 0)
    variance = np.mean(np.maximum(off**2 - noise**2, 0) / truth**2)
    return Figures(room, method, held.mean(), share(held, trusted), share(held, ~trusted), float(np.mean(~trusted)),
                   share(~held | (np.abs(off) > FAR * truth), ~trusted),
                   float(np.mean(off / truth)), float(in_errors.max()), float(np.sqrt(variance)),
                   float(solves.seconds.mean() * variance / 1e-4), float(solves.seconds.mean()), below(held, trusted))


def share(held, chosen):
    return float(held[chosen].mean()) if chosen.any() else float("nan")


def below(held, trusted):
    """Whether the share of unflagged intervals that hold is below the goal for sure: Student's t over the seeds, as the receivers
    of a seed share their trajectories."""
    shares = np.array([one[chosen].mean() for one, chosen in zip(held, trusted) if chosen.any()])
    if len(shares) < 2:
        return bool(len(shares) and shares[0] < GOAL)
    upper = shares.mean() + stats.t.isf(DOUBT, len(shares) - 1) * shares.std(ddof=1) / np.sqrt(len(shares))
    return bool(upper < GOAL)


TITLES = (f"{'room':<26} {'method':<12} {'holds':>6} {'unfl.':>6} {'flag.':>6} {'flagged':>8} {'deserved':>8} {'mean off':>9} "
          f"{'largest':>9} {'rms':>8} {'s to 1 %':>9} {'cpu s':>8}")


def line(one):
    def percent(value, digits=0, width=6):
        return f"{'-':>{width}}" if np.isnan(value) else f"{100 * value:>{width}.{digits}f}"

    return (f"{one.room:<26} {one.method:<12} {percent(one.holds)} {percent(one.unflagged_holds)} {percent(one.flagged_holds)} "
            f"{percent(one.flagged, 1, 8)} {percent(one.deserved, 0, 8)} {percent(one.mean_off, 2, 9)} {one.largest:>9.3g} "
            f"{percent(one.rms, 2, 8)} {one.seconds_to_one:>9.3g} {one.seconds:>8.3g}{'  below the goal' if one.sure_below else ''}")


def over_all(rows, ordinary):
    """What the zoo as a whole says about flags, per method; every room counts the same."""
    texts = []
    for method in dict.fromkeys(one.method for one in rows):
        own = [one for one in rows if one.method == method]
        reaching = np.array([one.unflagged_holds for one in own if not np.isnan(one.unflagged_holds)])
        text = f"{method}: unflagged intervals hold in 90 to 98 % in {np.sum((reaching >= GOAL) & (reaching <= 0.98))} of {len(own)} rooms"
        text += f", in less in {np.sum(reaching < GOAL)}"
        deserved, weights = (np.array([getattr(one, name) for one in own]) for name in ("deserved", "flagged"))
        if weights.any():
            text += f"; of the flagged values {100 * np.average(np.nan_to_num(deserved), weights=weights):.0f} % deserve it"
        plain = [one.flagged for one in own if one.room in ordinary]
        texts.append(text + (f"; in ordinary rooms {100 * np.mean(plain):.2f} % are flagged" if plain else ""))
    return texts


def write_csv(path, rows):
    with path.open("w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow([one.name for one in fields(Figures)])
        table.writerows(astuple(one) for one in rows)
