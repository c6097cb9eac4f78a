# SPDX-License-Identifier: BSD-3-Clause
"""A scene as plain arrays, for programs that know nothing of VTK."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.scenes.clearance import triangles
from kalos.scenes.photometric import band_weights

ISOTROPIC, LAMBERTIAN = 0, 1


def materials(surfaces):
    """Reflectance and exitance (n, bands) of the triangles of kalos.clearance.triangles()."""
    counts = [surfaces.GetCell(i).GetNumberOfPoints() - 2 for i in range(surfaces.GetNumberOfCells())]
    found = [cell_bands(surfaces, name) for name in (arrays.REFLECTANCE, arrays.EXITANCE)]
    bands = max(values.shape[1] for values in found)
    return [np.repeat(np.broadcast_to(values, (len(values), bands)), counts, axis=0) for values in found]


def describe(reader, points, normals, response=None, emitted=0.0):
    """Arrays of the scene that a vtkKalosSceneReader has read, about its centre, in metres, lumens and lm/m2.

    triangles (n, 3, 3), reflectance and exitance (n, bands), lamp_flux, lamp_position, lamp_axis, lamp_u, lamp_v (full
    sides, zero for a point), lamp_isotropic, points and normals of the receivers. What is wanted of a receiver is the sum
    over the bands of response (n, bands) times illuminance, and emitted (n,): the photometric illuminance, where no response
    is given.
    """
    surfaces, lamps = reader.GetOutputDataObject(0), reader.GetOutputDataObject(1)
    faces = triangles(surfaces)
    reflectance, exitance = materials(surfaces)
    weights = band_weights(reflectance.shape[1])
    centre = (faces.reshape(-1, 3).min(axis=0) + faces.reshape(-1, 3).max(axis=0)) / 2

    def of_lamps(name, width):
        return column(lamps.GetPointData(), name, lamps.GetNumberOfPoints(), width)

    position = np.array([lamps.GetPoint(i) for i in range(lamps.GetNumberOfPoints())], float).reshape(-1, 3)
    return {"triangles": faces - centre,
            "reflectance": reflectance, "exitance": exitance,
            "lamp_flux": of_lamps(arrays.LUMINOUS_FLUX, 1)[:, 0], "lamp_position": position - centre,
            "lamp_axis": of_lamps(arrays.DIRECTION, 3),
            "lamp_u": of_lamps(arrays.SIDE_U, 3), "lamp_v": of_lamps(arrays.SIDE_V, 3),
            "lamp_isotropic": of_lamps(arrays.DISTRIBUTION, 1)[:, 0] == ISOTROPIC,
            "points": points - centre, "normals": normals,
            "response": np.broadcast_to(weights, (len(points), len(weights))) if response is None else response,
            "emitted": np.broadcast_to(emitted, len(points))}


def cell_bands(surfaces, name):
    values = column(surfaces.GetCellData(), name, surfaces.GetNumberOfCells(), None)
    return np.zeros((surfaces.GetNumberOfCells(), 1)) if values is None else values


def column(data, name, count, width):
    """A data array as (count, components); zeros, or None without a width, where there is none."""
    array = data.GetArray(name)
    if array is None:
        return None if width is None else np.zeros((count, width))
    return vtk_to_numpy(array).astype(float).reshape(count, -1)


def beyond(reader):
    """What a scene has that Lambertian programs cannot model, in a few words; None where there is nothing."""
    surfaces, lamps = reader.GetOutputDataObject(0), reader.GetOutputDataObject(1)
    for name, words in ((arrays.SPECULAR, "glossy surfaces"), (arrays.MIRROR, "mirrors")):
        if cell_bands(surfaces, name).any():
            return words
    if (column(lamps.GetPointData(), arrays.DISTRIBUTION, lamps.GetNumberOfPoints(), 1) > LAMBERTIAN).any():
        return "luminaires with a candela table"
    return None
