# SPDX-License-Identifier: BSD-3-Clause
"""Receivers inside solids, below surfaces and outside are marked, and statistics leave them out and say so."""
import csv
import itertools
import json

import numpy as np
import pytest
from matplotlib.image import imread

SIZE, SIDE = 4.0, 16  # m, cells a side
BOX = {"center": [1.4, 1.4, 0.5], "size": [0.8, 0.8, 1.0]}


def room():
    """A closed room with a box on its floor."""
    sides = [([0, 0, 0], [SIZE, 0, 0], [0, SIZE, 0]), ([0, 0, 3], [0, SIZE, 0], [SIZE, 0, 0]), ([0, 0, 0], [0, 0, 3], [SIZE, 0, 0]),
             ([0, SIZE, 0], [SIZE, 0, 0], [0, 0, 3]), ([0, 0, 0], [0, SIZE, 0], [0, 0, 3]), ([SIZE, 0, 0], [0, 0, 3], [0, SIZE, 0])]
    surfaces = [{"name": f"side{i}", "quad": dict(zip(("origin", "u", "v"), side)), "material": "grey"} for i, side in enumerate(sides)]
    return surfaces + [{"name": "box", "box": BOX, "material": "grey"}]


@pytest.fixture
def solve(scene, command, tmp_path):
    """Solves planes at heights z in the room, its surfaces in the order given: summary, output and tables by name."""

    def run(planes, *options, order=lambda surfaces: surfaces, cameras=()):
        scene["surfaces"] = order(room())
        scene["cameras"] = list(cameras)
        scene["receivers"] = [{"name": name, "plane": {"origin": [x, 0, z], "u": [SIZE, 0, 0], "v": [0, SIZE, 0],
                                                       "resolution": [SIDE, SIDE]}} for name, (x, z) in planes.items()]
        status, out, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, *options)
        assert status == 0, error
        tables = {name: list(csv.DictReader((tmp_path / "out" / f"{name}.csv").open())) for name in planes}
        return json.loads((tmp_path / "out" / "summary.json").read_text()), out, error, tables

    return run


def in_box(table):
    low, high = (np.array(BOX["center"]) + sign * np.array(BOX["size"]) / 2 for sign in (-1, 1))
    points = np.array([[float(row[axis]) for axis in "xyz"] for row in table])
    return ((points > low) & (points < high))[:, :2].all(axis=1)


def column(table, name):
    return np.array([float(row[name]) for row in table])


def test_points_in_a_solid_are_left_out(solve):
    summary, out, error, tables = solve({"desk": (0, 0.75), "floor": (0, 0.0)})
    for name, table in tables.items():
        inside, valid = in_box(table), column(table, "valid")
        assert inside.sum() == 9  # cells of 0.25 m whose centres are in the box: 1.125, 1.375, 1.625
        np.testing.assert_array_equal(valid, ~inside)
        values, figures = column(table, "illuminance_lx"), summary["receivers"][name]
        assert (values[inside] == 0).all() and np.isfinite(values).all()
        assert figures["points"] == SIDE**2 and figures["left_out"] == 9
        for key, value in (("mean", values[~inside].mean()), ("min", values[~inside].min())):
            np.testing.assert_allclose(figures[key], value, rtol=1e-12)
        assert figures["U0"] > 0.1
        assert f"9 of 256 points of {name} are left out: inside a solid, below a surface or outside" in out
    assert summary["warnings"]["count"] == 1 and summary["warnings"]["codes"] == {"audit": 1}
    assert "receivers with nothing lit in sight: 18" in summary["warnings"]["list"][0]["message"]
    assert error.count("kalos: warning: ") == 1


def test_a_switch_counts_them(solve):
    summary, out, _, tables = solve({"desk": (0, 0.75)}, "--all-points")
    figures = summary["receivers"]["desk"]
    assert figures["min"] == 0 and figures["U0"] == 0 and figures["left_out"] == 0 and "left out" not in out.split("result of")[1]
    np.testing.assert_allclose(figures["mean"], column(tables["desk"], "illuminance_lx").mean(), rtol=1e-12)


@pytest.mark.parametrize("place, left_out", [((0, 0.75), 9), ((0, -0.01), 256), ((0, 3.01), 256), ((9, 0.75), 256), ((0, 1.5), 0),
                                             ((2, 0.75), 128)])
def test_places(solve, place, left_out):
    """In a solid, below the floor, above the ceiling, beside the room, in free air, across a wall; (x, z) of the plane."""
    summary, _, _, tables = solve({"desk": place})
    assert summary["receivers"]["desk"]["left_out"] == left_out == (column(tables["desk"], "valid") == 0).sum()
    assert summary["warnings"]["count"] == (left_out > 0)
    if left_out == 256:
        assert summary["receivers"]["desk"]["mean"] is None


def test_the_order_of_surfaces_does_not_matter(solve):
    masks = [column(solve({"desk": (0, 0.75)}, order=order)[3]["desk"], "valid")
             for order in (lambda s: s, lambda s: s[::-1], lambda s: s[3:] + s[:3])]
    for one, other in itertools.pairwise(masks):
        np.testing.assert_array_equal(one, other)


def test_pictures_show_them_grey(solve, tmp_path):
    solve({"desk": (0, 0.75)}, "--report")
    pixels = imread(tmp_path / "out" / "desk.png")[..., :3]
    grey = np.abs(pixels - 0.8).max(axis=-1) < 0.01
    assert 0.01 < grey.mean() < 0.05  # 9 of 256 cells of the map
    assert "grey in the pictures" in (tmp_path / "out" / "report.html").read_text()


def test_warnings_count_beside_a_camera_that_has_none(solve):
    camera = {"name": "eye", "position": [3, 3, 1], "target": [2, 0.5, 1.2], "up": [0, 0, 1], "fov_deg": 40, "resolution": [8, 8]}
    summary, _, error, _ = solve({"desk": (0, 0.75)}, cameras=[camera])
    assert summary["warnings"]["count"] == 1 and error.count("receivers with nothing lit in sight: 9") == 1


@pytest.mark.parametrize("position, warned", [([1.4, 1.4, 0.5], 1), ([9, 9, 1], 1), ([3, 3, 1], 0)])
def test_cameras_in_solids_and_outside(solve, position, warned):
    camera = {"name": "eye", "position": position, "target": [2, 0.5, 1.2], "up": [0, 0, 1], "fov_deg": 40, "resolution": [8, 8]}
    summary, _, error, _ = solve({"desk": (0, 1.5)}, cameras=[camera])
    assert summary["warnings"]["count"] == warned and error.count("the image is black") == warned
