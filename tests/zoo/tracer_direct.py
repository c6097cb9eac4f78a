# SPDX-License-Identifier: BSD-3-Clause
"""Light that comes to a receiver straight from the lamps."""
import numpy as np

from tracer_paths import lamp_cosine, lamp_density, pick
from tracer_scene import LAMBERTIAN, RECTANGLE, TRIANGLE
from tracer_surface import add, dot, fast, scaled, vector, visible


@fast
def point_lamps(s, place, normal):
    """Direct light of all point luminaires."""
    total = 0.0
    for k in range(len(s.lamp_flux)):
        if s.lamp_kind[k] > LAMBERTIAN:
            continue
        to = add(vector(s.lamp_place, k), -1.0, place)
        d2 = dot(to, to)
        cosine = dot(normal, to) / np.sqrt(d2)
        leaving = lamp_density(s, k, scaled(-1 / np.sqrt(d2), to))
        if cosine > 0 and leaving > 0 and visible(s, place, vector(s.lamp_place, k)):
            total += s.lamp_flux[k] * leaving * cosine / d2
    return total


@fast
def area_lamps(s, place, normal, triangles):
    """One sample of the direct light of areas; that of emitting triangles is weighed against meeting them by a ray."""
    k, point, density = pick(s)
    if s.lamp_kind[k] < RECTANGLE or (s.lamp_kind[k] == TRIANGLE and not triangles):
        return 0.0
    to = add(point, -1.0, place)
    d2 = dot(to, to)
    to = scaled(1 / np.sqrt(d2), to)
    here, leaving = dot(normal, to), lamp_density(s, k, scaled(-1.0, to))
    if not (here > 0 and leaving > 0 and visible(s, place, point)):
        return 0.0
    rival = here * lamp_cosine(s, k, scaled(-1.0, to)) / (np.pi * d2 * density) if s.lamp_kind[k] == TRIANGLE else 0.0
    return s.lamp_total * leaving * here / d2 / (1 + rival)
