# SPDX-License-Identifier: BSD-3-Clause
"""Candela tables of luminaires: read from photometric files, and put together when luminaires are joined."""
from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.core import arrays
from kalos.errors import InputError, KalosError, update
from kalos.vtk import vtkKalosPhotometryReader

FIRST = 2  # the Distribution of the first table


def from_file(path: str, lamp_set: int, position: np.ndarray, aim: np.ndarray, flux: float, rotation_deg: float) -> vtkPolyData:
    """One luminaire of a photometric file, as vtkKalosPhotometryReader puts it out; flux 0 is the file's. Raises InputError."""
    reader = vtkKalosPhotometryReader()
    reader.SetFileName(path)
    reader.SetLampSet(lamp_set)
    reader.SetPosition(*position)
    reader.SetAim(*aim)
    reader.SetFlux(flux)
    reader.SetRotationDegrees(rotation_deg)
    try:
        update(reader)
    except KalosError as error:
        raise InputError(f"file: {error}") from None
    return reader.GetOutputDataObject(3)


class Tables:
    """The tables of several pieces in one numbering."""

    def __init__(self) -> None:
        self.tables: List[vtkDataArray] = []
        self.numbers: Dict[Tuple[bytes, int], int] = {}
        self.poles = vtkIntArray()
        self.poles.SetName(arrays.CANDELA_POLES)

    def renumbered(self, where: str, piece: vtkPolyData, kinds: np.ndarray) -> np.ndarray:
        """The values of Distribution of a piece in the common numbering; takes the tables that they name."""
        fields, found = piece.GetFieldData(), kinds.copy()
        for kind in np.unique(kinds[kinds >= FIRST]):
            name = f"{arrays.CANDELA_TABLE}{int(kind) - FIRST}"
            table, poles = fields.GetArray(name), fields.GetArray(arrays.CANDELA_POLES)
            if table is None or poles is None or poles.GetNumberOfTuples() <= kind - FIRST:
                if piece.GetPointData().GetAbstractArray(arrays.CANDELA_TABLES):  # attach_texts() brings the table
                    found[kinds == kind] = FIRST
                    continue
                raise InputError(f"{where} refers to a candela table that it does not have, expected the field data arrays {name} "
                                 f"and {arrays.CANDELA_POLES}")
            found[kinds == kind] = FIRST + self.number(table, int(poles.GetTuple1(int(kind) - FIRST)))
        return found

    def number(self, table: vtkDataArray, pole: int) -> int:
        """The number of a table; equal ones are kept once."""
        key = vtk_to_numpy(table).tobytes(), pole
        if key not in self.numbers:
            self.numbers[key] = len(self.tables)
            self.tables.append(table)
            self.poles.InsertNextValue(pole)
        return self.numbers[key]

    def attach(self, luminaires: vtkPolyData) -> None:
        """Puts the tables into the field data of the joined luminaires."""
        if not self.tables:
            return
        for k, table in enumerate(self.tables):
            copy = table.NewInstance()
            copy.ShallowCopy(table)
            copy.SetName(f"{arrays.CANDELA_TABLE}{k}")
            luminaires.GetFieldData().AddArray(copy)
        luminaires.GetFieldData().AddArray(self.poles)


def attach_texts(pieces: Sequence[vtkPolyData], luminaires: vtkPolyData) -> None:
    """Puts the tables that the pieces have in their point data there as well: they are right where filters appended the pieces."""
    texts = vtkStringArray()
    texts.SetName(arrays.CANDELA_TABLES)
    for piece in pieces:
        own = piece.GetPointData().GetAbstractArray(arrays.CANDELA_TABLES)
        for i in range(piece.GetNumberOfPoints()):
            texts.InsertNextValue(own.GetValue(i) if own else "")
    if any(texts.GetValue(i) for i in range(texts.GetNumberOfValues())):
        luminaires.GetPointData().AddArray(texts)
