# SPDX-License-Identifier: BSD-3-Clause
"""Show the floor of the Cornell room in lux.

    pvpython apps/paraview/cornell_floor.py floor.png [--trajectories N] [--plugin Kalos.so]

On a machine without a screen put xvfb-run in front. In the ParaView window, load the plugin and run the script from
Tools > Python Shell.
"""
import argparse
import glob
import os
import sys

import paraview.simple as pv

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))


def plugin_path():
    found = glob.glob(os.path.join(ROOT, "build", "lib", "paraview-*", "plugins", "Kalos", "Kalos.so"))
    if not found:
        sys.exit("cornell_floor.py: no Kalos.so below build/; build Kalos first or give --plugin")
    return found[0]


def main():
    parser = argparse.ArgumentParser(description="Show the floor of the Cornell room in lux.")
    parser.add_argument("picture", nargs="?", default="cornell-floor.png", help="PNG to write")
    parser.add_argument("--scene", default=os.path.join(ROOT, "data", "cornell", "cornell.json"))
    parser.add_argument("--trajectories", type=int, default=20000)
    parser.add_argument("--plugin", help="path of Kalos.so, if it is not below build/")
    options = parser.parse_args()
    pv.LoadPlugin(options.plugin or plugin_path(), remote=False, ns=pv.__dict__)

    # Read the scene, take its surfaces and luminaires, and put receivers on the floor.
    scene = pv.KalosSceneReader(FileName=options.scene)
    floor = pv.KalosCalculationPlane(Originm=[0, 0, 0], Um=[5, 0, 0], Vm=[0, 5, 0], Resolution=[64, 64])
    lux = pv.KalosIlluminance(
        Receivers=floor, Surfaces=pv.OutputPort(scene, 0), Luminaires=pv.OutputPort(scene, 1))
    lux.Trajectories = options.trajectories
    lux.UpdatePipeline()
    if lux.CellData.GetArray("Illuminance") is None:
        sys.exit("cornell_floor.py: the solve failed; see the messages above")

    # Colour it, with a legend in lx.
    view = pv.CreateRenderView(ViewSize=[900, 700], OrientationAxesVisibility=0, Background=[1, 1, 1])
    view.UseColorPaletteForBackground = 0
    display = pv.Show(lux, view)
    pv.ColorBy(display, ("CELLS", "Illuminance"))
    display.Ambient, display.Diffuse = 1, 0  # the colours are values, not shades
    colors = pv.GetColorTransferFunction("Illuminance")
    colors.ApplyPreset("Inferno (matplotlib)", True)
    colors.RescaleTransferFunction(*lux.CellData.GetArray("Illuminance").GetRange())
    bar = pv.GetScalarBar(colors, view)
    bar.Title = "Illuminance"
    bar.ComponentTitle = "lx"
    bar.RangeLabelFormat = "%.0f"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.88, 0.2], 0.6
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [2.9, 2.5, 12], [2.9, 2.5, 0], [0, 1, 0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 2.8
    pv.SaveScreenshot(options.picture, view)
    print(options.picture)


main()
