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

# The macro: an image looks from where the view looks, and lux has its colours.
import paraview.simple as pv  # noqa: E402

scene = pv.OpenDataFile(os.path.join(source, "data", "cornell", "cornell-empty.json"))
image = pv.KalosLuminanceImage(Surfaces=pv.OutputPort(scene, 0), Luminaires=pv.OutputPort(scene, 1), Trajectories=64, Resolution=[8, 6])
view = pv.CreateView("RenderView", ViewSize=[400, 200], CameraPosition=[2.5, -6, 2.5], CameraFocalPoint=[2.5, 2.5, 2], CameraViewAngle=40)
pv.SetActiveView(view)
pv.SetActiveSource(image)
os.environ["KALOS_PRESETS"] = os.path.join(source, "apps", "paraview", "kalos-presets.json")
runpy.run_path(os.path.join(source, "apps", "paraview", "macros", "kalos_image_from_view.py"))
assert list(image.Position) == [2.5, -6, 2.5] and list(image.Target) == [2.5, 2.5, 2] and image.FieldOfView == 40
assert list(image.Resolution) == [12, 6], image.Resolution
colors = pv.GetColorTransferFunction("Illuminance").RGBPoints
assert len(colors) > 100 and list(colors[1:4]) == [0.011765, 0.003922, 0.192157], colors[:4]
pv.SetActiveSource(scene)
try:
    runpy.run_path(os.path.join(source, "apps", "paraview", "macros", "kalos_image_from_view.py"))
except RuntimeError as error:
    assert "no Kalos Luminance Image" in str(error)
else:
    raise AssertionError("the macro took a source that is no image")
