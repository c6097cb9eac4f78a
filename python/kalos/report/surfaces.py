# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of a scene with their areas and reflectances, for the report."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.report.html import table
from kalos.results.receivers import areas
from kalos.results.text import number
from kalos.scenes.photometric import photometric

COLUMNS = ((arrays.REFLECTANCE, "reflectance"), (arrays.SPECULAR, "specular"), (arrays.MIRROR, "mirror"), (arrays.EXITANCE, "exitance, lm/m²"))


def surface_section(reader):
    """One row a surface: its area, and means over it where it has several materials."""
    surfaces = reader.GetSurfaces()
    if surfaces.GetNumberOfCells() == 0:
        return []
    data, names = surfaces.GetCellData(), surfaces.GetFieldData().GetAbstractArray(arrays.SURFACE_NAMES)
    ids, area = vtk_to_numpy(data.GetArray(arrays.SURFACE_ID)), areas(surfaces)
    kept = [(label, photometric(vtk_to_numpy(data.GetArray(name)))) for name, label in COLUMNS if data.HasArray(name)]
    kept = [(label, values) for label, values in kept if label == "reflectance" or values.any()]
    rows = []
    for k in range(names.GetNumberOfValues()):
        own = ids == k
        if own.any():
            rows.append((names.GetValue(k), number(float(area[own].sum())),
                         *(number(float(np.average(values[own], weights=area[own]))) for _, values in kept)))
    head = ("surface", "area, m²", *(label for label, _ in kept))
    return ["<h2>Surfaces</h2>", table(head, rows, numbers=range(1, len(head))),
            "<p class='facts'>Photometric means over the area of a surface. Surfaces reflect on both sides.</p>"]
