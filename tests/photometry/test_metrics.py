# SPDX-License-Identifier: BSD-3-Clause
"""Cylindrical and semi-cylindrical illuminance against a single source and the white furnace."""
import json
from pathlib import Path

import numpy as np
import pytest

from kalos.core.options import Options
from kalos.errors import KalosError
from kalos.metrics import cylindrical, semicylindrical
from kalos.scenes.reading import read_scene

FURNACE = Path(__file__).resolve().parents[2] / "data" / "furnace" / "furnace.json"
OPTIONS = Options(trajectories=3200)


@pytest.fixture
def lamp(tmp_path):
    """An isotropic lamp of 4000 pi lm, 1000 cd, at the origin of empty space."""
    (tmp_path / "scene.json").write_text(json.dumps({
        "kalos": 1, "luminaires": [{"name": "lamp", "position": [0, 0, 0], "flux": 4000 * np.pi, "distribution": "isotropic"}],
        "receivers": [{"name": "r", "plane": {"origin": [0, 0, -1], "u": [1, 0, 0], "v": [0, 1, 0], "resolution": [1, 1]}}]}))
    return read_scene(tmp_path / "scene.json")


def test_one_source(lamp):
    """From a source at distance d and elevation e: E_z = I cos(e) / (pi d^2); a half cylinder turned away by a: times 1 + cos(a)."""
    points = np.array([(5.0, 0, 0), (0, 2, 0), (3, 0, -4)])
    level = np.array([1000 / 25, 1000 / 4, 1000 / 25 * 0.6]) / np.pi
    values, errors = cylindrical(lamp, points, OPTIONS)
    np.testing.assert_allclose(values, level, rtol=2e-3)
    assert (errors == 0).all()  # a point's direct light is exact
    for degrees in (0, 50, 90, 180):
        turn = np.radians(180 + degrees)
        values, _ = semicylindrical(lamp, points[:1], (np.cos(turn), np.sin(turn), 0.3), OPTIONS)
        np.testing.assert_allclose(values, level[:1] * (1 + np.cos(np.radians(degrees))), rtol=2e-3, atol=0.1)


def test_white_furnace():
    """The same light from everywhere: every mean is E = M / (1 - rho). 4 values at 4.5 standard errors: below 1e-3."""
    scene = json.loads(FURNACE.read_text())
    white, = scene["materials"].values()
    truth = white["exitance"] / (1 - white["reflectance"])
    reader, points = read_scene(FURNACE), [(0.3, 0.4, 1.2), (4.6, 0.5, 3)]
    for values, errors in (cylindrical(reader, points, OPTIONS), semicylindrical(reader, points, (1, 0, 0), OPTIONS)):
        assert (np.abs(values - truth) < 4.5 * errors).all() and (errors < 0.05 * truth).all() and (errors > 0).all()


def test_mistakes(lamp):
    with pytest.raises(KalosError, match="points: an array of shape .*expected finite coordinates"):
        cylindrical(lamp, [1, 2, 3], OPTIONS)
    with pytest.raises(KalosError, match="directions: .* has no horizontal part, expected directions to look into"):
        semicylindrical(lamp, [(1, 2, 3)], (0, 0, 1), OPTIONS)
