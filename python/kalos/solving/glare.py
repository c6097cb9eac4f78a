# SPDX-License-Identifier: BSD-3-Clause
"""Discomfort glare of the observers of a scene: the unified glare rating (UGR) of CIE 117."""
import math

from kalos.core import arrays
from kalos.errors import update
from kalos.vtk import vtkKalosGlareRating


def rate_glare(reader, receivers, prepared):
    """Rates the receiver sets that are observers; their data sets get the arrays of vtkKalosGlareRating.

    Returns {name: {"UGR", "background_luminance" (cd/m2), both with "..._standard_error", "sources"}}, and lines of audit.
    UGR is None where no source is seen, and where no light but that of sources comes to the eye.
    """
    found, audit = {}, []
    for one in receivers:
        if not one.dataset.GetPointData().HasArray(arrays.OBSERVER_UP):
            continue
        rating = vtkKalosGlareRating()
        rating.SetInputDataObject(0, one.dataset)
        rating.SetInputDataObject(1, prepared.surfaces or reader.GetSurfaces())
        rating.SetInputDataObject(2, reader.GetLuminaires())
        update(rating)
        one.dataset = rating.GetOutput()
        found[one.name], counts = figures(one.dataset.GetPointData())
        audit.append({"subject": "glare", "choice": f"UGR of {one.name} by CIE 117, {counts[0]} sources seen",
                      "reason": "luminous areas are flat, as large as their projection; " + remarks(counts)})
    return found, audit


def figures(data):
    value, error, background, background_error = (data.GetArray(name).GetTuple1(0) for name in (
        arrays.UGR, arrays.UGR_STANDARD_ERROR, arrays.BACKGROUND_LUMINANCE, arrays.BACKGROUND_LUMINANCE_STANDARD_ERROR))
    counts = [int(x) for x in data.GetArray(arrays.GLARE_SOURCES).GetTuple3(0)]
    known = math.isfinite(value)
    return {"UGR": value if known else None, "UGR_standard_error": error if known else None, "background_luminance": background,
            "background_luminance_standard_error": background_error, "sources": counts[0]}, counts


def remarks(counts):
    _, small, large = counts
    said = [f"{small} without an area or below 0.005 m2 by CIE 147"] if small else []
    said += [f"{large} beyond 0.1 sr, where CIE 117 was not tested"] if large else []
    return ", ".join(said) or "all within the range of CIE 117"
