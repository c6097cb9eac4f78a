# SPDX-License-Identifier: BSD-3-Clause
"""CIE 171:2006, 5.8, by the methods that state a bias: the mean over the cube's floor is right within what they state.

By symmetry it is (Phi/S) rho/(1 - rho) of reflected light. What is left beyond the stated bias and three of its standard errors is
within 5 standard errors of 7 degrees of freedom: false alarm 2e-3 a value for one whose bias is stated exactly; seeds are fixed.
"""
import numpy as np
import pytest

from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.results.fields import audit
from kalos.results.receivers import from_dataset, point_receivers
from kalos.results.statistics import error_of
from kalos.scenes.reading import read_scene
from kalos.validation import truths
from kalos.validation.cases import DATA
from kalos.validation.figures import octant
from kalos.validation.validate import STATED, stated_bias

LARGEST = {"radiosity": 0.04, "photon-map": 0.25}  # a stated bias that still says something: the map loses half discs at the walls


@pytest.mark.parametrize("method, trajectories", [("radiosity", 40000), ("photon-map", 640000)])
@pytest.mark.parametrize("percent", [20, 50, 80])
def test_balance_of_energy(method, trajectories, percent):
    points, normals = np.split(np.loadtxt(DATA / "cie171" / "5-8-floor.csv", delimiter=",", skiprows=1), 2, axis=1)
    indices, weights = octant()
    estimator = illuminance_filter(read_scene(DATA / "cie171" / f"5-8-{percent:02d}.json"),
                                   Options(method=method, trajectories=trajectories, seed=3))
    estimator.SetInputDataObject(0, point_receivers(points[indices], normals[indices]))
    update(estimator)
    output = estimator.GetOutputDataObject(0)
    floor = from_dataset("floor", output)
    truth = truths.mean_indirect(10000, 96, percent / 100)
    replicates = weights @ (floor.replicates - floor.direct[:, None]) / truth - 1
    bias, uncertain = stated_bias(audit(output))
    off = replicates.mean()
    left = max(min(abs(off), abs(off - bias)) - STATED * uncertain, 0)
    print(f"{method} {percent} %: off by {100 * off:+.2f} %, stated {100 * bias:+.2f} +- {100 * uncertain:.2f} %")
    assert abs(bias) < LARGEST[method] and uncertain < 0.05
    assert left <= 5 * error_of(replicates) + 2e-3
