# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as VTK arrays on the same memory, where that is safe."""
from __future__ import annotations

from typing import Optional

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDataArray, vtkObjectBase


def shared(values: np.ndarray, name: Optional[str] = None) -> vtkDataArray:
    """A VTK array on the memory of `values`; a copy where that memory is VTK's already.

    VTK's wrapping cannot take a VTK array that keeps another one alive through NumPy: it damages its own tables when both
    go (VTK 9.2). So the view that vtk_to_numpy() makes, or an array made from it without a copy, is copied.
    """
    array = numpy_to_vtk(values, deep=of_vtk(values))
    if name is not None:
        array.SetName(name)
    return array


def of_vtk(values: np.ndarray) -> bool:
    """Whether the memory of an array is that of a VTK object."""
    owner = values
    while isinstance(owner, np.ndarray):
        owner = owner.base
    if isinstance(owner, memoryview):
        owner = owner.obj
    return isinstance(owner, vtkObjectBase)
