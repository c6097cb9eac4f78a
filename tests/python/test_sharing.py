# SPDX-License-Identifier: BSD-3-Clause
"""Scenes from arrays that belong to VTK, and the same piece listed twice: no memory is used after it was freed.

What VTK's wrapping damages shows as a crash or a hang of the interpreter, so every case runs in one of its own.
"""
import subprocess
import sys

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray

from kalos.core.sharing import of_vtk, shared

CASES = {
    "the same luminaire twice": "illuminance(room, [lamp, lamp], desk)",
    "the same luminaire three times": "illuminance(room, (lamp, lamp, lamp), desk)",
    "the same surface twice": "illuminance([room, desktop, desktop], lamp, desk)",
    "points that are VTK's": "illuminance(room, lamp, vtk_to_numpy(room.GetPoints().GetData()))",
    "points of a result": "illuminance(room, lamp, vtk_to_numpy(illuminance(room, lamp, desk).vtk.GetPoints().GetData()))",
    "vertices that are VTK's": "illuminance(kalos.surface(vtk_to_numpy(room.GetPoints().GetData()), faces, 0.5), lamp, desk)",
    "reflectances that are VTK's": "illuminance(kalos.surface(corners, faces, vtk_to_numpy(rho(room))), lamp, desk)",
    "flux that is VTK's": "illuminance(room, kalos.luminaire((2, 2, 2.9), vtk_to_numpy(lamp.GetPointData().GetArray(0))), desk)",
}
PROGRAM = """
import gc, numpy as np, kalos
from vtkmodules.util.numpy_support import vtk_to_numpy
def illuminance(surfaces, luminaires, points):
    return kalos.illuminance(surfaces, luminaires, points, (0, 0, 1), trajectories=32, threads=1)
def rho(surface):
    return surface.GetCellData().GetArray("Reflectance")
desk = np.array([[1.0, 2.0, 0.75], [2.0, 2.0, 0.75]])
faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
for _ in range(10):
    room = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
    desktop = kalos.quad((1, 1, 0.7), (1, 0, 0), (0, 1, 0), 0.5)
    lamp = kalos.luminaire((2, 2, 2.9), 3000)
    corners = np.array([room.GetPoint(i) for i in range(8)])
    found = {case}
    assert np.isfinite(found.illuminance).all() and found.illuminance.max() > 0
    del room, lamp, found
    gc.collect()
print("whole")
"""


@pytest.mark.parametrize("case", CASES)
def test_memory_survives(case):
    ran = subprocess.run([sys.executable, "-c", PROGRAM.replace("{case}", CASES[case])], capture_output=True, text=True, timeout=60,
                         check=False)
    assert ran.stdout == "whole\n", f"{ran.returncode}: {ran.stderr[-500:]}"


def test_twice_is_double():
    import kalos

    room, lamp = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True), kalos.luminaire((2, 2, 2.9), 3000)
    points = np.array([[1.0, 2.0, 0.75]])
    once, twice = (kalos.illuminance(room, lamps, points, (0, 0, 1), trajectories=4096) for lamps in (lamp, [lamp, lamp]))
    error = np.hypot(2 * once.standard_error, twice.standard_error)
    assert abs(twice.illuminance - 2 * once.illuminance)[0] < 6 * error[0] < 0.05 * twice.illuminance[0]


def test_who_owns_the_memory():
    own, array = np.ones(4), vtkDoubleArray()
    array.SetNumberOfTuples(4)
    view = vtk_to_numpy(array)
    assert [of_vtk(values) for values in (own, own[1:], own.reshape(2, 2), view, view.reshape(2, 2), view[1:], view.copy())] == \
        [False, False, False, True, True, True, False]
    assert vtk_to_numpy(shared(own)).__array_interface__["data"] == own.__array_interface__["data"]
    assert vtk_to_numpy(shared(view)).__array_interface__["data"] != view.__array_interface__["data"]
    assert of_vtk(vtk_to_numpy(numpy_to_vtk(own)))
