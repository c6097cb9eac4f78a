# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of models share: reading a model and its content."""
import numpy as np
from helpers import update_error
from kalos.estimation.filters import illuminance_filter
from kalos.vtk import vtkKalosSceneReader
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet


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
    """What the reader did with each subject."""
    return dict(zip(*all_notes(reader)[:2]))


def reasons(reader):
    """Why, with how many and which."""
    return dict(zip(*all_notes(reader)[::2]))


def all_notes(reader):
    array = reader.GetSurfaces().GetFieldData().GetAbstractArray("SceneNotes")
    values = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return values[::3], values[1::3], values[2::3]


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
