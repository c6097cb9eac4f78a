# SPDX-License-Identifier: BSD-3-Clause
"""Mesh files in whatever state, as vtkPolyData to repair: by the readers of scenes, which pass over more here."""
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from kalos.errors import update
from kalos.vtk import vtkKalosMeshReader

SUFFIXES = (".obj", ".ply", ".stl", ".off", ".vtp", ".gltf", ".glb")


def read_mesh(path):
    """The surface in a mesh file, by the suffix of its name."""
    reader = vtkKalosMeshReader()
    reader.SetFileName(str(path))
    update(reader)
    return reader.GetOutput()


def poly_data(points: Any, polygons: Any) -> vtkPolyData:
    """Polygons as lists of point numbers."""
    mesh = vtkPolyData()
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(np.asarray(points, float).reshape(-1, 3), deep=True))
    offsets = np.cumsum([0] + [len(polygon) for polygon in polygons])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.array([i for polygon in polygons for i in polygon], np.int64), deep=True))
    mesh.SetPoints(corners)
    mesh.SetPolys(cells)
    return mesh
