# SPDX-License-Identifier: BSD-3-Clause
"""A scene as plain arrays, for programs that know nothing of VTK."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.scenes.clearance import triangles
from kalos.scenes.lobes import KERNEL_STEPS, KERNEL_TABLE, lobe_albedo, mean_albedo
from kalos.scenes.photometric import band_weights

ISOTROPIC, LAMBERTIAN = 0, 1


def triangle_counts(surfaces):
    return [surfaces.GetCell(i).GetNumberOfPoints() - 2 for i in range(surfaces.GetNumberOfCells())]


def materials(surfaces):
    """Reflectance and exitance (n, bands) of the triangles of kalos.clearance.triangles()."""
    found = [cell_bands(surfaces, name) for name in (arrays.REFLECTANCE, arrays.EXITANCE)]
    bands = max(values.shape[1] for values in found)
    return [np.repeat(np.broadcast_to(values, (len(values), bands)), triangle_counts(surfaces), axis=0) for values in found]


def gloss(surfaces):
    """Specular reflectance, width of the lobe (the square of the roughness) and mirror share of the same triangles, each (n,)."""
    specular, roughness, mirror = (cell_bands(surfaces, name)[:, 0] for name in (arrays.SPECULAR, arrays.ROUGHNESS, arrays.MIRROR))
    return [np.repeat(values, triangle_counts(surfaces)) for values in (specular, np.maximum(1e-4, roughness**2), mirror)]


def describe(reader, points, normals, response=None, emitted=0.0, first=-1, outgoing=None):
    """Arrays of the scene that a vtkKalosSceneReader has read, about its centre, in metres, lumens and lm/m2.

    triangles (n, 3, 3), reflectance and exitance (n, bands), lamp_flux, lamp_position, lamp_axis, lamp_u, lamp_v (full
    sides, zero for a point), lamp_isotropic, points and normals of the receivers. What is wanted of a receiver is the sum
    over the bands of response (n, bands) times illuminance, and emitted (n,): the photometric illuminance, where no response
    is given. Beyond Lambert's law there are specular, alpha, mirror (n,) of the triangles, and lamp_table, the number of a
    luminaire's candela table or -1, with lamp_up; a table k is planesK, anglesK (degrees), candelaK (planes, angles), and
    sideK, whether its planes meet at the side; lobe is a triangle's row of albedo, the lobe's over evenly spaced cosines, with
    albedo_mean. first (n,) is the triangle that a receiver is a point of, which then counts as
    pi times the luminance that it reflects to `outgoing`; -1 is an illuminance.
    """
    surfaces, lamps = reader.GetOutputDataObject(0), reader.GetOutputDataObject(1)
    faces = triangles(surfaces)
    reflectance, exitance = materials(surfaces)
    weights = band_weights(reflectance.shape[1])
    centre = (faces.reshape(-1, 3).min(axis=0) + faces.reshape(-1, 3).max(axis=0)) / 2

    def of_lamps(name, width):
        return column(lamps.GetPointData(), name, lamps.GetNumberOfPoints(), width)

    specular, alpha, mirror = gloss(surfaces)
    distribution = of_lamps(arrays.DISTRIBUTION, 1)[:, 0].astype(int)
    position = np.array([lamps.GetPoint(i) for i in range(lamps.GetNumberOfPoints())], float).reshape(-1, 3)
    return {"triangles": faces - centre,
            "reflectance": reflectance, "exitance": exitance,
            "lamp_flux": of_lamps(arrays.LUMINOUS_FLUX, 1)[:, 0], "lamp_position": position - centre,
            "lamp_axis": of_lamps(arrays.DIRECTION, 3),
            "lamp_u": of_lamps(arrays.SIDE_U, 3), "lamp_v": of_lamps(arrays.SIDE_V, 3),
            "lamp_isotropic": distribution == ISOTROPIC, "lamp_table": np.maximum(distribution - LAMBERTIAN, 0) - 1,
            "lamp_up": of_lamps(arrays.UP, 3), **candela_tables(lamps, distribution.max(initial=0) - LAMBERTIAN),
            "specular": specular, "alpha": alpha, "mirror": mirror, **albedo_tables(specular, alpha),
            "first": np.broadcast_to(first, len(points)), "outgoing": np.zeros_like(points) if outgoing is None else outgoing,
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


def candela_tables(lamps, count):
    """The arrays of `count` candela tables."""
    found = {}
    for k in range(count):
        rows = vtk_to_numpy(lamps.GetFieldData().GetArray(f"{arrays.CANDELA_TABLE}{k}")).astype(float)
        planes, angles = np.unique(rows[:, 0]), np.unique(rows[:, 1])
        order = np.lexsort((rows[:, 1], rows[:, 0]))
        found.update({f"planes{k}": planes, f"angles{k}": angles, f"candela{k}": rows[order, 2].reshape(len(planes), len(angles)),
                      f"side{k}": lamps.GetFieldData().GetArray(arrays.CANDELA_POLES).GetTuple1(k) == 1})
    return found


def albedo_tables(specular, alpha):
    """The lobes that there are, and which one each triangle has."""
    kinds, lobe = np.unique(np.stack([specular, alpha], axis=1), axis=0, return_inverse=True)
    albedo = np.array([lobe_albedo(*kind, KERNEL_TABLE, KERNEL_STEPS) for kind in kinds])
    return {"lobe": lobe.ravel(), "albedo": albedo, "albedo_mean": np.array([mean_albedo(one) for one in albedo])}
