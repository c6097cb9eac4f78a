# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces from NumPy arrays, as vtkPolyData with the arrays that the filters read.

Lengths are metres. NumPy arrays of numbers are shared with VTK, not copied: they must be C-contiguous,
float64 or float32, and a later change of the array changes the scene (call Modified() on the vtkPolyData). Indices, int64 or
int32, are copied: vtkCellArray cannot keep NumPy's memory alive. Whatever is wrong with an argument is a ValueError that
names it.
"""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from kalos.core import arrays
from kalos.core.sharing import shared
from kalos.scenes.checks import INTEGERS, non_empty, numbers, refuse, within
from kalos.scenes.defaults import MATERIAL

BOX = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])  # normals outwards


def surface(vertices: ArrayLike, faces: ArrayLike, reflectance: ArrayLike, *, exitance: ArrayLike = 0.0,
            specular: ArrayLike = 0.0, roughness: ArrayLike = 1.0, mirror: ArrayLike = 0.0,
            transmittance: ArrayLike = 0.0, refractive_index: ArrayLike = 1.52) -> vtkPolyData:
    """A mesh with its materials.

    vertices: (n, 3), m. faces: (m, k) indices of the k corners of each polygon; its normal is to the viewer who sees them
    counter-clockwise. reflectance: diffuse, [0, 1); a number for all faces, (m,) one a face, (m, b) or (1, b) with b bands
    (3: linear Rec. 709 red, green, blue). exitance: lm/m2 emitted on the side of the normal, shaped alike. specular:
    normal-incidence reflectance of a GGX lobe, [0, 1). roughness: of that lobe, (0, 1]. mirror: reflectance of a perfect
    mirror, [0, 1). transmittance: of a pane of glass at normal incidence, (0, 1]; 0 is opaque. refractive_index: of such a pane,
    1 to 4; these five a number or (m,). Raises ValueError; what only the sum of several shows, illuminance() does.

    >>> floor = surface([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]], [[0, 1, 2, 3]], 0.3)
    >>> floor.GetNumberOfCells()
    1
    """
    vertices = numbers("vertices", vertices, [("n", 3)])
    faces = non_empty("faces", numbers("faces", faces, [("m", "k")], INTEGERS))
    if faces.shape[1] < 3:
        refuse("faces", faces, "", "(m, k) with k >= 3 corners")
    within("faces", faces, 0, len(vertices), f"indices of the {len(vertices)} vertices")
    count = len(faces)
    bands = [(), ("m",), ("m", "b")]
    result = poly_data(vertices, polygons=faces)
    data = result.GetCellData()
    put(data, arrays.REFLECTANCE, of_faces(within("reflectance", numbers("reflectance", reflectance, bands), 0, 1,
                                                  "numbers in [0, 1)"), "reflectance", count))
    for name, value, low, below, expected, shapes in (
            (arrays.EXITANCE, exitance, 0, np.inf, "lm/m2 >= 0", bands),
            (arrays.SPECULAR, specular, 0, 1, "numbers in [0, 1)", bands[:2]),
            (arrays.ROUGHNESS, roughness, np.nextafter(0, 1), np.nextafter(1, 2), "numbers in (0, 1]", bands[:2]),
            (arrays.MIRROR, mirror, 0, 1, "numbers in [0, 1)", bands[:2]),
            (arrays.TRANSMITTANCE, transmittance, 0, np.nextafter(1, 2), "numbers in [0, 1]", bands[:2]),
            (arrays.REFRACTIVE_INDEX, refractive_index, 1, np.nextafter(4, 5), "numbers from 1 to 4", bands[:2])):
        key = "refractive_index" if name == arrays.REFRACTIVE_INDEX else name.lower()
        given = within(key, numbers(key, value, shapes), low, below, expected)
        if given.ndim or given != MATERIAL[name]:
            put(data, name, of_faces(given, key, count))
    return result


def quad(origin: ArrayLike, u: ArrayLike, v: ArrayLike, reflectance: ArrayLike, **material: ArrayLike) -> vtkPolyData:
    """A parallelogram from `origin` (3,) along the sides u and v (3,), m; its normal is u x v. Materials as for surface().

    >>> ceiling = quad((0, 0, 3), (0, 3, 0), (4, 0, 0), 0.7)
    """
    origin, u, v = (numbers(name, value, [(3,)]) for name, value in (("origin", origin), ("u", u), ("v", v)))
    if not np.linalg.norm(np.cross(u, v)) > 0:
        refuse("v", v, " and spans no area with u", "a side that is not parallel to u")
    return surface(np.array([origin, origin + u, origin + u + v, origin + v]), [[0, 1, 2, 3]], reflectance, **material)


def box(center: ArrayLike, size: ArrayLike, reflectance: ArrayLike, *, rotation_z_deg: float = 0.0, inwards: bool = False,
        **material: ArrayLike) -> vtkPolyData:
    """A box about `center` (3,) with sides `size` (3,), m, turned about the vertical by rotation_z_deg.

    Its six faces, bottom, top, front, back, left, right, have their normals outwards, or inwards for a room. Materials as
    for surface(), m = 6.

    >>> room = box((2, 1.5, 1.5), (4, 3, 3), [0.2, 0.7, 0.5, 0.5, 0.5, 0.5], inwards=True)
    """
    center, size = numbers("center", center, [(3,)]), numbers("size", size, [(3,)])
    within("size", size, np.nextafter(0, 1), np.inf, "lengths > 0 in metres")
    corners = np.array([(k & 1, k >> 1 & 1, k >> 2) for k in range(8)]) * size - size / 2
    angle = np.radians(float(numbers("rotation_z_deg", rotation_z_deg, [()])))
    turn = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    faces = np.ascontiguousarray(BOX[:, ::-1] if inwards else BOX)
    return surface(corners @ turn + center, faces, reflectance, **material)


def of_each(values, name, count, components=None):
    """One value, or one vector of `components`, for each of `count`; a single one serves all."""
    if values.ndim == (0 if components is None else 1):
        return np.ascontiguousarray(np.broadcast_to(values, (count, *values.shape)))
    if len(values) != count:
        refuse(name, values, "", f"{count} of them, one each" if count > 1 else "one")
    return values


def of_faces(values, name, count):
    """One row a face; a number or a single row serves all."""
    if values.ndim == 2 and len(values) == 1:
        values = values[0]
        return np.ascontiguousarray(np.broadcast_to(values, (count, len(values))))
    return of_each(values, name, count)


def poly_data(points, polygons=None):
    """vtkPolyData on the array's own memory: polygons, or one cell of all points."""
    result, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(shared(points))
    result.SetPoints(places)
    rows = np.arange(len(points), dtype=np.int64)[None] if polygons is None else polygons
    offsets = np.arange(0, rows.size + 1, rows.shape[1], dtype=rows.dtype)
    convert = numpy_to_vtkIdTypeArray if rows.dtype == np.int64 else numpy_to_vtk
    cells.SetData(convert(offsets, deep=True), convert(rows.reshape(-1), deep=True))
    (result.SetVerts if polygons is None else result.SetPolys)(cells)
    return result


def put(data, name, values):
    data.AddArray(shared(values, name))
