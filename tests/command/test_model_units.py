# SPDX-License-Identifier: BSD-3-Clause
"""--unit and --up: what a model's file does not say."""
import json

import numpy as np
import pytest
from conftest import one_line

ROOM = "".join(f"v {x} {y} {z}\n" for x, y, z in [(0, 0, 0), (4000, 0, 0), (4000, 0, 3000), (0, 0, 3000)])


@pytest.fixture
def model(tmp_path):
    """A floor of 4 x 3 m in millimetres with y up, and a lamp on it that shines up."""
    (tmp_path / "room.mtl").write_text("newmtl lamp\nKd 0 0 0\nKe 100 100 100\n")
    path = tmp_path / "room.obj"
    path.write_text("mtllib room.mtl\n" + ROOM + "usemtl lamp\nf 4 3 2 1\nv 0 3000 0\nv 1 3000 0\nv 0 3000 1\nf 5 6 7\n")
    return path


def test_a_room_in_millimetres(model, command, tmp_path):
    status, out, error = command("solve", model, "--out", tmp_path / "out", "--unit", "mm", "--up", "y", "--trajectories", 64)
    assert status == 0, error
    rows = np.loadtxt(tmp_path / "out" / "workplane.csv", delimiter=",", skiprows=1)
    assert rows[:, 0].max() < 4 and np.abs(rows[:, 1]).max() < 3 and np.allclose(rows[:, 2], 0.75)
    assert not any(line["subject"] in ("unit", "axes") for line in json.loads((tmp_path / "out" / "summary.json").read_text())["audit"])


@pytest.mark.parametrize("options, message", [
    (["--unit", "mm"], "scene.json: --unit: a scene file says so itself, by \"scale\" and \"up\" beside \"file\"; expected a model"),
    (["--up", "y"], "scene.json: --up: a scene file says so itself"), (["--unit", "mile"], "--unit: invalid choice: 'mile'"),
    (["--up", "x"], "--up: invalid choice: 'x'")])
def test_where_they_do_not_belong(scene, command, tmp_path, options, message):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", *options)
    assert status == 2 and message in one_line(error[error.index("kalos: error"):])
