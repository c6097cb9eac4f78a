# SPDX-License-Identifier: BSD-3-Clause
"""The example script draws the room, lit differently from place to place.

    pvpython test_paraview_room.py Kalos.so SOURCE_DIRECTORY PICTURE
"""
import os
import runpy
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

plugin, source, picture = sys.argv[1:4]
if os.path.exists(picture):
    os.remove(picture)
script = os.path.join(source, "examples", "paraview_room.py")
sys.argv = [script, picture, "--plugin", plugin, "--trajectories", "320", "--edge-length", "0.5"]
runpy.run_path(script, run_name="__main__")

reader = vtkPNGReader()
reader.SetFileName(picture)
reader.Update()
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
colors = {tuple(pixel) for pixel in pixels.tolist()}
white = (pixels == 255).all(axis=1).mean()
assert len(colors) > 50, f"{len(colors)} colours: the room has not been drawn"
assert 0.1 < white < 0.7, f"{white:.0%} of the picture is background"
print(f"{len(colors)} colours, {white:.0%} background")
