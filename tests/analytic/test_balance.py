# SPDX-License-Identifier: BSD-3-Clause
"""Balances of energy over whole rooms: CIE 171:2006 cases 5.4 and 5.8, and the integrating sphere.

Receivers of one solve share their trajectories, so their errors are dependent: the standard error of a mean over them
comes from solves with different seeds.
"""
import numpy as np
import pytest
from estimates import lamp, scene, solve
from scipy import stats

from kalos.core.options import Options
from kalos.results.receivers import areas
from kalos.validation import truths
from kalos.validation.cases import DATA
from kalos.validation.validate import solve_receivers

FALSE_ALARM = 1e-4
GAUSS = np.polynomial.legendre.leggauss(8)[1] / 2  # weights of the points of 5-8-floor.csv along one side


def means(scene, mean_of, seeds, **options):
    """One mean per seed."""
    print(f"{scene}: seeds {seeds.start} to {seeds.stop - 1}")
    return np.array([mean_of(solve_receivers(DATA / scene, Options(seed=seed, **options))) for seed in seeds])


def check(values, truth, precision, false_alarm=FALSE_ALARM):
    """The mean of independent values is the truth, by Student's t with one degree of freedom less than values."""
    error = values.std(ddof=1) / np.sqrt(len(values))
    deviation = abs(values.mean() - truth) / error
    print(f"mean {values.mean():.6g}, truth {truth:.6g}, {deviation:.2f} standard errors of {100 * error / truth:.3f} %")
    assert deviation <= stats.t.isf(false_alarm / 2, len(values) - 1)
    assert error / truth <= precision, "too noisy to tell anything"


def indirect_mean_of_floor(sets):
    floor, = sets
    return np.outer(GAUSS, GAUSS).ravel() @ (floor.illuminance - floor.direct)


@pytest.mark.parametrize("percent", [5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 95])
def test_cube_of_cie171(percent):
    """By symmetry the mean over the floor is the mean over all surfaces; its Gauss rule is exact to 1e-5 of it."""
    values = means(f"cie171/5-8-{percent:02d}.json", indirect_mean_of_floor, range(100, 116), trajectories=8000)
    check(values, truths.mean_indirect(10000, 96, percent / 100), 0.01)


def test_all_flux_arrives():
    """Case 5.4: in a black room, received over emitted flux is 1; direct simulation loses not a trajectory."""
    sets = solve_receivers(DATA / "cie171" / "5-4.json", Options(method="direct", trajectories=20000, seed=5))
    received = sum(areas(one.dataset) @ one.illuminance for one in sets)
    assert received == pytest.approx(10000, rel=1e-9)


def test_all_flux_arrives_at_points():
    """The same from estimates at cell centres, whose midpoint rule errs in the second order of the cell's size."""
    sets = solve_receivers(DATA / "cie171" / "5-4.json", Options(trajectories=32))
    received = sum(areas(one.dataset) @ one.illuminance for one in sets)
    assert received == pytest.approx(10000, rel=1e-3)


def mean_indirect(sets):
    wall, = sets
    return np.average(wall.illuminance - wall.direct, weights=wall.weights)


@pytest.mark.parametrize("method, level, trajectories, precision", [
    ("local", 2, 4000, 0.006), ("direct", 2, 64000, 0.002), ("direct", 3, 64000, 0.002)])
def test_sphere_of_triangles(method, level, trajectories, precision):
    """The balance over the polyhedron's own area; for local, centres of triangles stand for their means."""
    scene = f"sphere/sphere-{level}.json"
    wall, = solve_receivers(DATA / scene, Options(trajectories=32))
    values = means(scene, mean_indirect, range(200, 216), trajectories=trajectories, method=method)
    check(values, truths.mean_indirect(1000, wall.weights.sum(), 0.5), precision)


def test_sphere_nears_the_truth_as_the_mesh_is_refined():
    """Four times the triangles, a quarter of the error: 1.9 % and 0.5 %, each known to 0.1 %."""
    truth = truths.sphere_indirect(1000, 1, 0.5)
    coarse, fine = (means(f"sphere/sphere-{level}.json", mean_indirect, range(300, 308), trajectories=200000, method="direct")
                    for level in (2, 3))
    errors = [abs(values.mean() / truth - 1) for values in (coarse, fine)]
    print(f"relative errors {errors}")
    assert errors[1] < errors[0] / 2 < 0.02


@pytest.mark.parametrize("method", ["local", "direct"])
def test_a_closed_box_keeps_its_light(tmp_path, method):
    """A source inside a box, turned so that no face is exact in floating point: the outside of the faces stays dark."""
    box = {"name": "box", "box": {"center": [3.3, 1.7, 0.75], "size": [1.5, 1.5, 1.5], "rotation_z_deg": -17},
           "material": "grey"}
    probes = np.array([(3.3, 1.7, 1.5, 0, 0, 1), (3.3, 1.7, 1.5, 0, 0, -1)])
    outside, inside = solve(tmp_path, scene([box], [lamp((3.3, 1.7, 0.75), distribution="isotropic")]), probes,
                            method=method, epsilon=0.25).illuminance
    assert inside > 1000
    assert outside <= 1e-6 * inside
