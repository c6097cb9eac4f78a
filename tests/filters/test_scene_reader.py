# SPDX-License-Identifier: BSD-3-Clause
"""Valid scene files."""
import math

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from helpers import minimal_scene, update_error, write_scene
from kalos.vtk import vtkKalosSceneReader


def read(folder, scene):
    reader = vtkKalosSceneReader()
    reader.SetFileName(write_scene(folder, scene))
    assert update_error(reader) is None
    return reader


def cell_array(reader, name):
    return vtk_to_numpy(reader.GetSurfaces().GetCellData().GetArray(name)).tolist()


def test_minimal_scene(tmp_path):
    reader = read(tmp_path, minimal_scene())
    assert reader.GetSurfaces().GetNumberOfCells() == 1
    assert cell_array(reader, "Reflectance") == [0.7]
    assert cell_array(reader, "Exitance") == [0]
    lamp = reader.GetLuminaires()
    assert lamp.GetPoint(0) == (2, 1, 3)
    assert lamp.GetPointData().GetArray("Direction").GetTuple(0) == (0, 0, -1)
    assert lamp.GetPointData().GetAbstractArray("LuminaireNames").GetValue(0) == "lamp"
    desk = reader.GetReceivers()
    assert desk.GetMetaData(0).Get(vtkCompositeDataSet.NAME()) == "desk"
    assert desk.GetBlock(0).GetNumberOfCells() == 12


def test_camera(tmp_path):
    reader = read(tmp_path, minimal_scene())
    position, target, up, resolution = [0] * 3, [0] * 3, [0] * 3, [0] * 2
    reader.GetCameraPosition(0, position)
    reader.GetCameraTarget(0, target)
    reader.GetCameraUp(0, up)
    reader.GetCameraResolution(0, resolution)
    assert reader.GetNumberOfCameras() == 1
    assert (reader.GetCameraName(0), reader.GetCameraFieldOfView(0)) == ("front", 45)
    assert (position, target, up, resolution) == ([2, -4, 1], [2, 2, 1], [0, 0, 1], [16, 9])


def test_materials_reach_the_cells(tmp_path):
    scene = minimal_scene()
    scene["materials"] = {
        "white": {"reflectance": 0.5, "exitance": 100},
        "red": {"reflectance": [0.6, 0.1, 0.1], "specular": 0.04, "roughness": 0.2},
        "mirror": {"reflectance": 0, "mirror": 0.9}}
    for name in ("red", "mirror"):
        scene["surfaces"].append(dict(scene["surfaces"][0], name=name, material=name))
    reader = read(tmp_path, scene)
    assert cell_array(reader, "Reflectance") == [[0.5] * 3, [0.6, 0.1, 0.1], [0] * 3]
    assert cell_array(reader, "Exitance") == [[100] * 3, [0] * 3, [0] * 3]
    assert cell_array(reader, "Specular") == [0, 0.04, 0]
    assert cell_array(reader, "Roughness") == [1, 0.2, 1]
    assert cell_array(reader, "Mirror") == [0, 0, 0.9]
    assert cell_array(reader, "SurfaceId") == [0, 1, 2]
    names = reader.GetSurfaces().GetFieldData().GetAbstractArray("SurfaceNames")
    assert [names.GetValue(i) for i in range(3)] == ["floor", "red", "mirror"]


def test_box_normals_point_outwards(tmp_path):
    scene = minimal_scene()
    box = {"center": [1, 2, 3], "size": [2, 4, 6], "rotation_z_deg": 90}
    scene["surfaces"] = [{"name": "box", "box": box, "material": "white"}]
    data = read(tmp_path, scene).GetSurfaces()
    # A quarter turn swaps the extents in x and y.
    assert data.GetBounds() == pytest.approx((-1, 3, 1, 3, 0, 6))
    area = 0
    for i in range(data.GetNumberOfCells()):
        p = vtk_to_numpy(data.GetCell(i).GetPoints().GetData())
        u, v = p[1] - p[0], p[3] - p[0]
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        assert sum(n * (c - o) for n, c, o in zip(normal, p.mean(axis=0), (1, 2, 3))) > 0
        area += sum(n * n for n in normal) ** 0.5
    assert area == pytest.approx(2 * (2 * 4 + 4 * 6 + 6 * 2))


def test_boxes_turn_anti_clockwise_seen_from_above(tmp_path):
    scene = minimal_scene()
    box = {"center": [1, 2, 3], "size": [2, 4, 6], "rotation_z_deg": 30}
    scene["surfaces"] = [{"name": "box", "box": box, "material": "white"}]
    points = vtk_to_numpy(read(tmp_path, scene).GetSurfaces().GetPoints().GetData())
    cosine, sine = math.cos(math.pi / 6), 0.5
    corner = (1 + cosine - 2 * sine, 2 + sine + 2 * cosine, 6)  # that of +x, +y
    assert min(math.dist(point, corner) for point in points) < 1e-12


def test_rectangle_luminaire_and_superposed_arrays(tmp_path):
    scene = minimal_scene()
    rectangle = {"center": [1, 1, 3], "u": [0.6, 0, 0], "v": [0, 0.3, 0]}
    scene["luminaires"].append({"name": "panel", "rectangle": rectangle, "aim": [0, 0, -1], "flux": 3600})
    data = read(tmp_path, scene).GetLuminaires()
    assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == 2
    get = data.GetPointData().GetArray
    assert vtk_to_numpy(get("LuminousFlux")).tolist() == [1000, 3600]
    assert vtk_to_numpy(get("SideU")).tolist() == [[0, 0, 0], [0.6, 0, 0]]
    assert data.GetPointData().GetAbstractArray("LuminaireNames").GetValue(1) == "panel"


def test_isotropic_needs_no_aim(tmp_path):
    scene = minimal_scene()
    scene["luminaires"][0]["distribution"] = "isotropic"
    del scene["luminaires"][0]["aim"]
    data = read(tmp_path, scene).GetLuminaires()
    assert data.GetPointData().GetArray("Distribution").GetTuple1(0) == 0


def test_probe_file(tmp_path):
    scene = minimal_scene()
    (tmp_path / "probe.csv").write_text("x,y,z,nx,ny,nz\r\n1,2,3,0,0,2\r\n\r\n-1e-3, 0 ,.5,1,0,0\r\n")
    scene["receivers"] = [{"name": "probe", "points": "probe.csv"}]
    data = read(tmp_path, scene).GetReceivers().GetBlock(0)
    assert vtk_to_numpy(data.GetPoints().GetData()).tolist() == [[1, 2, 3], [-0.001, 0, 0.5]]
    assert vtk_to_numpy(data.GetPointData().GetNormals()).tolist() == [[0, 0, 1], [1, 0, 0]]
    assert data.GetNumberOfVerts() == 2


def test_normals_of_any_length(tmp_path):
    scene = minimal_scene()
    (tmp_path / "probe.csv").write_text("x,y,z,nx,ny,nz\n1,2,3,0,3e300,4e300\n1,2,3,0,3e-300,4e-300\n")
    scene["receivers"] = [{"name": "probe", "points": "probe.csv"}]
    normals = vtk_to_numpy(read(tmp_path, scene).GetReceivers().GetBlock(0).GetPointData().GetNormals())
    np.testing.assert_allclose(normals, [[0, 0.6, 0.8]] * 2, atol=1e-15)


@pytest.mark.parametrize("flip, sign", [(False, 1), (True, -1)])
def test_surface_receivers(tmp_path, flip, sign):
    scene = minimal_scene()
    scene["receivers"] = [{"name": "f", "surface": "floor", "edge_length": 0.5, "flip": flip}]
    data = read(tmp_path, scene).GetReceivers().GetBlock(0)
    assert (vtk_to_numpy(data.GetCellData().GetNormals()) == [0, 0, sign]).all()
    area = 0
    for i in range(data.GetNumberOfCells()):
        p = vtk_to_numpy(data.GetCell(i).GetPoints().GetData())
        assert max(((p[k] - p[k - 1]) ** 2).sum() ** 0.5 for k in range(3)) <= 0.5 + 1e-12
        area += data.GetCell(i).ComputeArea()
    assert area == pytest.approx(12)
    assert 96 <= data.GetNumberOfCells() <= 1000


@pytest.mark.parametrize("place", ["plane", "receiver"])
def test_plane_flip(tmp_path, place):
    scene = minimal_scene()
    receiver = scene["receivers"][0]
    (receiver["plane"] if place == "plane" else receiver)["flip"] = True
    data = read(tmp_path, scene).GetReceivers().GetBlock(0)
    assert data.GetCellData().GetNormals().GetTuple(0) == (0, 0, -1)


def test_can_read_file(tmp_path):
    reader = vtkKalosSceneReader()
    assert reader.CanReadFile(write_scene(tmp_path, minimal_scene()))
    assert not reader.CanReadFile(write_scene(tmp_path, '{"asset": 2}'))
    assert not reader.CanReadFile(str(tmp_path / "absent.json"))


def test_a_failure_leaves_nothing_of_the_scene_before(tmp_path):
    reader = read(tmp_path, minimal_scene())
    write_scene(tmp_path, "{")
    reader.Modified()
    assert update_error(reader)
    assert reader.GetSurfaces().GetNumberOfCells() == 0
    assert reader.GetLuminaires().GetNumberOfPoints() == 0
    assert reader.GetReceivers().GetNumberOfBlocks() == 0
    assert reader.GetNumberOfCameras() == 0


@pytest.mark.parametrize("u, v, cells", [
    (10, 10, (10, 10)), (5, 4, (8, 6)), (2, 1.5, (6, 5)), (1, 1, (5, 5)),  # table A.1 of EN 12464-1: 10, 8, 6, 5 points a side
    (100, 80, (20, 16)), (20, 5, (32, 8)), (1000, 900, (100, 90))])
def test_grid_of_the_standard(tmp_path, u, v, cells):
    """EN 12464-1: p = 0.2 x 5^log10(d); from twice as long as wide on, d is the shorter side; p at most 10 m."""
    scene = minimal_scene()
    scene["receivers"][0]["plane"] = {"origin": [0, 0, 0], "u": [u, 0, 0], "v": [0, v, 0], "spacing": "EN 12464-1"}
    plane = read(tmp_path, scene).GetReceivers().GetBlock(0)
    assert plane.GetNumberOfCells() == cells[0] * cells[1]
    assert plane.GetPoint(1)[0] == pytest.approx(u / cells[0])
