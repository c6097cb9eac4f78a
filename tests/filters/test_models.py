# SPDX-License-Identifier: BSD-3-Clause
"""glTF models as scenes: geometry, names, receivers, and what a scene file around a model changes."""
import json

import numpy as np
import pytest
from gltf import SQUARE, Gltf, floor
from helpers import minimal_scene, write_scene
from models import blocks, cells, corners, names, normal, notes, read
from vtkmodules.util.numpy_support import vtk_to_numpy


@pytest.mark.parametrize("name", ["model.gltf", "model.glb"])
def test_y_up_becomes_z_up(tmp_path, name):
    gltf = floor()
    gltf.node(name="far", mesh=0, translation=[10, 2, 3])
    reader = read(gltf.save(tmp_path, name))
    assert names(reader) == ["floor", "far"]
    np.testing.assert_allclose(corners(reader)[:4], [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    np.testing.assert_allclose(corners(reader)[4], (9, -4, 2))
    np.testing.assert_allclose(normal(reader, 0), (0, 0, 1))
    assert notes(reader)["axes"] == "turned from y up to z up"


def test_transforms_multiply_and_mirrors_keep_the_side(tmp_path):
    gltf = floor()
    half = np.sqrt(0.5)
    child = gltf.node(root=False, name="child", mesh=0, translation=[1, 0, 0], scale=[-1, 1, 1])
    gltf.node(name="parent", children=[child], rotation=[0, half, 0, half], scale=[2, 2, 2])  # x to -z
    matrix = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]  # a quarter turn about z: x to y
    gltf.node(name="matrix", mesh=0, matrix=matrix)
    reader = read(gltf.save(tmp_path))
    assert names(reader) == ["floor", "child", "matrix"]
    # (-1, 0, 1) -> mirrored and moved (2, 0, 1) -> turned (1, 0, -2) -> scaled (2, 0, -4) -> z up (2, 4, 0)
    np.testing.assert_allclose(corners(reader)[4], (2, 4, 0), atol=1e-12)
    np.testing.assert_allclose(normal(reader, 2), (0, 0, 1), atol=1e-12)
    np.testing.assert_allclose(corners(reader)[8], (5, -8, 5), atol=1e-12)  # (-1, 0, 1) -> (5, 5, 8)
    np.testing.assert_allclose(normal(reader, 4), (-1, 0, 0), atol=1e-12)


def test_instances(tmp_path):
    gltf = floor()
    places = gltf.accessor([(0, 0, 0), (4, 0, 0), (0, 3, 0)])
    turns = gltf.accessor([(0, 0, 0, 127), (0, 127, 0, 0), (0, 0, 0, 127)], 5120, "VEC4", normalized=True)
    gltf["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places, "ROTATION": turns}}}
    reader = read(gltf.save(tmp_path))
    assert reader.GetSurfaces().GetNumberOfCells() == 6 and names(reader) == ["floor"]
    np.testing.assert_allclose(corners(reader)[4:9:4], [(5, 1, 0), (-1, -1, 3)], atol=1e-12)


@pytest.mark.parametrize("mode, order, expected", [
    (4, [0, 1, 2, 0, 2, 3], 2), (5, [0, 1, 3, 2], 2), (6, [0, 1, 2, 3], 2)])
@pytest.mark.parametrize("component", [5121, 5123, 5125])
def test_triangles_strips_and_fans(tmp_path, mode, order, expected, component):
    gltf = Gltf()
    gltf.node(mesh=gltf.mesh(SQUARE, order, component, mode=mode))
    reader = read(gltf.save(tmp_path))
    assert reader.GetSurfaces().GetNumberOfCells() == expected
    for cell in range(expected):
        np.testing.assert_allclose(normal(reader, cell), (0, 0, 1))
    assert cells(reader, "Reflectance").tolist() == [0.5, 0.5]
    assert notes(reader)["surfaces without a material"] == "reflectance 0.5"


def test_names_that_are_taken_or_no_file_names(tmp_path):
    gltf = floor()
    for name in ("floor", "floor", "floor 2", "a/b", "..", "", "x" * 300, "B\u00fcro"):
        gltf.node(name=name, mesh=0)
    assert names(read(gltf.save(tmp_path))) == ["floor", "floor 2", "floor 3", "floor 2 2", "a-b", "-.", "surface", "x" * 100, "B\u00fcro"]


def test_sparse_accessors_and_quantised_points(tmp_path):
    gltf = floor()
    gltf.accessor([2], 5121, "SCALAR")
    gltf.accessor([(3, 0, -1)])
    gltf["accessors"][0]["sparse"] = {"count": 1, "indices": {"bufferView": 2, "componentType": 5121}, "values": {"bufferView": 3}}
    quantised = gltf.add("meshes", primitives=[{"attributes": {"POSITION": gltf.accessor(
        [(-32767, 0, 0), (32767, 0, 0), (0, 0, -32767)], 5122, normalized=True)}}])
    gltf.node(mesh=quantised)
    gltf["extensionsRequired"] = ["KHR_mesh_quantization"]
    points = corners(read(gltf.save(tmp_path)))
    np.testing.assert_allclose(points[2], (3, 1, 0))
    np.testing.assert_allclose(points[4:], [(-1, 0, 0), (1, 0, 0), (0, 1, 0)])


def test_usual_receivers(tmp_path):
    """A room with a floor slab: the work plane lies over its upper face, not over the lower one or the table."""
    gltf = floor(4)
    gltf.node(name="below", mesh=0, translation=[0, -0.2, 0], scale=[1.2, 1, 1.2], rotation=[1, 0, 0, 0])
    gltf.node(name="table", mesh=0, translation=[0, 0.7, 0], scale=[0.3, 1, 0.3])
    gltf.node(name="ceiling", mesh=0, translation=[0, 3, 0], rotation=[1, 0, 0, 0])
    reader = read(gltf.save(tmp_path))
    assert blocks(reader) == ["workplane"]
    plane = reader.GetReceivers().GetBlock(0)
    assert plane.GetBounds() == pytest.approx((-2, 2, -2, 2, 0.75, 0.75))
    assert plane.GetNumberOfCells() == 8 * 8  # p = 0.2 x 5^log10(4) = 0.527 m
    assert notes(reader)["receivers"] == "workplane at z = 0.75 m"
    low = read(floor(0.2).save(tmp_path, "low.glb"))
    assert blocks(low) == ["surfaces"]
    assert low.GetReceivers().GetBlock(0).GetNumberOfCells() >= 400
    area = sum(low.GetReceivers().GetBlock(0).GetCell(i).ComputeArea() for i in range(low.GetReceivers().GetBlock(0).GetNumberOfCells()))
    assert area == pytest.approx(0.04)


def scene_around(folder, **more):
    scene = {"kalos": 1, "surfaces": [{"file": "model.gltf"}], **more}
    path = folder / "scene.json"
    path.write_text(json.dumps(scene))
    return path


def test_a_scene_file_overrides_and_extends(tmp_path):
    gltf = floor(4, name="paint")
    gltf.light({"translation": [0, 2.5, 0], "name": "lamp"}, type="point", intensity=100)
    gltf.light({"translation": [1, 2.5, 0], "name": "other"}, type="point", intensity=100)
    gltf.save(tmp_path)
    lamp = {"name": "lamp", "position": [0, 0, 2.4], "flux": 77, "distribution": "isotropic"}
    box = {"name": "box", "box": {"center": [0, 0, 0.5], "size": [1, 1, 1]}, "material": "paint"}
    desk = {"name": "desk", "plane": {"origin": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 0], "resolution": [2, 2]}}
    reader = read(scene_around(tmp_path, materials={"paint": {"reflectance": 0.31}}, luminaires=[lamp], receivers=[desk],
                               surfaces=[{"file": "model.gltf"}, box]))
    assert names(reader) == ["floor", "box"] and set(cells(reader, "Reflectance")) == {0.31}
    flux = vtk_to_numpy(reader.GetLuminaires().GetPointData().GetArray("LuminousFlux"))
    np.testing.assert_allclose(flux, [77, 400 * np.pi])
    assert blocks(reader) == ["desk"]
    dark = read(scene_around(tmp_path, surfaces=[{"file": "model.gltf", "lights": False, "scale": 2, "up": "z"}]))
    assert dark.GetLuminaires().GetNumberOfPoints() == 0
    np.testing.assert_allclose(corners(dark)[0], (-4, 0, 4))


def test_a_named_model_is_one_surface_without_lights(tmp_path):
    gltf = floor()
    gltf.node(name="far", mesh=0, translation=[10, 0, 0])
    gltf.light(type="point", intensity=100)
    gltf.save(tmp_path, "room.glb")
    scene = minimal_scene()
    scene["surfaces"].append({"name": "room", "file": "room.glb", "scale": 0.5})
    reader = read(write_scene(tmp_path, scene))
    assert names(reader) == ["floor", "room"] and reader.GetSurfaces().GetNumberOfCells() == 5
    assert reader.GetLuminaires().GetNumberOfPoints() == 1
    np.testing.assert_allclose(corners(reader)[-1], (4.5, 0.5, 0))
