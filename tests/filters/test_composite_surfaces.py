# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces may be blocks, partitions or grids, and receivers any composite: the light is that of one surface."""
import numpy as np
import pytest
from helpers import update_error
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
                                           vtkPolyData, vtkUnstructuredGrid)

import kalos

FACES = np.array([0.2, 0.7, 0.5, 0.5, 0.4, 0.6])
LAMP = kalos.luminaire((2, 1.5, 2.7), 3000)
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def room():
    return kalos.box((2, 1.5, 1.4), (4, 3, 2.8), FACES, inwards=True)


def face(i):
    """The i-th face of the room alone, its reflectance as field data of one tuple."""
    whole, one = room(), vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    ids = whole.GetCell(i).GetPointIds()
    one.SetPoints(points)
    one.AllocateExact(1, 4)
    corners = [points.InsertNextPoint(whole.GetPoint(ids.GetId(k))) for k in range(ids.GetNumberOfIds())]
    one.InsertNextCell(whole.GetCellType(i), len(corners), corners)
    reflectance = numpy_to_vtk(FACES[i:i + 1], deep=1)
    reflectance.SetName("Reflectance")
    one.GetFieldData().AddArray(reflectance)
    return one


def blocks(parts, names=()):
    found = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        found.SetBlock(i, part)
    for i, name in enumerate(names):
        found.GetMetaData(i).Set(vtkMultiBlockDataSet.NAME(), name)
    return found


def partitions(parts):
    found = vtkPartitionedDataSetCollection()
    for i, part in enumerate(parts):
        own = vtkPartitionedDataSet()
        own.SetPartition(0, part)
        found.SetPartitionedDataSet(i, own)
    return found


def hexahedron(centre, size, reflectance):
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    for corner in CORNERS:
        points.InsertNextPoint(np.asarray(centre) + (np.array(corner) - 0.5) * size)
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
    values = numpy_to_vtk(np.array([reflectance]), deep=1)
    values.SetName("Reflectance")
    grid.GetCellData().AddArray(values)
    return grid


def plane(height=0.75):
    source = kalos.vtkKalosCalculationPlane()
    source.SetOrigin(0, 0, height)
    source.SetU(4, 0, 0)
    source.SetV(0, 3, 0)
    source.SetResolution(6, 4)
    source.Update()
    return source.GetOutput()


def estimator(surfaces, receivers):
    found = kalos.vtkKalosIlluminance()
    for port, data in enumerate((receivers, surfaces, LAMP)):
        found.SetInputDataObject(port, data)
    found.SetTrajectories(1600)
    return found


def lux(surfaces, receivers=None):
    found = estimator(surfaces, receivers or plane())
    found.Update()
    assert found.GetErrorCode() == 0
    return found.GetOutputDataObject(0)


def values(data):
    return vtk_to_numpy(data.GetCellData().GetArray("Illuminance"))


@pytest.mark.parametrize("join", [blocks, partitions])
def test_blocks_are_one_surface(join):
    """Each face of the room is a block with its reflectance."""
    np.testing.assert_allclose(values(lux(join([face(i) for i in range(6)]))), values(lux(room())), rtol=1e-6)


def test_a_grid_counts_with_its_outer_faces():
    solid, box = (hexahedron((2, 1.5, 1.6), 0.6, 0.4), kalos.box((2, 1.5, 1.6), (0.6, 0.6, 0.6), 0.4))
    grid, mesh = (values(lux(blocks([room(), one]))) for one in (solid, box))
    np.testing.assert_allclose(grid, mesh, rtol=0.05)
    assert (grid < 0.7 * values(lux(room()))).any()  # it stands below the lamp


def test_blocks_of_other_bands_and_exitance():
    """A block without exitance does not shine; one value of reflectance stands for all bands."""
    glowing = kalos.quad((1, 1, 2.79), (0, 1, 0), (1, 0, 0), [[0.5, 0.5, 0.5]], exitance=1000)
    assert (values(lux(blocks([room(), glowing]))) > values(lux(room()))).all()


def test_what_is_missing_is_named():
    bare = face(3)
    bare.GetFieldData().Initialize()
    found = estimator(blocks([face(0), bare], ["floor", "wall"]), plane())
    assert update_error(found) == "surfaces: wall: neither a cell array nor a field array Reflectance"


def test_receivers_of_any_composite():
    both = lux(room(), partitions([plane(), plane(1.2)]))
    assert both.IsA("vtkPartitionedDataSetCollection")
    first, second = (both.GetPartition(i, 0) for i in range(2))
    together = lux(room(), blocks([plane(), plane(1.2)]))
    np.testing.assert_array_equal(values(first), values(together.GetBlock(0)))
    np.testing.assert_array_equal(values(second), values(together.GetBlock(1)))
