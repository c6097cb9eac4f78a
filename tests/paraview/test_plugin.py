# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in pvpython: every proxy can be made, is documented and sits in the menu; data flow through them.

    pvpython test_plugin.py Kalos.so SOURCE_DIRECTORY
"""
import os
import re
import sys
import tempfile
import unittest

import paraview.simple as pv
from paraview import servermanager

import kalos.vtk  # so that objects of the plugin show their methods, and as pvpython scripts may do

PLUGIN, SOURCE = sys.argv[1:3]
XMLS = os.path.join(SOURCE, "apps", "paraview", "xmls")
pv.LoadPlugin(PLUGIN, remote=False, ns=pv.__dict__)

# Stem of each XML and the group of its proxy.
STEMS = {"CalculationPlane": "sources", "LuminaireSource": "sources", "SceneReader": "sources", "EXRReader": "sources",
         "PhotometryReader": "sources", "MeshReader": "sources",
         "EXRWriter": "writers", "HDRWriter": "writers", "GlareRating": "filters", "FalseColor": "filters", "Illuminance": "filters", "LuminanceImage": "filters",
         "SurfaceRepair": "filters", "SurfaceRemesh": "filters", "SingularEdges": "filters"}


def new_proxy(stem):
    manager = servermanager.ProxyManager().SMProxyManager
    return manager.NewProxy(STEMS[stem], "Kalos" + stem)


class Plugin(unittest.TestCase):
    def test_every_xml_is_tested(self):
        self.assertEqual({name[:-4] for name in os.listdir(XMLS)}, set(STEMS))

    def test_every_proxy_is_there_and_documented(self):
        for stem in STEMS:
            with self.subTest(stem):
                proxy = new_proxy(stem)
                self.assertIsNotNone(proxy)
                self.assertEqual(proxy.GetVTKClassName(), "vtkKalos" + stem)
                proxy.UpdateVTKObjects()
                self.assertTrue(proxy.GetClientSideObject().IsA("vtkKalos" + stem))
                self.assertGreater(len(proxy.GetDocumentation().GetDescription()), 40)
                properties = proxy.NewPropertyIterator()
                while not properties.IsAtEnd():
                    documentation = properties.GetProperty().GetDocumentation()
                    self.assertTrue(documentation and documentation.GetDescription(), properties.GetKey())
                    properties.Next()

    def test_every_command_is_a_method(self):
        for stem in STEMS:
            proxy = new_proxy(stem)
            proxy.UpdateVTKObjects()
            with open(os.path.join(XMLS, stem + ".xml"), encoding="utf-8") as file:
                commands = set(re.findall(r'command="(\w+)"', file.read()))
            for command in commands:
                self.assertTrue(hasattr(proxy.GetClientSideObject(), command), f"{stem}.{command}")

    def test_defaults_are_those_of_the_classes(self):
        for stem in STEMS:
            proxy = new_proxy(stem)
            untouched = getattr(kalos.vtk, "vtkKalos" + stem)()
            proxy.UpdateVTKObjects()
            with open(os.path.join(XMLS, stem + ".xml"), encoding="utf-8") as file:
                names = re.findall(r'command="Set(\w+)"', file.read())
            # A plane is in single precision here, so that Plot Over Line finds it.
            for name in set(names) - {"InputConnection", "OutputPointsPrecision"}:
                get = "Get" + name
                self.assertEqual(getattr(proxy.GetClientSideObject(), get)() or None, getattr(untouched, get)() or None,
                                 f"{stem}.{name}")

    def test_all_are_in_the_menu_category(self):
        for stem, group in STEMS.items():
            with open(os.path.join(XMLS, stem + ".xml"), encoding="utf-8") as file:
                text = file.read()
            self.assertIn("WriterFactory" if group == "writers" else 'ShowInMenu category="Kalos"', text, stem)

    def test_panels_have_a_widget_for_every_property(self):
        for stem in STEMS:
            with open(os.path.join(XMLS, stem + ".xml"), encoding="utf-8") as file:
                self.assertNotIn("IdTypeVectorProperty", file.read(), f"{stem}: ParaView's panel leaves such a property out")

    def test_line_over_a_plane_at_any_height_is_full(self):
        for height in (0, 0.001, 0.75, 0.8):
            plane = pv.KalosCalculationPlane(Originm=[0, 0, height], Um=[5, 0, 0], Vm=[0, 4, 0])
            plane.UpdatePipeline()
            line = pv.PlotOverLine(Input=plane, Point1=[0, 0, height], Point2=[5, 4, height], Resolution=100)
            line.UpdatePipeline()
            mask = servermanager.Fetch(line).GetPointData().GetArray("vtkValidPointMask")
            found = sum(int(mask.GetTuple1(i)) for i in range(mask.GetNumberOfTuples()))
            self.assertEqual(found, 101, f"a plane at {height} m")

    def test_models_in_millimetres_with_y_up(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "quad.obj")
            with open(path, "w", encoding="utf-8") as file:
                file.write("v 0 0 0\nv 2000 0 0\nv 2000 1000 0\nv 0 1000 0\nf 1 2 3 4\n")
            reader = pv.KalosSceneReader(FileName=path, ModelUnitm=0.001, ModelUp="y")
            bounds = reader.GetDataInformation(0).GetBounds() if not reader.UpdatePipeline() else None
            for found, expected in zip(bounds, (0, 2, 0, 0, 0, 1)):
                self.assertAlmostEqual(found, expected, places=6)
            mesh = pv.KalosMeshReader(FileName=path)
            mesh.UpdatePipeline()
            self.assertAlmostEqual(mesh.GetDataInformation().GetBounds()[1], 2000)

    def test_scene_lux_colours_and_exr(self):
        scene = pv.OpenDataFile(os.path.join(SOURCE, "data", "cornell", "cornell.json"))
        self.assertEqual(scene.GetXMLName(), "KalosSceneReader")
        surfaces, luminaires, receivers = (pv.OutputPort(scene, i) for i in range(3))
        lux = pv.KalosIlluminance(Receivers=receivers, Surfaces=surfaces, Luminaires=luminaires, Trajectories=64)
        colors = pv.KalosFalseColor(Input=lux, ArrayName="Illuminance")
        colors.UpdatePipeline()
        self.assertIn("FalseColor", colors.CellData.keys())
        view = pv.KalosLuminanceImage(Surfaces=surfaces, Luminaires=luminaires, Trajectories=64, Resolution=[8, 6],
                                      Positionm=[2.5, -6, 2.5], Targetm=[2.5, 2.5, 2.5])
        view.UpdatePipeline()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "front.exr")
            pv.SaveData(path, proxy=view)
            image = pv.OpenDataFile(path)
            self.assertEqual(image.GetXMLName(), "KalosEXRReader")
            image.UpdatePipeline()
            self.assertIn("Luminance", image.PointData.keys())
            self.assertGreater(image.PointData["Luminance"].GetRange()[1], 0)


unittest.main(argv=sys.argv[:1])
