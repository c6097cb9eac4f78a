# SPDX-License-Identifier: BSD-3-Clause
"""What a session leaves and needs: states that reload, files that open by their names, presets of colours.

    pvpython test_session.py Kalos.so SOURCE_DIRECTORY
"""
import json
import os
import sys
import tempfile
import unittest

import numpy as np
import paraview.simple as pv
from paraview import servermanager

import kalos

PLUGIN, SOURCE = sys.argv[1:3]
PRESETS = os.path.join(SOURCE, "apps", "paraview", "kalos-presets.json")
pv.LoadPlugin(PLUGIN, remote=False, ns=pv.__dict__)


def pipeline():
    scene = pv.OpenDataFile(os.path.join(SOURCE, "data", "cornell", "cornell-empty.json"))
    plane = pv.KalosCalculationPlane(Origin=[0, 0, 0.75], U=[5, 0, 0], V=[0, 5, 0], Resolution=[6, 5])
    lux = pv.KalosIlluminance(registrationName="lux", Receivers=plane, Surfaces=pv.OutputPort(scene, 0),
                              Luminaires=pv.OutputPort(scene, 1), Trajectories=320, Seed=7, Method="Local estimation")
    lux.UpdatePipeline()
    return lux


class Session(unittest.TestCase):
    def test_a_state_reloads_with_the_same_numbers(self):
        before = pipeline().CellData["Illuminance"].GetRange()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "room.pvsm")
            pv.SaveState(path)
            pv.ResetSession()
            self.assertIsNone(pv.FindSource("lux"))
            pv.LoadState(path)
        lux = pv.FindSource("lux")
        lux.UpdatePipeline()
        self.assertEqual((lux.Seed, lux.Trajectories, lux.Method), (7, 320, "Local estimation"))
        self.assertEqual(lux.CellData["Illuminance"].GetRange(), before)

    def test_readers_are_found_by_the_ending(self):
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        known = factory.GetSupportedFileTypes(servermanager.ActiveConnection.Session)
        for ending in ("*.kalos.json", "*.exr", "*.ies", "*.ldt"):
            self.assertIn(ending, known)

    def test_presets_are_the_false_colours_over_ranges_with_units(self):
        with open(PRESETS, encoding="ascii") as file:
            names = [preset["Name"] for preset in json.load(file)]
        self.assertEqual(names, ["Kalos illuminance (lx)", "Kalos luminance (cd/m2, logarithmic)"])
        self.assertTrue(pv.ImportPresets(filename=PRESETS))
        table = kalos.vtkKalosFalseColor().GetLookupTable()
        for name, quantity, ends in zip(names, ("Illuminance", "Luminance"), ((0, 1000), (1, 10000))):
            colours = pv.GetColorTransferFunction(quantity)
            self.assertTrue(colours.ApplyPreset(name, False))
            points = np.array(colours.RGBPoints).reshape(-1, 4)
            self.assertEqual((points[0, 0], points[-1, 0]), ends)
            for share in np.linspace(0, 1, 256):
                value = ends[1] * share if quantity == "Illuminance" else ends[1] ** share
                shown = [np.interp(value if quantity == "Illuminance" else np.log(value),
                                   points[:, 0] if quantity == "Illuminance" else np.log(points[:, 0]), points[:, k])
                         for k in (1, 2, 3)]
                index = round(255 * share)
                self.assertLess(np.abs(np.subtract(shown, table.GetTableValue(index)[:3])).max(), 1e-5, (name, share))


unittest.main(argv=sys.argv[:1])
