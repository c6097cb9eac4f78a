# SPDX-License-Identifier: BSD-3-Clause
"""Distances to concave edges, and what pixels see, against what one works out by hand."""
from pathlib import Path

import numpy as np
import pytest

from kalos.scenes.clearance import clearance, triangles
from kalos.scenes.reading import read_scene
from kalos.scenes.sight import camera_rays, first_hits

CORNELL = Path(__file__).resolve().parents[2] / "data" / "cornell" / "cornell.json"
UP, X = (0, 0, 1), (1, 0, 0)


@pytest.fixture(scope="module")
def faces():
    return triangles(read_scene(CORNELL).GetOutputDataObject(0))


@pytest.mark.parametrize("point, normal, expected", [
    ((0.1, 2.5, 0), UP, 0.1),  # beside the left wall
    ((0.05, 4.97, 0), UP, 0.03),  # in a corner
    ((1, 0.3, 0), UP, 1),  # the open front does not count
    ((0, 2.5, 0.04), X, 0.04),  # on the wall, above the floor
    ((3.3, 1.7, 1.5), UP, None),  # on top of the short box: nothing near, its convex edges do not count
    ((0, 2.9, 1.5), X, 1.7 * np.cos(np.radians(17)) + 0.3 * np.sin(np.radians(17)) - 0.75),  # before the tall box
    ((3.3 + 0.95 * np.cos(np.radians(-17)), 1.7 + 0.95 * np.sin(np.radians(-17)), 0), UP, 0.2)])  # off the short box
def test_clearance(faces, point, normal, expected):
    found, = clearance(np.array([point], float), np.array([normal], float), faces)
    assert found == pytest.approx(expected, abs=1e-5) if expected else found > 0.75


def test_clearance_is_the_nearest_of_many_points_in_front(faces):
    """Against a dense sample of all faces; seed 1."""
    rng = np.random.default_rng(1)
    weights = rng.dirichlet((1, 1, 1), size=(len(faces), 20000))
    sample = np.einsum("fnk,fkx->fnx", weights, faces).reshape(-1, 3)
    points = rng.uniform(0, 5, (20, 3)) * (1, 1, 0)
    found = clearance(points, np.tile([0.0, 0, 1], (20, 1)), faces)
    in_front = sample[sample[:, 2] > 1e-5]
    nearest = np.linalg.norm(points[:, None] - in_front, axis=2).min(axis=1)
    assert (found <= nearest + 1e-9).all()
    np.testing.assert_allclose(found, nearest, atol=0.06)


def test_pixels_see_the_nearest_surface(faces):
    rays = camera_rays((2.5, -6.2, 2.5), (2.5, 2.5, 2.5), (0, 0, 1), 45, (8, 8))
    points, normals = (hits.reshape(8, 8, 3) for hits in first_hits((2.5, -6.2, 2.5), rays, faces))
    np.testing.assert_allclose(np.linalg.norm(normals, axis=2), 1, atol=1e-12)
    assert ((normals.reshape(-1, 3) * rays).sum(axis=1) < 0).all()
    np.testing.assert_allclose(normals[4, [0, 7]], [(1, 0, 0), (-1, 0, 0)], atol=1e-12)  # the red wall, the green one
    np.testing.assert_allclose(points[4, [0, 7], 0], [0, 5], atol=1e-12)
    np.testing.assert_allclose(points[[0, 7], 4, 2], [0, 5], atol=1e-12)  # the floor is at the bottom
    outside, _ = first_hits((2.5, -6.2, 2.5), -rays, faces)
    assert np.isnan(outside).all()
