# SPDX-License-Identifier: BSD-3-Clause
"""White furnace, 0.1 mm to 1 m from edges, from three-plane corners and from the contact of a box with the floor;
and from edges of 5 to 170 degrees of an irregular closed mesh.

A sound method fails a test with probability 1e-4 (kalos.validation.verdicts.FALSE_ALARM), however many receivers there are.
"""
import importlib.util

import numpy as np
import pytest
from scipy import stats

from kalos.core.options import Options
from kalos.validation import truths
from kalos.validation.cases import DATA
from kalos.validation.validate import solve_receivers
from kalos.validation.verdicts import FALSE_ALARM, judge

FURNACES = {"near-edge": 0.6, "near-edge-95": 0.95, "angles": 0.6}
DISABLED = ((), ("paths",))  # what finds the light of a furnace by itself, and vertices with gather rays
SEED = 21


def distances():
    """Those of the script that wrote the scenes."""
    spec = importlib.util.spec_from_file_location("make", DATA / "furnace" / "make.py")
    make = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make)
    return make.DISTANCES


def solved(scene, trajectories, seed, disabled):
    """Values and standard errors, a pair for each receiver set."""
    sets = solve_receivers(DATA / "furnace" / f"{scene}.json", Options(trajectories=trajectories, seed=seed, disable=disabled))
    return [(one.illuminance, one.standard_error) for one in sets]


@pytest.mark.parametrize("disabled", DISABLED)
@pytest.mark.parametrize("scene", FURNACES)
def test_compensated_is_exact_at_every_distance(scene, disabled):
    truth = truths.white_furnace(FURNACES[scene], 100)
    estimate, error = (np.concatenate(values) for values in zip(*solved(scene, 128000, SEED, disabled)))
    verdict = judge(estimate, error, np.full(len(estimate), truth), 0.03)
    print(f"seed {SEED}: {verdict}")
    assert verdict.worst <= verdict.allowed
    assert verdict.error <= verdict.precision, "too noisy to tell anything"


@pytest.mark.parametrize("disabled", DISABLED)
@pytest.mark.parametrize("scene", FURNACES)
def test_compensated_is_right_on_average(scene, disabled):
    """Each set's mean over 12 seeds: one number a seed, so that receivers of one solve may depend on each other."""
    truth = truths.white_furnace(FURNACES[scene], 100)
    seeds = range(SEED, SEED + 12)
    means = np.array([[values.mean() for values, _ in solved(scene, 32000, seed, disabled)] for seed in seeds])
    error = means.std(axis=0, ddof=1) / np.sqrt(len(seeds))
    deviation = np.abs(means.mean(axis=0) - truth) / error
    print(f"seeds {seeds.start} to {seeds.stop - 1}: {deviation} standard errors of {error / truth}")
    assert deviation.max() <= stats.t.isf(FALSE_ALARM / 2 / means.shape[1], len(seeds) - 1)  # Bonferroni
    assert (error / truth).max() <= 0.01, "too noisy to tell anything"


def test_local_is_not_trusted_near_edges():
    """One millimetre or less away the plain kernel meets next to nothing; in the middle of the wall it is sound."""
    sets = {one.name: one for one in solve_receivers(DATA / "furnace" / "near-edge.json",
                                                     Options(method="local", trajectories=32000, seed=SEED))}
    near = np.array(distances()) <= 1e-3
    for name in ("edge", "corner", "lip"):
        flagged = ~sets[name].trusted.reshape(-1, len(near))
        assert flagged[:, near].all(), name
    assert sets["middle"].trusted.all()
