# SPDX-License-Identifier: BSD-3-Clause
"""glTF and OBJ models as scenes: geometry, materials, lights, cameras, what is approximated, and what is refused."""
import json
import struct
import zlib

import numpy as np
import pytest
from gltf import SQUARE, TRIANGLES, Gltf, floor
from helpers import minimal_scene, update_error, write_scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from kalos.estimation.filters import illuminance_filter
from kalos.vtk import vtkKalosSceneReader


def read(path):
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(path))
    assert update_error(reader) is None
    return reader


def error_of(path, text=None):
    if text is not None:
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(path))
    error = update_error(reader)
    assert error and "\n" not in error
    assert reader.GetSurfaces().GetNumberOfCells() == 0
    return error.replace(f"{path}: ", "", 1)


def cells(reader, name):
    return vtk_to_numpy(reader.GetSurfaces().GetCellData().GetArray(name))


def names(reader):
    array = reader.GetSurfaces().GetFieldData().GetAbstractArray("SurfaceNames")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def notes(reader):
    array = reader.GetSurfaces().GetFieldData().GetAbstractArray("SceneNotes")
    values = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return {subject: choice for subject, choice in zip(values[::3], values[1::3])}


def blocks(reader):
    found = reader.GetReceivers()
    return [found.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) for i in range(found.GetNumberOfBlocks())]


def corners(reader):
    return vtk_to_numpy(reader.GetSurfaces().GetPoints().GetData())


def normal(reader, cell):
    p = vtk_to_numpy(reader.GetSurfaces().GetCell(cell).GetPoints().GetData())
    n = np.cross(p[1] - p[0], p[2] - p[0])
    return n / np.linalg.norm(n)


def direct(path, points, normals):
    """Direct illuminance at points, which for points of light is exact."""
    from kalos.results.receivers import from_dataset, point_receivers

    estimator = illuminance_filter(read(path), None)
    estimator.SetTrajectories(32)
    estimator.SetInputDataObject(0, point_receivers(points, np.broadcast_to(normals, np.shape(points))))
    estimator.Update()
    return from_dataset("points", estimator.GetOutputDataObject(0)).direct


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


@pytest.mark.parametrize("material, expected", [
    (dict(color=(0.7, 0.7, 0.7)), dict(Reflectance=0.7, Specular=0, Mirror=0)),
    (dict(color=(0.7, 0.7, 0.7), roughness=0.25), dict(Reflectance=0.7, Specular=0.04, Roughness=0.25)),
    (dict(color=(0.6, 0.6, 0.6), metallic=1, roughness=0.3), dict(Reflectance=0, Specular=0.6, Roughness=0.3)),
    (dict(color=(0.6, 0.6, 0.6), metallic=0.5, roughness=0.3), dict(Reflectance=0.3, Specular=0.32)),
    (dict(color=(0.9, 0.9, 0.9), metallic=1, roughness=0), dict(Mirror=0.9, Specular=0)),
    (dict(), dict(Reflectance=0.95)),
    (dict(metallic=1, roughness=1), dict(Specular=0.95, Reflectance=0)),
    (dict(color=(0.5, 0.5, 0.5), emissiveFactor=[1, 1, 1]), dict(Exitance=np.pi)),
    (dict(color=(0.5, 0.5, 0.5), emissiveFactor=[0.5, 0.5, 0.5],
          extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 4000}}), dict(Exitance=2000 * np.pi))])
def test_neutral_materials(tmp_path, material, expected):
    gltf = Gltf()
    gltf.material(**material)
    gltf.node(mesh=gltf.mesh(SQUARE, TRIANGLES, material=0))
    reader = read(gltf.save(tmp_path))
    for name, value in expected.items():
        np.testing.assert_allclose(cells(reader, name), value, rtol=1e-12, err_msg=name)


def test_coloured_materials_have_three_bands(tmp_path):
    gltf = floor(color=(0.6, 0.2, 0.1), emissiveFactor=[1, 0.5, 0])
    gltf.material((0.8, 0.4, 0.2), metallic=1, roughness=0.4, name="copper")
    gltf.node(mesh=gltf.mesh(SQUARE, TRIANGLES, material=1))
    reader = read(gltf.save(tmp_path))
    np.testing.assert_allclose(cells(reader, "Reflectance")[0], (0.6, 0.2, 0.1))
    np.testing.assert_allclose(cells(reader, "Exitance")[0], np.pi * np.array((1, 0.5, 0)))
    assert cells(reader, "Specular")[2] == pytest.approx(0.2126 * 0.8 + 0.7152 * 0.4 + 0.0722 * 0.2)
    assert notes(reader)["coloured metals"] == "neutral" and "emissive materials" in notes(reader)


def png(pixels):
    """8-bit RGB rows as a PNG."""
    height, width, _ = np.shape(pixels)
    rows = b"".join(b"\0" + np.asarray(row, np.uint8).tobytes() for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def textured(image, **info):
    gltf = floor()
    gltf.add("images", **info)
    gltf.add("textures", source=0)
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    if "uri" not in info:
        gltf["images"][0]["bufferView"] = gltf.add("bufferViews", buffer=0, byteOffset=len(gltf.bytes), byteLength=len(image))
        gltf.bytes += image
    return gltf


def test_a_texture_counts_by_its_mean_in_linear_light(tmp_path):
    image = png([[(255, 255, 255), (0, 0, 0)], [(188, 188, 188), (0, 0, 0)]])  # 188 is 0.5029 linear
    reader = read(textured(image, mimeType="image/png").save(tmp_path, "model.glb"))
    np.testing.assert_allclose(cells(reader, "Reflectance"), 0.5 * (1 + ((188 / 255 + 0.055) / 1.055) ** 2.4) / 4)
    assert notes(reader)["textures"] == "their mean colour"
    (tmp_path / "a b.png").write_bytes(image)
    beside = read(textured(image, uri="a%20b.png").save(tmp_path))
    assert cells(beside, "Reflectance").tolist() == cells(reader, "Reflectance").tolist()


def test_a_jpeg_texture(tmp_path):
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkJPEGWriter

    image = vtkImageData()
    image.SetDimensions(32, 16, 1)
    image.AllocateScalars(3, 3)  # VTK_UNSIGNED_CHAR
    image.GetPointData().GetScalars().Fill(188)
    writer = vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(tmp_path / "grey.jpg"))
    writer.Write()
    reader = read(textured(b"", uri="grey.jpg").save(tmp_path))
    np.testing.assert_allclose(cells(reader, "Reflectance"), 0.5 * 0.5029, rtol=2e-3)


@pytest.mark.parametrize("image", [b"", b"GIF89a..........", png([[(9, 9, 9)]])[:-20], b"\xff\xd8\xff\xe0garbage......"])
def test_a_texture_that_can_not_be_read_is_left_out_and_said(tmp_path, image):
    reader = read(textured(image or b"\0", mimeType="image/png").save(tmp_path))
    assert cells(reader, "Reflectance").tolist() == [0.5, 0.5]
    assert notes(reader)["textures that can not be read"] == "left out"


def test_a_point_in_candela_above_a_floor(tmp_path):
    """E = I cos / d^2, below a parent that moves and turns."""
    gltf = floor(10)
    lamp = gltf.light(type="point", intensity=900, name="lamp")
    gltf["scenes"][0]["nodes"].remove(lamp)
    gltf["nodes"][lamp]["translation"] = [0, 0, 1]
    gltf.node(children=[lamp], translation=[0, 3, 0], scale=[2, 2, 2], rotation=[0, 1, 0, 0])  # z to -z: at (0, 3, -2)
    where = np.array([(0, 2, 0), (0, 0, 0), (3, -2, 0)], float)
    distance = np.linalg.norm(where - (0, 2, 3), axis=1)
    np.testing.assert_allclose(direct(gltf.save(tmp_path), where, (0, 0, 1)), 900 * 3 / distance**3, rtol=1e-9)


def test_a_spot(tmp_path):
    """Full within the inner cone, the square of a linear fall in cos, dark outside; its flux in closed form."""
    inner, outer = 0.3, 0.6
    gltf = floor(10)
    spot = {"innerConeAngle": inner, "outerConeAngle": outer}
    down = {"translation": [0, 2, 0], "rotation": [-np.sqrt(0.5), 0, 0, np.sqrt(0.5)]}  # -z to -y
    gltf.light(down, type="spot", intensity=500, spot=spot)
    path = gltf.save(tmp_path)
    angles = np.array([0, 0.25, 0.35, 0.45, 0.55, 0.65])
    where = np.stack([2 * np.tan(angles), 0 * angles, 0 * angles], axis=1)
    share = np.clip((np.cos(angles) - np.cos(outer)) / (np.cos(inner) - np.cos(outer)), 0, 1) ** 2
    expected = 500 * share * np.cos(angles) ** 3 / 4
    np.testing.assert_allclose(direct(path, where, (0, 0, 1)), expected, atol=1e-4 * 500 / 4)
    reader = read(path)
    flux = reader.GetLuminaires().GetPointData().GetArray("LuminousFlux").GetTuple1(0)
    closed = 2 * np.pi * 500 * (1 - np.cos(inner) + (np.cos(inner) - np.cos(outer)) / 3)
    assert flux == pytest.approx(closed, rel=1e-4)
    assert "spot lights" in notes(reader)


def test_parallel_light_in_lux(tmp_path):
    """E times the cosine anywhere in the scene, within 0.2 %, and the whole of the surfaces is reached."""
    gltf = floor(10)
    tilt = 0.5  # from straight down
    gltf.light({"rotation": [-np.sin(np.pi / 4 - tilt / 2), 0, 0, np.cos(np.pi / 4 - tilt / 2)]}, type="directional", intensity=20000)
    path = gltf.save(tmp_path)
    where = np.array([(0, 0, 0), (4.9, 4.9, 0), (-4.9, 4.9, 0), (4.9, -4.9, 0)], float)
    np.testing.assert_allclose(direct(path, where, (0, 0, 1)), 20000 * np.cos(tilt), rtol=2e-3)
    toward = (0, -np.sin(tilt), np.cos(tilt))
    assert direct(path, where[:1], toward)[0] == pytest.approx(20000, rel=2e-5)
    assert "directional lights" in notes(read(path))


def test_colour_and_range_of_lights_are_said(tmp_path):
    gltf = floor()
    gltf.light({"translation": [0, 2, 0]}, type="point", intensity=100, color=[1, 0.5, 0], range=3)
    reader = read(gltf.save(tmp_path))
    flux = reader.GetLuminaires().GetPointData().GetArray("LuminousFlux").GetTuple1(0)
    assert flux == pytest.approx(4 * np.pi * 100 * (0.2126 + 0.5 * 0.7152))
    assert notes(reader)["coloured lights"] == "white" and notes(reader)["ranges of lights"] == "without end"


def test_cameras(tmp_path):
    gltf = floor()
    lens = {"yfov": np.pi / 3, "aspectRatio": 2.0, "znear": 0.1}
    gltf.node(name="view/1", camera=gltf.add("cameras", type="perspective", perspective=lens), translation=[1, 2, 3])
    gltf.node(name="plan", camera=gltf.add("cameras", type="orthographic", orthographic={}))
    reader = read(gltf.save(tmp_path))
    position, target, up, resolution = [0] * 3, [0] * 3, [0] * 3, [0] * 2
    reader.GetCameraPosition(0, position)
    reader.GetCameraTarget(0, target)
    reader.GetCameraUp(0, up)
    reader.GetCameraResolution(0, resolution)
    assert reader.GetNumberOfCameras() == 1 and reader.GetCameraName(0) == "view-1"
    np.testing.assert_allclose([position, target, up], [(1, -3, 2), (1, -2, 2), (0, 0, 1)], atol=1e-12)
    assert reader.GetCameraFieldOfView(0) == pytest.approx(60) and resolution == [512, 256]


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


OBJ = "mtllib room.mtl\no floor\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nusemtl wood\nf 1 2 3 4\n"
MTL = "newmtl wood\nKd 0.4 0.4 0.4\nKs 0.5 0.5 0.5\nNs 30\n"


def test_obj_with_its_library(tmp_path):
    (tmp_path / "room.mtl").write_text(MTL + "newmtl glow\nKd 0.8 0.8 0.8\nKe 100 100 100\n# mirror\nnewmtl steel\r\nKd 0 0 0\r\n"
                                       "Ks 0.6\r\nNs 198\r\nillum 3\r\nnewmtl pbr\nKd 0.5 0.5 0.5\nPr 0.3\nPm 1\n")
    (tmp_path / "room.obj").write_text(OBJ + "o lamp\nv 1 1 2.9\nv 2 1 2.9\nv 2 2 2.9\nusemtl glow\nf 7 6 5\nusemtl steel\nf 1 2 7\n"
                                       "usemtl pbr\nf 1 2 6\nf 1 2 1\n")
    reader = read(tmp_path / "room.obj")
    assert names(reader) == ["floor", "lamp"] and blocks(reader) == ["workplane"]
    np.testing.assert_allclose(cells(reader, "Reflectance"), (0.4, 0.8, 0, 0))
    np.testing.assert_allclose(cells(reader, "Exitance"), (0, 100 * np.pi, 0, 0))
    np.testing.assert_allclose(cells(reader, "Specular"), (0, 0, 0.6, 0.5))
    np.testing.assert_allclose(cells(reader, "Roughness")[2:], (0.01 ** 0.25, 0.3))
    np.testing.assert_allclose(normal(reader, 1), (0, 0, -1))
    found = notes(reader)
    assert found["axes"] == "as in the file, z up" and found["highlights"] == "left out"
    assert found["degenerate faces"] == "left out" and found["emissive materials"] == "exitance pi Ke"


def test_an_obj_in_a_scene_finds_names_in_the_scene_first(tmp_path):
    (tmp_path / "room.mtl").write_text(MTL)
    (tmp_path / "room.obj").write_text(OBJ)
    scene = minimal_scene()
    scene["surfaces"].append({"name": "room", "file": "room.obj"})
    assert cells(read(write_scene(tmp_path, scene)), "Reflectance").tolist() == [0.7, 0.4]
    scene["materials"]["wood"] = {"reflectance": 0.25}
    assert cells(read(write_scene(tmp_path, scene)), "Reflectance").tolist() == [0.7, 0.25]


@pytest.mark.parametrize("mtl, message", [
    (None, 'usemtl wood: no such material in the scene; expected a name from "materials" or of a library of the file (there is '
           "no room.mtl)"),
    ("newmtl\n", "room.mtl: line 1: newmtl without a name; expected the name of a material"),
    ("newmtl a\nKd 2 0 0\n", "room.mtl: line 2: no number, or one that is out of range; expected at least 0 and at most 1"),
    ("newmtl a\nKd x\n", "room.mtl: line 2: no number"), ("newmtl a\nNs -1\n", "room.mtl: line 2: no number")])
def test_broken_libraries(tmp_path, mtl, message):
    if mtl is not None:
        (tmp_path / "room.mtl").write_text(mtl)
    assert error_of(tmp_path / "room.obj", OBJ).replace(str(tmp_path) + "/", "").startswith(message)


def test_a_library_that_is_named_twice_is_read_once(tmp_path):
    assert error_of(tmp_path / "room.obj", "mtllib room.mtl\n" + OBJ).endswith("library of the file (there is no room.mtl)")


def zeros(gltf, count):
    """Gives the floor points that stand nowhere in the file."""
    gltf["accessors"][0].pop("bufferView")
    gltf["accessors"][0].update(count=count)


def many_primitives(gltf):
    zeros(gltf, 4000000)
    gltf["meshes"][0]["primitives"] *= 9


def many_instances(gltf):
    zeros(gltf, 4000000)
    gltf["accessors"].append({"componentType": 5126, "count": 8, "type": "VEC3"})
    gltf["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}


def spoiled(change, make=floor):
    gltf = make()
    text = json.loads(gltf.text())
    change(text)
    return json.dumps(text)


@pytest.mark.parametrize("change, message", [
    (lambda g: g.pop("asset"), 'scene: the key "asset" is missing'),
    (lambda g: g["asset"].update(version="1.0"), 'asset.version: found "1.0"; expected "2.0"'),
    (lambda g: g.update(extensionsRequired=["KHR_draco_mesh_compression"]),
     'extensionsRequired[0]: found "KHR_draco_mesh_compression"; expected a file without compression'),
    (lambda g: g.pop("scenes") and g.pop("scene"), "scene: no scenes; expected one"),
    (lambda g: g.update(scene=3), "scene: found 3; expected the number of one of 1 scenes, counted from 0"),
    (lambda g: g["scenes"][0].update(nodes=[7]), "scenes[0].nodes[0]: found 7; expected the number of one of 1 nodes"),
    (lambda g: g["nodes"][0].update(children=[0]), "nodes.floor.children[0]: node 0 is met twice; expected a tree"),
    (lambda g: g["nodes"][0].update(mesh=1), "nodes.floor.mesh: found 1; expected the number of one of 1 meshes"),
    (lambda g: g["nodes"][0].update(mesh=-1), "nodes.floor.mesh: found -1; expected a number of at least 0"),
    (lambda g: g["nodes"][0].update(mesh=0.5), "nodes.floor.mesh: found 0.5; expected a whole number"),
    (lambda g: g["nodes"][0].update(matrix=[1] * 16), "nodes.floor.matrix: a projection; expected 0, 0, 0, 1 in the last row"),
    (lambda g: g["nodes"][0].update(matrix=[1]), "nodes.floor.matrix: found [1]; expected 16 numbers"),
    (lambda g: g["nodes"][0].update(scale=[1, "2", 1]), "nodes.floor.scale: found [1,\"2\",1]; expected three numbers"),
    (lambda g: g["meshes"][0].pop("primitives"), 'meshes[0]: the key "primitives" is missing'),
    (lambda g: g["meshes"][0]["primitives"][0].update(mode=9), "meshes[0].primitives[0].mode: found 9"),
    (lambda g: g["meshes"][0]["primitives"][0].update(material=2),
     "meshes[0].primitives[0].material: found 2; expected the number of one of 1 materials"),
    (lambda g: g["accessors"][1].update(count=5), "meshes[0].primitives[0]: 5 corners; expected three for each triangle"),
    (lambda g: g["accessors"][1].update(componentType=5126), "accessors[1].componentType: found 5126; expected an unsigned"),
    (lambda g: g["accessors"][0].update(componentType=1), "accessors[0].componentType: found 1; expected 5120"),
    (lambda g: g["accessors"][0].update(type="VEC2"), 'accessors[0].type: found "VEC2"; expected "VEC3"'),
    (lambda g: g["accessors"][0].update(count=2), "meshes[0].primitives[0].indices: point 2 is named; expected one of the 2"),
    (lambda g: g["accessors"][0].update(count=4000000000), "accessors[0].count: found 4000000000; expected a whole number from 1"),
    (lambda g: g["accessors"][0].update(count=6), "accessors[0]: 6 elements do not fit into the 48 bytes of the view"),
    (lambda g: g["accessors"][0].update(byteOffset=1 << 50), "accessors[0]: 4 elements do not fit"),
    (lambda g: g["accessors"][0].pop("bufferView"), "file: no polygons and no lights"),
    (lambda g: zeros(g, 4000001), 'accessors[0]: 4000001 elements without a "bufferView"; expected at most 4000000'),
    (many_primitives, "meshes[0].primitives[7]: too many triangles or points in one mesh; expected at most 10000000"),
    (many_instances, "nodes.floor: too many triangles over all instances; expected at most 10000000"),
    (lambda g: g["bufferViews"][0].update(byteStride=4), "bufferViews[0]: a stride of 4 bytes; expected 12 to 252"),
    (lambda g: g["bufferViews"][0].update(byteLength=1000), "bufferViews[0]: ends at byte 1000 of a buffer of 60; expected"),
    (lambda g: g["bufferViews"][0].update(buffer=4), "bufferViews[0].buffer: found 4; expected the number of one of 1 buffers"),
    (lambda g: g["buffers"][0].update(byteLength=100), "buffers[0]: 60 bytes; expected 100"),
    (lambda g: g["buffers"][0].pop("uri"), 'buffers[0]: neither a "uri" nor the binary chunk of a .glb'),
    (lambda g: g["buffers"][0].update(uri="lost.bin"), "buffers[0].uri: no file "),
    (lambda g: g["buffers"][0].update(uri="data:text/plain,abc"), "buffers[0].uri: a data URI that is not base64"),
    (lambda g: g["buffers"][0].update(uri="data:;base64,!!!!"), "buffers[0].uri: a character that is not of base64"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(baseColorFactor=[2, 0, 0, 1]),
     "materials[0].pbrMetallicRoughness.baseColorFactor: found [2,0,0,1]; expected numbers from 0 to 1"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(metallicFactor=-1), "materials[0].pbrMetallicRoughness.metallic"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(baseColorTexture={"index": 0}),
     "materials[0].pbrMetallicRoughness.baseColorTexture.index: found 0; expected the number of one of 0 textures"),
    (lambda g: g.update(nodes=[7]), "nodes[0]: found 7; expected an object"),
])
def test_broken_gltf(tmp_path, change, message):
    error = error_of(tmp_path / "model.gltf", spoiled(change))
    assert error.startswith(message), error


def with_light(**light):
    def make():
        gltf = floor()
        gltf.light(**light)
        return gltf
    return make


@pytest.mark.parametrize("make, message", [
    (with_light(type="point", intensity=-1), "lights[0].intensity: found -1; expected a number of at least 0"),
    (with_light(type="laser"), 'lights[0].type: found "laser"; expected "point", "spot" or "directional"'),
    (with_light(type="point", color=[1, 1]), "lights[0].color: found [1,1]; expected three numbers"),
    (with_light(type="spot", spot={"outerConeAngle": 2}), "lights[0].spot.outerConeAngle: found 2; expected an angle above 0"),
    (with_light(type="spot", spot={"innerConeAngle": 0.5, "outerConeAngle": 0.5}), "lights[0].spot.innerConeAngle: found 0.5"),
    (with_light(node={"scale": [0, 0, 0]}, type="point"), "nodes[1]: a light or camera whose transform leaves it no direction"),
])
def test_broken_lights(tmp_path, make, message):
    assert message in error_of(tmp_path / "model.gltf", make().text())


@pytest.mark.parametrize("change, message", [
    (lambda b: b[:10], "header: no glTF binary of version 2"), (lambda b: b[:4] + b"\1" + b[5:], "header: no glTF binary of"),
    (lambda b: b[:-1], "header: a file of "), (lambda b: b[:16] + b"ABCD" + b[20:], "header: the first chunk is no JSON"),
    (lambda b: b[:12] + b"\xff\xff\xff\x7f" + b[16:], "header: the first chunk is no JSON, or not complete"),
    (lambda b: b.replace(b"BIN\0", b"BAN\0"), "buffers[0]: neither"), (lambda b: b"", "line 1"), (lambda b: b"{", "line 1")])
def test_broken_glb(tmp_path, change, message):
    assert error_of(tmp_path / "model.glb", change(floor().binary())).startswith(message)


def test_every_prefix_of_a_file_is_an_error_of_one_line(tmp_path):
    whole = floor().binary()
    for length in range(0, len(whole), 7):
        error_of(tmp_path / "model.glb", whole[:length])
