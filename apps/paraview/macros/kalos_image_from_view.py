# SPDX-License-Identifier: BSD-3-Clause
"""Macro for ParaView's window: the active Kalos Luminance Image looks from where the active view looks.

Macros > Import new macro gives it a button. What is coloured by illuminance or luminance gets Kalos's colours.
"""
import os

import paraview.simple as pv

PRESETS = {"Illuminance": "Kalos illuminance (lx)", "Luminance": "Kalos luminance (cd/m2, logarithmic)"}


def look_from(image, view):
    """Position, target, direction upwards and field of view of the camera, and the shape of the view."""
    camera = view.GetActiveCamera()
    image.Position, image.Target, image.Up = camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()
    image.FieldOfView = camera.GetViewAngle()
    rows = image.Resolution[1]
    image.Resolution = [max(1, round(rows * view.ViewSize[0] / view.ViewSize[1])), rows]


def colour(presets):
    """Gives the arrays that results are coloured by their colour maps, as far as these are known or can be found."""
    if os.path.isfile(presets):
        pv.ImportPresets(filename=presets)
    for array, preset in PRESETS.items():
        try:
            pv.GetColorTransferFunction(array).ApplyPreset(preset, True)
        except RuntimeError:  # the presets were not found
            return


image, view = pv.GetActiveSource(), pv.GetActiveView()
if image is None or image.GetXMLName() != "KalosLuminanceImage":
    raise RuntimeError("kalos_image_from_view: the active source is no Kalos Luminance Image; choose one in the pipeline browser")
look_from(image, view)
colour(os.environ.get("KALOS_PRESETS", ""))
