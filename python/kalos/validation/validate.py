# SPDX-License-Identifier: BSD-3-Clause
"""Every method against every closed form: the table of `kalos validate`."""
import re
from dataclasses import replace
from pathlib import Path

import numpy as np

from kalos.core.options import METHODS, Options
from kalos.errors import KalosError, update
from kalos.estimation.filters import illuminance_filter
from kalos.results.fields import audit
from kalos.results.receivers import from_dataset
from kalos.results.statistics import error_of
from kalos.scenes.reading import read_scene, receiver_names
from kalos.validation.cases import CASES, DATA
from kalos.validation.verdicts import FALSE_ALARM, REPLICATES, judge


def solve_receivers(path, options):
    """The receiver sets of a scene file, estimated."""
    reader = read_scene(path)
    estimator = illuminance_filter(reader, options)
    update(estimator)
    blocks = estimator.GetOutputDataObject(0)
    return [from_dataset(name, blocks.GetBlock(i)) for i, name in enumerate(receiver_names(reader))]


STATING = ("photon-map", "radiosity")  # their error bars hold noise alone: the audit states a bias
STATED_PRECISION = 0.05  # relative, of their means
STATED = 3.0  # standard errors that a stated bias may be off by


def examine(case, options, data=DATA):
    """Solves a case, and again with 4, 16 and 64 times the effort until the error is small enough to tell anything."""
    if options.method in STATING:
        return examine_stated(case, options, data)
    for factor in (1, 4, 16, 64):
        verdict = examine_once(case, replace(options, trajectories=factor * options.trajectories), data)
        if verdict.error <= case.precision:
            break
    return verdict


def examine_stated(case, options, data=DATA):
    """Judges the mean over the receivers, by automatic lengths, beside the bias that the audit states of the indirect light."""
    reader = read_scene(Path(data) / case.scene)
    estimator = illuminance_filter(reader, replace(options, delta=None, epsilon=None))
    update(estimator)
    blocks = estimator.GetOutputDataObject(0)
    sets = [from_dataset(name, blocks.GetBlock(i)) for i, name in enumerate(receiver_names(reader))]
    truth = np.concatenate([case.truth(r.points, r.normals) for r in sets]).mean()
    replicates = np.concatenate([r.replicates for r in sets]).mean(axis=0)
    indirect = replicates.mean() - np.concatenate([r.direct for r in sets]).mean()
    stated, uncertain = (share * indirect for share in stated_bias(audit(blocks)))
    off = replicates.mean() - truth
    left = max(min(abs(off), abs(off - stated)) - STATED * uncertain, 0)
    return judge(np.array([truth + left]), np.array([error_of(replicates)]), np.array([truth]), STATED_PRECISION,
                 freedom=len(replicates) - 1)


def stated_bias(entries):
    """The bias that an audit states, of the indirect light, and its uncertainty; 0 where it states none."""
    for entry in entries:
        said = entry["subject"] in ("bias", "discretisation") and re.fullmatch(r"(\S+) \+- (\S+) %", entry["choice"])
        if said:
            return tuple(float(number) / 100 for number in said.groups())
    return 0.0, 0.0


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
    say("off by: of the point that is farthest off, in its standard errors (SE). allowed: a sound method exceeds it with that chance.\n"
        f"It is far above the 2 SE of one well-known error, as an error is estimated from {REPLICATES} replicates in most methods (Student's t\n"
        f"with {REPLICATES - 1} degrees of freedom), and the worst of all points of a case counts (Sidak's correction).")
    say(f"{'case':<28} {'method':<17} {'points':>6} {'off by':>8} {'allowed':>8} {'error':>9}  result")
    passed = True
    for case in CASES:
        for method in methods:
            if not case.takes(method):
                continue
            attempt = examine_stated if method in STATING else examine_once if trajectories else examine
            verdict = attempt(case, case.options(method, trajectories, seed), data)
            passed = passed and verdict.passed
            say(f"{case.name:<28} {method:<17} {verdict.points:>6} {verdict.worst:>5.2f} SE {verdict.allowed:>5.2f} SE "
                f"{100 * verdict.error:>7.3f} %  {'pass' if verdict.passed else 'FAIL'}")
    if missing:
        say(f"not in this build: {', '.join(missing)}")
    return passed and bool(methods)
