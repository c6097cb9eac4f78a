# SPDX-License-Identifier: BSD-3-Clause
"""Every method against every closed form: the table of `kalos validate`, and the cases that the tests use too."""
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Callable

import numpy as np
from scipy import stats

from kalos import truths
from kalos.errors import KalosError, update
from kalos.estimator import METHODS, Options
from kalos.receivers import from_dataset
from kalos.solve import illuminance, read_scene, receiver_names

PACKAGE = Path(__file__).resolve().parent
DATA = PACKAGE.parents[1] / "data"  # of the source tree
if not DATA.exists():
    DATA = PACKAGE.parents[3] / "share" / "kalos" / "data"  # of an installed one
REPLICATES = 8  # at least, of an estimate; its standard error has one degree of freedom less
OFFSET = 1e-5  # of the largest value: receivers are lifted off their surface by micrometres, so that it cannot hide them
FALSE_ALARM = 1e-4  # chance that a sound method fails a case, however many points the case has


@dataclass(frozen=True)
class Case:
    """A scene whose illuminance is known at every receiver."""

    name: str
    scene: str  # below data/
    truth: Callable  # of points (n, 3) and normals (n, 3): illuminance, lx, (n,)
    trajectories: int
    precision: float  # largest relative standard error that still tests something
    cell: float = None  # m, half side of the cells of method direct; where None its means over cells are no points
    near: float = None  # m, delta and epsilon of the methods that average or clamp, where the automatic ones are too wide

    def options(self, method, trajectories=None, seed=1):
        """How this case is solved by a method."""
        near = self.cell if method == "direct" else self.near
        return Options(method=method, trajectories=trajectories or self.trajectories, seed=seed, delta=near, epsilon=near)


def even(value):
    return lambda points, normals: np.full(len(points), value)


def sobolev_case(h1, rho1, rho2):
    def truth(points, normals):
        return np.array([truths.sobolev(1, h1, 1, rho1, rho2, float(np.hypot(x, y))) for x, y, _ in points])

    name = f"{10 * rho1:.0f}-{10 * rho2:.0f}"
    return Case(f"Sobolev's planes, {rho1} {rho2}", f"sobolev/sobolev-{name}.json", truth, 100000, 0.01, near=0.02)


CASES = [
    Case("white furnace, boxes", "furnace/furnace.json", even(truths.white_furnace(0.6, 100)), 300000, 0.05, cell=0.25),
    sobolev_case(0.5, 0.5, 0.5),
    sobolev_case(0.5, 0.8, 0.8),
    sobolev_case(0.9, 0.2, 0.7),
    Case("CIE 171 5.2, point", "cie171/5-2.json", lambda p, n: truths.cie171_point(p), 10000, 1e-3),
    Case("CIE 171 5.3, area", "cie171/5-3.json", truths.cie171_area, 10000, 1e-3),
    Case("CIE 171 5.4, isotropic", "cie171/5-4.json",
         lambda p, n: truths.isotropic_point(p, n, np.array([2, 2, 1.5]), 10000), 10000, 1e-3),
    Case("CIE 171 5.6, reflection", "cie171/5-6.json", lambda p, n: 300 * truths.cie171_reflection(p, n), 10000, 1e-3),
    Case("CIE 171 5.7, obstruction", "cie171/5-7.json", lambda p, n: 300 * truths.cie171_obstruction(p, n), 400000, 0.01),
]


@dataclass(frozen=True)
class Verdict:
    """How far an estimate is from the truth, in standard errors, and how far it may be."""

    points: int
    worst: float  # largest deviation, standard errors
    allowed: float
    error: float  # largest standard error, relative to its truth
    precision: float

    @property
    def passed(self):
        return self.worst <= self.allowed and self.error <= self.precision


def allowed_deviation(points, false_alarm=FALSE_ALARM, freedom=REPLICATES - 1):
    """Standard errors that none of `points` values may be off by, but for the given chance.

    Student's t, for the standard errors are estimates; Sidak's correction, which also holds for dependent values.
    """
    single = 1 - (1 - false_alarm) ** (1 / points)
    return float(stats.t.isf(single / 2, freedom))


def judge(estimate, standard_error, truth, precision, false_alarm=FALSE_ALARM, freedom=REPLICATES - 1):
    """The verdict on estimates of known values. A value without noise may be off by OFFSET."""
    deviation = np.maximum(np.abs(estimate - truth) - OFFSET * np.max(np.abs(truth)), 0)
    in_errors = np.divide(deviation, standard_error, out=np.where(deviation > 0, np.inf, 0.0), where=standard_error > 0)
    lit = truth > 0
    relative = np.max(standard_error[lit] / truth[lit])
    return Verdict(len(truth), float(in_errors.max()), allowed_deviation(len(truth), false_alarm, freedom), float(relative),
                   precision)


def solve_receivers(path, options):
    """The receiver sets of a scene file, estimated."""
    reader = read_scene(path)
    estimator = illuminance(reader, options)
    update(estimator)
    blocks = estimator.GetOutputDataObject(0)
    return [from_dataset(name, blocks.GetBlock(i)) for i, name in enumerate(receiver_names(reader))]


def examine(case, options, data=DATA):
    """Solves a case, and again with 4, 16 and 64 times the effort until the error is small enough to tell anything."""
    for factor in (1, 4, 16, 64):
        verdict = examine_once(case, replace(options, trajectories=factor * options.trajectories), data)
        if verdict.error <= case.precision:
            break
    return verdict


def examine_once(case, options, data=DATA):
    """Solves a case and judges all its receivers together."""
    sets = solve_receivers(Path(data) / case.scene, options)
    truth = np.concatenate([case.truth(r.points, r.normals) for r in sets])
    estimate = np.concatenate([r.illuminance for r in sets])
    error = np.concatenate([r.standard_error for r in sets])
    return judge(estimate, error, truth, case.precision, freedom=sets[0].replicates.shape[1] - 1)


def available_methods(data, seed):
    """The methods that this build has."""
    found = []
    for method in METHODS:
        try:
            examine_once(CASES[4], Options(method=method, trajectories=REPLICATES, seed=seed), data)
            found.append(method)
        except KalosError as error:
            if "available" not in str(error):
                raise
    return found


def validate(data=None, wanted=None, trajectories=None, seed=1, say=print):
    """Prints the table; returns whether every wanted method (None: all) passed every case it applies to."""
    data = Path(data) if data else DATA
    available = available_methods(data, seed)
    methods = [method for method in wanted or METHODS if method in available]
    missing = [method for method in wanted or METHODS if method not in available]
    say(f"seed {seed}; chance that a sound method fails a case: {FALSE_ALARM:g}")
    say(f"{'case':<28} {'method':<17} {'points':>6} {'off by':>8} {'allowed':>8} {'error':>9}  result")
    passed = True
    for case in CASES:
        for method in methods:
            if method == "direct" and not case.cell:
                continue
            attempt = examine_once if trajectories else examine
            verdict = attempt(case, case.options(method, trajectories, seed), data)
            passed = passed and verdict.passed
            say(f"{case.name:<28} {method:<17} {verdict.points:>6} {verdict.worst:>5.2f} SE {verdict.allowed:>5.2f} SE "
                f"{100 * verdict.error:>7.3f} %  {'pass' if verdict.passed else 'FAIL'}")
    if missing:
        say(f"not in this build: {', '.join(missing)}")
    return passed and bool(methods)
