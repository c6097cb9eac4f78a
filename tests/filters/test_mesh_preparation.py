# SPDX-License-Identifier: BSD-3-Clause
"""Repair, remeshing and singular edges as filters: what survives, what is reported, what is refused."""
import math

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData

from helpers import update_error
from kalos.vtk import vtkKalosCalculationPlane, vtkKalosSingularEdges, vtkKalosSurfaceRemesh, vtkKalosSurfaceRepair

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def surface(points, polygons, **arrays):
    data = vtkPolyData()
    corners = vtkPoints()
    corners.SetDataTypeToDouble()
    for point in points:
        corners.InsertNextPoint(point)
    cells = vtkCellArray()
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    data.SetPoints(corners)
    data.SetPolys(cells)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.asarray(values), deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    return data


def room():
    """The cube seen from inside, a reflectance for each side, with a box on its floor."""
    points = CUBE + [(0.3 + 0.3 * x, 0.3 + 0.3 * y, 0.3 * z) for x, y, z in CUBE]
    polygons = [side[::-1] for side in SIDES] + [tuple(i + 8 for i in side) for side in SIDES]
    return surface(points, polygons, Reflectance=[0.1 * (i + 1) / 2 for i in range(12)], SurfaceId=[0] * 6 + [1] * 6)


def make(kind, data, **settings):
    filter_ = kind()
    filter_.SetInputData(data)
    for name, value in settings.items():
        getattr(filter_, "Set" + name)(value)
    return filter_


def report(filter_):
    table = filter_.GetReport()
    names, values = (table.GetColumnByName(name) for name in ("Quantity", "Value"))
    return {names.GetValue(i): values.GetValue(i) for i in range(table.GetNumberOfRows())}


def area_by(data, name):
    points = vtk_to_numpy(data.GetPoints().GetData())
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    keys = np.round(vtk_to_numpy(data.GetCellData().GetArray(name)), 9)
    return {key: areas[keys == key].sum() for key in np.unique(keys)}


def curves(data, **settings):
    edges = make(vtkKalosSingularEdges, data, **settings)
    assert update_error(edges) is None
    return edges, vtk_to_numpy(edges.GetOutput().GetCellData().GetArray("EdgeClass")).tolist()


def test_repair_keeps_cell_arrays_and_names_of_cells():
    data = room()
    labels = vtkStringArray()
    labels.SetName("Label")
    for i in range(12):
        labels.InsertNextValue(f"side {i}")
    data.GetCellData().AddArray(labels)
    repair = make(vtkKalosSurfaceRepair, data)
    assert update_error(repair) is None
    out = repair.GetOutput()
    assert out.GetNumberOfCells() == 24
    names = out.GetCellData().GetAbstractArray("Label")
    rho = out.GetCellData().GetArray("Reflectance")
    for i in range(24):
        assert rho.GetValue(i) == pytest.approx(0.05 * (int(names.GetValue(i).split()[1]) + 1))
    assert report(repair)["area after"] == pytest.approx(6 + 6 * 0.09)
    assert report(repair)["surfaces"] == 2


def test_repair_turns_what_faces_the_other_way_but_for_emitters():
    polygons = [side[::-1] if i == 2 else side for i, side in enumerate(SIDES)]
    repair = make(vtkKalosSurfaceRepair, surface(CUBE, polygons))
    repair.Update()
    assert report(repair)["triangles turned"] == 2
    repair = make(vtkKalosSurfaceRepair, surface(CUBE, polygons, Exitance=[0.0, 0, 5000, 0, 0, 0]))
    repair.Update()
    assert report(repair)["triangles turned"] == 10


def test_what_is_not_repaired_is_named():
    data = surface(CUBE[:4], [(0, 1, 3), (1, 3, 0), (3, 1, 0)], Reflectance=[0.5, 0.5, 0.2])
    repair = make(vtkKalosSurfaceRepair, data)
    repair.Update()
    assert report(repair)["duplicate triangles dropped"] == 1
    names = repair.GetOutput().GetFieldData().GetAbstractArray("Unrepaired")
    assert names.GetNumberOfTuples() == 1 and names.GetValue(0) == "2" and "another material" in names.GetValue(1)


def test_strips_count_and_lines_are_left_out():
    data = vtkPolyData()
    points = vtkPoints()
    for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0), (5, 5, 5)):
        points.InsertNextPoint(p)
    lines, strips, verts = vtkCellArray(), vtkCellArray(), vtkCellArray()
    verts.InsertNextCell(1, (5,))
    lines.InsertNextCell(2, (0, 5))
    strips.InsertNextCell(5, (0, 1, 2, 3, 4))
    data.SetPoints(points)
    data.SetVerts(verts)
    data.SetLines(lines)
    data.SetStrips(strips)
    ids = numpy_to_vtk(np.array([7, 8, 9]), deep=True)
    ids.SetName("Id")
    data.GetCellData().AddArray(ids)
    repair = make(vtkKalosSurfaceRepair, data)
    repair.Update()
    out = repair.GetOutput()
    assert out.GetNumberOfCells() == 3 and out.GetNumberOfPoints() == 5
    assert vtk_to_numpy(out.GetCellData().GetArray("Id")).tolist() == [9, 9, 9]
    assert report(repair)["triangles turned"] == 0
    assert report(repair)["vertices and lines left out"] == 2


def test_concave_polygons_are_covered_once():
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 0.5, 0), (0, 2, 0)]
    repair = make(vtkKalosSurfaceRepair, surface(points, [(0, 1, 2, 3, 4)]))
    repair.Update()
    assert report(repair)["area after"] == pytest.approx(2 * 2 - 1.5)


def test_remesh_keeps_materials_and_areas():
    data = room()
    remesh = make(vtkKalosSurfaceRemesh, data, EdgeLength=0.05)
    assert update_error(remesh) is None
    repair = make(vtkKalosSurfaceRepair, data)
    repair.Update()
    assert area_by(remesh.GetOutput(), "Reflectance") == pytest.approx(area_by(repair.GetOutput(), "Reflectance"))
    assert report(remesh)["smallest angle"] > 15
    assert report(remesh)["mean edge"] == pytest.approx(0.05, rel=0.2)


def test_remesh_takes_lengths_from_an_array():
    data = room()
    lengths = numpy_to_vtk(np.array([0.05] + [1.0] * 11), deep=True)
    lengths.SetName("Size")
    data.GetCellData().AddArray(lengths)
    remesh = make(vtkKalosSurfaceRemesh, data, EdgeLength=0.4, SizeArrayName="Size")
    assert update_error(remesh) is None
    rho = vtk_to_numpy(remesh.GetOutput().GetCellData().GetArray("Reflectance"))
    assert (abs(rho - 0.05) < 1e-9).sum() > 10 * (abs(rho - 0.1) < 1e-9).sum()


def steps(size=8, **arrays):
    """A square of squares with cell arrays made from the centres' x."""
    points = [(i / size, j / size, 0) for j in range(size + 1) for i in range(size + 1)]
    polygons = [(k, k + 1, k + size + 2, k + size + 1) for k in (i + j * (size + 1) for j in range(size) for i in range(size))]
    x = np.array([(i + 0.5) / size for _ in range(size) for i in range(size)])
    return surface(points, polygons, **{name: value(x) for name, value in arrays.items()})


def triangles_by_x(data, edge):
    """Number of triangles left and right of an edge."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    x = points[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3), 0].mean(axis=1)
    return (x < edge).sum(), (x > edge).sum()


def test_remesh_is_finer_where_a_result_is_steep_or_uncertain():
    steep = steps(E=lambda x: np.where(x < 0.5, 100 + 400 * x, 300.0))
    remesh = make(vtkKalosSurfaceRemesh, steep, EdgeLength=0.2, ResultArrayName="E")
    assert update_error(remesh) is None
    left, right = triangles_by_x(remesh.GetOutput(), 0.6)
    assert left > 3 * right
    even = steps(E=lambda x: np.full_like(x, 200.0), EStandardError=lambda x: np.where(x > 0.5, 100.0, 1.0))
    remesh = make(vtkKalosSurfaceRemesh, even, EdgeLength=0.2, ResultArrayName="E")
    assert update_error(remesh) is None
    left, right = triangles_by_x(remesh.GetOutput(), 0.5)
    assert right > 3 * left
    coarse = make(vtkKalosSurfaceRemesh, steep, EdgeLength=0.2, ResultArrayName="E", ResultChange=10.0)
    assert update_error(coarse) is None
    assert coarse.GetOutput().GetNumberOfCells() < 150
    for settings, message in (({"ResultArrayName": "F"}, "no cell array F"), ({"ResultArrayName": "E", "ResultChange": 0}, "ResultChange")):
        assert message in update_error(make(vtkKalosSurfaceRemesh, steep, **settings))


def test_edges_of_a_room_with_a_box():
    edges, kinds = curves(room())
    assert kinds.count(vtkKalosSingularEdges.CONCAVE) == 12
    assert kinds.count(vtkKalosSingularEdges.CONTACT) == 4
    data = edges.GetOutput().GetCellData()
    assert vtk_to_numpy(data.GetArray("DihedralAngle")) == pytest.approx(90)
    assert vtk_to_numpy(data.GetArray("Severity")) == pytest.approx(0.25)
    _, kinds = curves(room(), ConcaveEdges=False, ContactEdges=False, ConvexEdges=True)
    assert kinds == [vtkKalosSingularEdges.CONVEX] * 12


@pytest.mark.parametrize("blocks", [False, True])
def test_receivers_get_their_distance(blocks):
    plane = vtkKalosCalculationPlane()
    plane.SetOrigin(0, 0, 0.1)
    plane.SetU(1, 0, 0)
    plane.SetV(0, 1, 0)
    plane.SetResolution(10, 10)
    plane.Update()
    receivers = plane.GetOutput()
    if blocks:
        receivers = vtkMultiBlockDataSet()
        receivers.SetBlock(0, plane.GetOutput())
    edges = make(vtkKalosSingularEdges, room())
    edges.SetInputData(1, receivers)
    edges.Update()
    out = edges.GetOutputDataObject(1)
    out = out.GetBlock(0) if blocks else out
    distance = vtk_to_numpy(out.GetCellData().GetArray("EdgeDistance"))
    assert distance[0] == pytest.approx(math.hypot(0.05, 0.1) if 0.05 < 0.1 else 0.1, rel=0.5)
    for i in (0, 7, 23, 44):
        x, y = 0.05 + 0.1 * (i % 10), 0.05 + 0.1 * (i // 10)
        walls = [math.hypot(d, 0.1) for d in (x, 1 - x, y, 1 - y)]  # to the edges of the floor
        corners = [math.hypot(a, b) for a in (x, 1 - x) for b in (y, 1 - y)]
        low, high = 0.3, 0.6
        def to(x0, x1, y0, y1):
            return math.sqrt(max(x0 - x, 0, x - x1) ** 2 + max(y0 - y, 0, y - y1) ** 2 + 0.01)
        box = [to(low, high, low, low), to(low, high, high, high), to(low, low, low, high), to(high, high, low, high)]
        assert distance[i] == pytest.approx(min(walls + corners + box), rel=1e-9)
    assert vtk_to_numpy(out.GetCellData().GetArray("EdgeAngle")) == pytest.approx(90)
    assert not plane.GetOutput().GetCellData().HasArray("EdgeDistance")


NAN = [(0, 0, 0), (1, 0, 0), (0, math.nan, 0)]
FLAT = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
ALL = (vtkKalosSurfaceRepair, vtkKalosSurfaceRemesh, vtkKalosSingularEdges)


@pytest.mark.parametrize("kind", ALL)
@pytest.mark.parametrize("data, message", [
    (vtkPolyData(), "no polygons"), (surface(NAN, [(0, 1, 2)]), "point 2 of cell 0 is NaN or infinite"),
    (surface(NAN[:2] + [(0, math.inf, 0)], [(0, 1, 2)]), "NaN or infinite"),
    (surface(CUBE[:2], [(0, 1, 9)]), "point that is not there"),
    (surface(CUBE, SIDES, Reflectance=[0.5]), "Reflectance: has 1 tuples, expected one for each of the 6 cells")])
def test_bad_meshes_are_refused(kind, data, message):
    filter_ = make(kind, data)
    assert message in update_error(filter_)
    assert filter_.GetOutput().GetNumberOfCells() == 0


@pytest.mark.parametrize("kind, settings, message", [
    (vtkKalosSurfaceRepair, {"Tolerance": -1}, "Tolerance"), (vtkKalosSingularEdges, {"Tolerance": math.inf}, "Tolerance"),
    (vtkKalosSingularEdges, {"FlatAngle": 0}, "FlatAngle"), (vtkKalosSurfaceRemesh, {"EdgeLength": 0}, "edge length"),
    (vtkKalosSurfaceRemesh, {"EdgeLength": math.nan}, "edge length"), (vtkKalosSurfaceRemesh, {"EdgeLength": 1e-5}, "triangles"),
    (vtkKalosSurfaceRemesh, {"FeatureAngle": 0}, "FeatureAngle"), (vtkKalosSurfaceRemesh, {"SizeArrayName": "None"}, "None"),
    (vtkKalosSurfaceRemesh, {"SmallestEdgeLength": -1}, "smallest")])
def test_bad_properties_are_refused(kind, settings, message):
    filter_ = make(kind, room(), **settings)
    assert message in update_error(filter_)
    assert filter_.GetOutput().GetNumberOfCells() == 0


@pytest.mark.parametrize("kind, settings", [(vtkKalosSurfaceRepair, {}), (vtkKalosSingularEdges, {}), (vtkKalosSurfaceRemesh, {"EdgeLength": 0.02})])
def test_the_time_limit(kind, settings):
    filter_ = make(kind, room(), TimeLimit=1e-6, **settings)
    assert "time limit of 1e-06 s" in update_error(filter_)
    assert filter_.GetOutput().GetNumberOfCells() == 0 and filter_.GetReport().GetNumberOfRows() == 0
    assert "TimeLimit" in update_error(make(kind, room(), TimeLimit=-1))
    assert update_error(make(kind, room(), TimeLimit=0)) is None


def test_degenerate_meshes():
    assert "degenerate" in update_error(make(vtkKalosSurfaceRepair, surface(FLAT, [(0, 1, 2)])))
    edges, kinds = curves(surface(FLAT, [(0, 1, 2)]))
    assert kinds == []
    repair = make(vtkKalosSurfaceRepair, surface(CUBE[:4], [(0, 1, 2)] * 100000))
    assert update_error(repair) is None
    assert repair.GetOutput().GetNumberOfCells() == 1


@pytest.mark.parametrize("kind", ALL)
def test_abort_leaves_nothing(kind):
    filter_ = make(kind, room())
    filter_.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
    assert update_error(filter_) is None
    assert filter_.GetOutput().GetNumberOfCells() == 0
