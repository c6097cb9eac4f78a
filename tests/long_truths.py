# SPDX-License-Identifier: BSD-3-Clause
"""Every method on every truth over many seeds: whether the mean is true and the intervals hold it.

tests/long_truths.py [SEEDS]   with PYTHONPATH=build/python; prints a table, exit status 1 if a sound method fails

Short solves, so that a bias that a single long one hides in its noise shows in the mean: z is the mean over the seeds of a
receiver, less the truth, in standard errors of that mean, the largest over the receivers. Allowed is what a sound method exceeds
with probability 1e-4 a case (Sidak over the receivers); a receiver without any light in all seeds is infinitely far off. The methods that alter the kernel, and `gathered`, are biased: they are
printed and do not count.
"""
import sys

import numpy as np
from scipy import stats

from kalos.core.options import METHODS
from kalos.validation.cases import CASES, DATA
from kalos.validation.validate import solve_receivers
from kalos.validation.verdicts import FALSE_ALARM, OFFSET

UNBIASED = ("compensated", "local", "direct")
TRAJECTORIES = 640
HITS = {"direct": 10 * TRAJECTORIES}  # it counts hits of cells: about 20 each, so that none stays without and errors are normal


def figures(case, method, seeds):
    """Largest |z|, and the share of intervals that hold the truth; None where nothing fluctuates."""
    values, errors = [], []
    for seed in range(1, seeds + 1):
        sets = solve_receivers(DATA / case.scene, case.options(method, HITS.get(method, TRAJECTORIES), seed))
        values.append(np.concatenate([r.illuminance for r in sets]))
        errors.append(np.concatenate([r.standard_error for r in sets]))
    truth = np.concatenate([case.truth(r.points, r.normals) for r in sets])
    values, errors = np.array(values), np.array(errors)
    offset = np.maximum(np.abs(values.mean(axis=0) - truth) - OFFSET * truth.max(), 0)
    spread = values.std(axis=0, ddof=1) / np.sqrt(seeds)
    z = np.divide(offset, spread, out=np.where(offset > 0, np.inf, 0.0), where=spread > 0)
    covered = np.abs(values - truth) <= stats.t.isf(0.025, sets[0].replicates.shape[1] - 1) * errors + OFFSET * truth.max()
    return float(z.max()), float(covered.mean()), len(truth)


def main(seeds=200):
    failed = False
    print(f"{seeds} seeds from 1, {TRAJECTORIES} trajectories each, {HITS['direct']} of direct")
    print(f"{'case':<28} {'method':<17} {'z':>7} {'allowed':>8} {'covered':>8}")
    for case in CASES:
        for method in METHODS:
            if not case.takes(method):
                continue
            z, covered, points = figures(case, method, seeds)
            allowed = stats.t.isf((1 - (1 - FALSE_ALARM) ** (1 / points)) / 2, seeds - 1)
            counts = method in UNBIASED and not (method == "local" and "furnace" in case.scene)  # its variance is not finite there
            bad = counts and z > allowed
            failed = failed or bad
            print(f"{case.name:<28} {method:<17} {z:>7.2f} {allowed:>8.2f} {100 * covered:>6.1f} %"
                  f"{'  FAIL' if bad else '' if counts else '  biased, or without a finite variance'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
