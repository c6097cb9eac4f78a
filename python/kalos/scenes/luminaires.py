# SPDX-License-Identifier: BSD-3-Clause
"""Luminaires from NumPy arrays and photometric files, as vtkPolyData with the arrays that the filters read.

Lengths are metres, flux is in lumens. Whatever is wrong with an argument is a ValueError that names it.
"""
from __future__ import annotations

import os
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.core import arrays
from kalos.errors import InputError
from kalos.scenes.candela_tables import from_file
from kalos.scenes.checks import non_empty, numbers, refuse, within
from kalos.scenes.defaults import DISTRIBUTIONS
from kalos.scenes.geometry import of_each, poly_data, put
from kalos.scenes.joined import joined_luminaires


def luminaire(position: ArrayLike, flux: Optional[ArrayLike] = None, aim: ArrayLike = (0, 0, -1), distribution: str = "lambertian", *,
              file: Union[None, str, os.PathLike[str]] = None, rotation_deg: float = 0.0, lamp_set: int = 1) -> vtkPolyData:
    """Point luminaires: position (3,) or (n, 3), m; flux a number or (n,), lm; aim (3,) or (n, 3), of any length.

    distribution: "lambertian", I = flux/pi cos about the aim, or "isotropic", I = flux/(4 pi).
    file: a photometric file, IES LM-63 or EULUMDAT, that gives the distribution, the luminous opening and, where flux is None,
    the flux. rotation_deg: of such luminaires about their aim, counter-clockwise as seen from behind; without it C = 0 is along
    +x where they look down. lamp_set: of an EULUMDAT file, from 1. Several files are several calls and a list of the results.

    >>> lamps = luminaire([(1, 1.5, 2.9), (3, 1.5, 2.9)], 2000)
    >>> lamps.GetNumberOfPoints()
    2
    """
    if file is None and flux is None:
        raise InputError("flux: is missing, expected lumens, or a file that tells them")
    if distribution not in DISTRIBUTIONS:
        raise InputError(f"distribution: is {distribution!r}, expected one of {', '.join(DISTRIBUTIONS)}")
    if file is None:
        return lamps("position", position, flux, aim, distribution, np.zeros(3), np.zeros(3))
    return measured(position, flux, aim, os.fspath(file), rotation_deg, lamp_set)


def measured(position, flux, aim, file, rotation_deg, lamp_set):
    """Luminaires of one photometric file; the file is asked for each, as its tilt factor depends on the aim."""
    places, flux, aim = checked("position", position, 0.0 if flux is None else flux, aim)
    flux, aim = of_each(flux, "flux", len(places)), of_each(aim, "aim", len(places), 3)
    turn = float(numbers("rotation_deg", rotation_deg, [()]))
    return joined_luminaires([from_file(file, lamp_set, *one, turn) for one in zip(places, aim, flux)])


def panel(center: ArrayLike, u: ArrayLike, v: ArrayLike, flux: ArrayLike, aim: ArrayLike = (0, 0, -1)) -> vtkPolyData:
    """Luminous rectangles with full sides u and v, m: center (3,) or (n, 3); u, v and aim (3,) or (n, 3); flux a number or
    (n,), lm, which leaves on the side of `aim` by Lambert's law.

    >>> panels = panel([(1, 1, 2.99), (3, 1, 2.99)], (0.6, 0, 0), (0, 0.6, 0), 3600)
    """
    u, v = (numbers(name, value, [(3,), ("n", 3)]) for name, value in (("u", u), ("v", v)))
    across = np.cross(u, v)
    if not (np.linalg.norm(across, axis=-1) > 0).all():
        refuse("v", v, " and spans no area with u", "a side at a right angle to u")
    if (np.abs((u * v).sum(axis=-1)) > 1e-6 * np.linalg.norm(u, axis=-1) * np.linalg.norm(v, axis=-1)).any():
        refuse("v", v, " and is not at a right angle to u", "a rectangle")
    aimed = numbers("aim", aim, [(3,), ("n", 3)])
    lengths = np.linalg.norm(across, axis=-1) * np.linalg.norm(aimed, axis=-1)
    if not (np.abs((across * aimed).sum(axis=-1)) > (1 - 1e-6) * lengths).all():
        refuse("aim", aimed, " and is not at a right angle to u and v", "u x v or its opposite")
    return lamps("center", center, flux, aimed, "lambertian", u, v)


def checked(name, position, flux, aim):
    """Places (n, 3), flux and aim as arrays that can be used."""
    places = np.atleast_2d(non_empty(name, numbers(name, position, [(3,), ("n", 3)])))
    flux = within("flux", numbers("flux", flux, [(), ("n",)]), 0, np.inf, "lumens >= 0")
    aim = numbers("aim", aim, [(3,), ("n", 3)])
    if not (np.linalg.norm(aim, axis=-1) > 0).all():
        refuse("aim", aim, " and is zero", "a direction")
    return places, flux, aim


def lamps(name, position, flux, aim, distribution, u, v):
    places, flux, aim = checked(name, position, flux, aim)
    count = len(places)
    result = poly_data(places)
    data = result.GetPointData()
    put(data, arrays.LUMINOUS_FLUX, of_each(flux, "flux", count))
    for key, label, vectors in ((arrays.DIRECTION, "aim", aim), (arrays.SIDE_U, "u", u), (arrays.SIDE_V, "v", v)):
        put(data, key, of_each(vectors, label, count, 3))
    put(data, arrays.DISTRIBUTION, np.full(count, DISTRIBUTIONS[distribution], np.int32))
    return result
