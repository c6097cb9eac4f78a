# SPDX-License-Identifier: BSD-3-Clause
"""Several surfaces, or several luminaires, as one vtkPolyData that loses none of their arrays."""
from __future__ import annotations

from typing import Sequence, Union

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from kalos.core import arrays
from kalos.core.sharing import shared
from kalos.errors import InputError
from kalos.scenes.candela_tables import Tables, attach_texts
from kalos.scenes.defaults import LAMP, MATERIAL

Surfaces = Union[vtkPolyData, Sequence[vtkPolyData]]
Luminaires = Union[vtkPolyData, Sequence[vtkPolyData], None]


def joined_surfaces(pieces: Surfaces) -> vtkPolyData:
    """Cells with the arrays of all pieces: photometric values beside bands are neutral, what a piece lacks is the default."""
    return joined("surfaces", pieces, vtkDataObject.CELL, {arrays.REFLECTANCE: None, **MATERIAL})


def joined_luminaires(pieces: Luminaires) -> vtkPolyData:
    return joined("luminaires", pieces, vtkDataObject.POINT, {arrays.LUMINOUS_FLUX: None, **LAMP})


def joined(name, pieces, kind, defaults):
    """A single piece is itself. vtkAppendPolyData keeps what all have in common, so all are completed first."""
    pieces = [] if pieces is None else list(pieces) if isinstance(pieces, (list, tuple)) else [pieces]
    for i, piece in enumerate(pieces):
        if not isinstance(piece, vtkPolyData):
            raise InputError(f"{name}: item {i} is of {type(piece).__name__}, expected vtkPolyData or a list of them")
    if len(pieces) <= 1:
        return pieces[0] if pieces else vtkPolyData()
    given = [piece.GetAttributes(kind) for piece in pieces]
    known = {key: [data.GetArray(key) for data in given] for key in defaults}
    widths = {key: max((a.GetNumberOfComponents() for a in found if a), default=0) for key, found in known.items()}
    append, tables = vtkAppendPolyData(), Tables()
    for i, piece in enumerate(pieces):
        copy = vtkPolyData()
        copy.CopyStructure(piece)
        for key, width in widths.items():
            if width:
                values = filled(f"{name}: item {i}", key, known[key][i], defaults[key], piece.GetNumberOfElements(kind), width)
                if key == arrays.DISTRIBUTION:
                    values = tables.renumbered(f"{name}: item {i}", piece, values)
                copy.GetAttributes(kind).AddArray(shared(values, key))
        append.AddInputData(copy)
    append.Update()
    tables.attach(append.GetOutput())
    if kind == vtkDataObject.POINT:
        attach_texts(pieces, append.GetOutput())
        attach_sky(pieces, append.GetOutput())
    return append.GetOutput()


def attach_sky(pieces, luminaires):
    """The sky that one of the pieces has."""
    skies = [piece.GetFieldData() for piece in pieces if piece.GetFieldData().HasArray(arrays.SKY)]
    if len(skies) > 1:
        raise InputError(f"luminaires: {len(skies)} of them are skies, expected one")
    for key in (arrays.SKY, arrays.SKY_MAP):
        if skies and skies[0].HasArray(key):
            luminaires.GetFieldData().AddArray(skies[0].GetArray(key))


def filled(where, key, array, default, count, width):
    """(count, width) values of the array, or its default where there is none."""
    if array is None:
        if default is None:
            raise InputError(f"{where} has no array {key}, expected what kalos.surface() or kalos.luminaire() makes")
        values = np.array(default, float)
    else:
        values = vtk_to_numpy(array).reshape(count, -1)
        if values.shape[1] not in (1, width):
            raise InputError(f"{where} has {values.shape[1]} components of {key}, expected 1 or {width}")
    return np.ascontiguousarray(np.broadcast_to(values, (count, width)), float)
