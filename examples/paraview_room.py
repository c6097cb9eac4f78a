# SPDX-License-Identifier: BSD-3-Clause
"""The Cornell room in ParaView: lux on all of its surfaces, in three dimensions.

    pvpython examples/paraview_room.py room.png [--trajectories N] [--edge-length M] [--plugin Kalos.so]

On a machine without a screen put xvfb-run in front. In the ParaView window, load the plugin and run the script from
Tools > Python Shell; the pipeline stays there to be clicked on.
"""
from __future__ import annotations

import argparse
import glob
import os
import sys

import paraview.simple as pv

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))


def plugin_path() -> str:
    found = glob.glob(os.path.join(ROOT, "build", "lib", "paraview-*", "plugins", "Kalos", "Kalos.so"))
    if not found:
        sys.exit("paraview_room.py: no Kalos.so below build/; build Kalos first or give --plugin")
    return found[0]


def main() -> None:
    parser = argparse.ArgumentParser(description="Show the surfaces of the Cornell room in lux.")
    parser.add_argument("picture", nargs="?", default="paraview-room.png", help="PNG to write")
    parser.add_argument("--scene", default=os.path.join(ROOT, "data", "cornell", "cornell.json"))
    parser.add_argument("--trajectories", type=int, default=4000)
    parser.add_argument("--edge-length", type=float, default=0.1, help="of the triangles that get a value each, m")
    parser.add_argument("--plugin", help="path of Kalos.so, if it is not below build/")
    options = parser.parse_args()
    pv.LoadPlugin(options.plugin or plugin_path(), remote=False, ns=pv.__dict__)

    # Read the scene, cut its surfaces into triangles with a normal each, and make every one a receiver: with normals of
    # points, the points would be.
    scene = pv.KalosSceneReader(FileName=options.scene)
    surfaces, luminaires = pv.OutputPort(scene, 0), pv.OutputPort(scene, 1)
    triangles = pv.KalosSurfaceRemesh(Input=surfaces, EdgeLength=options.edge_length)
    sides = pv.GenerateSurfaceNormals(Input=pv.OutputPort(triangles, 0), ComputeCellNormals=1, Splitting=0, Consistency=0)
    receivers = pv.PassArrays(Input=sides, CellDataArrays=["Normals"])
    lux = pv.KalosIlluminance(Receivers=receivers, Surfaces=surfaces, Luminaires=luminaires, Method="Gathered",
                              Trajectories=options.trajectories)
    lux.UpdatePipeline()
    if lux.CellData.GetArray("Illuminance") is None:
        sys.exit("paraview_room.py: the solve failed; see the messages above")

    # Colour it with Kalos's own colour map, and look in from the front.
    pv.ImportPresets(filename=os.path.join(ROOT, "apps", "paraview", "kalos-presets.json"))
    view = pv.CreateRenderView(ViewSize=[720, 560], OrientationAxesVisibility=0, Background=[1, 1, 1])
    view.UseColorPaletteForBackground = 0
    display = pv.Show(lux, view)
    pv.ColorBy(display, ("CELLS", "Illuminance"))
    display.Ambient, display.Diffuse = 1, 0  # the colours are values, not shades
    colors = pv.GetColorTransferFunction("Illuminance")
    colors.ApplyPreset("Kalos illuminance (lx)", False)
    colors.RescaleTransferFunction(0, 250)
    bar = pv.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = "Illuminance", "lx"
    bar.RangeLabelFormat = "%.0f"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.87, 0.2], 0.6
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [2.9, -6.4, 2.5], [2.9, 2.5, 2.5], [0, 0, 1]
    view.CameraViewAngle = 46
    pv.SaveScreenshot(options.picture, view, CompressionLevel="9")
    print(options.picture)


main()
