# SPDX-License-Identifier: BSD-3-Clause
"""How pictures lay things out: frames of planes, colour scales, what an axonometric drawing shows."""
import numpy as np
import pytest

from kalos.pictures.axonometry import seen_cells
from kalos.pictures.colours import false_colours
from kalos.pictures.projection import flat_frame
from kalos.pictures.scale import colour_scale, round_up
from kalos.results.statistics import statistics
from kalos.results.text import number


def frame(corners, normal):
    points = np.array(corners, float)
    return flat_frame(points, np.tile(np.array(normal, float), (len(points), 1)))


def test_floor_and_ceiling_are_plans_from_above():
    corners = [(0, 0, 3), (5, 0, 3), (5, 4, 3)]
    for normal in ((0, 0, 1), (0, 0, -1)):
        plan = frame(corners, normal)
        np.testing.assert_allclose(plan.project(np.array([(5.0, 4, 3)])), [[5, 4]])
        assert (plan.right_label, plan.up_label, plan.right_inverted) == ("x, m", "y, m", False)


def test_walls_are_seen_from_their_front():
    left = frame([(0, 0, 0), (0, 5, 0), (0, 5, 3)], (1, 0, 0))
    assert (left.right_label, left.up_label, left.right_inverted) == ("y, m", "z, m", False)
    right = frame([(5, 0, 0), (5, 5, 0), (5, 5, 3)], (-1, 0, 0))
    assert (right.right_label, right.right_inverted) == ("y, m", True)
    np.testing.assert_allclose(right.project(np.array([(5.0, 2, 1)])), [[2, 1]])


def test_oblique_plane_is_measured_from_its_corner():
    normal = np.array([1, 1, 0]) / np.sqrt(2)
    oblique = frame([(1, 0, 0), (0, 1, 0), (0, 1, 2)], normal)
    np.testing.assert_allclose(oblique.project(np.array([(1.0, 0, 0), (0, 1, 2)]))[:, 1], [0, 2], atol=1e-12)
    assert oblique.right_label == "along, m"


def test_anything_else_is_not_flat():
    assert frame([(0, 0, 0), (1, 0, 0), (0, 1, 1)], (0, 0, 1)) is None
    assert flat_frame(np.zeros((2, 3)), np.array([(0, 0, 1.0), (1, 0, 0)])) is None


def test_scale_ends_at_a_round_number_and_cuts_spikes():
    assert [round_up(x) for x in (0, 0.013, 88, 100, 101, 700)] == pytest.approx([1, 0.015, 100, 100, 120, 800])
    smooth = np.linspace(0, 88, 1000)
    assert (colour_scale(smooth).norm.vmax, colour_scale(smooth).cut) == (100, "neither")
    spiky = smooth.copy()
    spiky[0] = 1e5
    assert (colour_scale(spiky).norm.vmax, colour_scale(spiky).cut) == (100, "max")


def test_colours_run_from_dark_to_light():
    colours = np.array([false_colours()(i)[:3] for i in range(256)])
    luminance = colours**2.2 @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(luminance) > -1e-3).all() and luminance[0] < 0.02 and luminance[-1] > 0.8


def test_axonometry_leaves_out_backs_and_draws_far_cells_first():
    cell = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0)], float)
    polygons = [cell, cell + [0, 5, 0], cell]
    normals = np.array([(0, 0, 1.0), (0, 0, 1), (0, 0, -1)])
    assert seen_cells(polygons, normals).tolist() == [1, 0]  # the camera is in front, at negative y


def test_statistics():
    figures = statistics(np.array([1.0, 2, 3]), np.array([0.1, 0.1, 0.6]))
    assert figures["mean"] == 2 and figures["U0"] == 0.5 and figures["Ud"] == pytest.approx(1 / 3)
    assert figures["largest_relative_standard_error"] == pytest.approx(0.2)
    dark = statistics(np.zeros(3), np.zeros(3))
    assert (dark["U0"], dark["Ud"], dark["largest_relative_standard_error"]) == (None, None, 0)
    assert statistics(np.zeros(3), np.ones(3))["largest_relative_standard_error"] is None
    assert statistics(np.array([1.0, 4]), np.zeros(2), weights=[3, 1])["mean"] == 1.75


def test_numbers():
    assert [number(x) for x in (None, 0, 0.5, 123.456, 98765.4, 1e7, 1e-6)] == [
        "-", "0", "0.5000", "123.5", "98765", "1.000e+07", "1.000e-06"]
