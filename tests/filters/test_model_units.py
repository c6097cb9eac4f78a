# SPDX-License-Identifier: BSD-3-Clause
"""Models without a unit, an upward axis or light."""
import numpy as np
import pytest

from helpers import minimal_scene, update_error, write_scene
from models import corners, notes, read, reasons
from kalos.vtk import vtkKalosSceneReader


def room(x, y, z):
    """The floor of a room and a wall, lengths as written."""
    return (f"v 0 0 0\nv {x} 0 0\nv {x} {y} 0\nv 0 {y} 0\nv 0 0 {z}\nv {x} 0 {z}\nf 1 2 3 4\nf 1 2 6 5\n")


@pytest.mark.parametrize("size, told", [
    ((5, 4, 2.7), None), ((5000, 4000, 2700), "larger than buildings: expected --unit mm"),
    ((500, 400, 270), "larger than buildings"), ((300, 200, 60), None), ((0.005, 0.004, 0.0027), "smaller than furniture"),
    ((200000, 200000, 50), "larger than buildings")])
def test_the_unit(tmp_path, size, told):
    (tmp_path / "room.obj").write_text(room(*size))
    found = reasons(read(tmp_path / "room.obj"))
    assert ("unit" in found) == (told is not None)
    assert told is None or told in found["unit"]


@pytest.mark.parametrize("size, told", [((5, 4, 2.7), False), ((5, 2.7, 4), True), ((5, 2.7, 2.8), False), ((2, 4, 2.7), False)])
def test_the_axis_that_is_up(tmp_path, size, told):
    (tmp_path / "room.obj").write_text(room(*size))
    assert ("if it was made with y up" in reasons(read(tmp_path / "room.obj"))["axes"]) == told


def test_unit_and_axis_of_a_model_as_the_file(tmp_path):
    (tmp_path / "room.obj").write_text(room(5000, 2700, 4000))
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(tmp_path / "room.obj"))
    reader.SetModelUnit(0.001)
    reader.SetModelUp("y")
    assert update_error(reader) is None
    np.testing.assert_allclose(np.ptp(corners(reader), axis=0), (5, 4, 2.7))
    assert not {"unit", "axes"} & set(notes(reader))
    reader.SetModelUp("x")
    assert 'surfaces[0].up: found "x"; expected "y" or "z"' in update_error(reader)
    reader.SetModelUp("z")
    reader.SetModelUnit(0)
    assert "surfaces[0].scale: found 0" in update_error(reader)


def test_a_scene_without_light_says_so(tmp_path):
    scene = minimal_scene()
    assert "warning" not in reasons(read(write_scene(tmp_path, scene)))
    scene["luminaires"][0]["flux"] = 0
    assert reasons(read(write_scene(tmp_path, scene)))["warning"].endswith("every value is 0")
    scene["materials"]["white"]["exitance"] = 10
    assert "warning" not in reasons(read(write_scene(tmp_path, scene)))
