# SPDX-License-Identifier: BSD-3-Clause
"""Highlights: light of a point lamp that one glossy triangle's lobe sends straight to a receiver.

Neither rays from the lamp nor from the receiver are drawn by the lobe there, so places are drawn about the mirror point of the
triangle's plane, as wide as the lobe makes the highlight, half of them; the others evenly over the triangle.
"""
import numpy as np

from tracer_paths import lamp_density
from tracer_surface import add, cross, dot, fast, lobe, scaled, unit, vector, visible


@fast
def highlight(s, place, normal):
    """One sample per glossy triangle of one point lamp."""
    k = min(np.searchsorted(s.lamp_sum, np.random.random()), len(s.lamp_flux) - 1)
    lamp, total = vector(s.lamp_place, k), 0.0
    for i in range(len(s.gloss)):
        if s.gloss[i] >= 0:
            total += from_triangle(s, i, k, lamp, place, normal)
    return total * s.lamp_total / s.lamp_flux[k]


@fast
def from_triangle(s, i, k, lamp, place, normal):
    n, corner = vector(s.normal, i), vector(s.corner, i)
    up, over = dot(add(place, -1.0, corner), n), dot(add(lamp, -1.0, corner), n)
    if up * over <= 0:
        return 0.0
    if up < 0:
        n, up, over = scaled(-1.0, n), -up, -over
    # The mirror point, and the two axes of the highlight about it, per unit of slope of the micro-normal.
    between = add(lamp, -1.0, place)
    foot, along = add(place, -up, n), add(between, -dot(between, n), n)
    middle = add(foot, up / (up + over), along)
    length = np.sqrt(dot(along, along))
    e1 = scaled(1 / length, along) if length > 0 else unit(vector(s.side_u, i))
    e2 = cross(n, e1)
    to_place, to_lamp = np.hypot(up, length * up / (up + over)), np.hypot(over, length * over / (up + over))
    cosine, harmonic = up / to_place, 2 / (1 / to_place + 1 / to_lamp)
    a, b = s.alpha[i] * harmonic / cosine, s.alpha[i] * harmonic * cosine
    u, v = vector(s.side_u, i), vector(s.side_v, i)
    area = np.sqrt(dot(cross(u, v), cross(u, v))) / 2
    if np.random.random() < 0.5:
        share = np.random.random()
        radius, phi = np.sqrt(share / (1 - share)), 2 * np.pi * np.random.random()
        x = add(add(middle, a * radius * np.cos(phi), e1), b * radius * np.sin(phi), e2)
        if not inside(corner, u, v, x):
            return 0.0
    else:
        p, q = np.random.random(), np.random.random()
        if p + q > 1:
            p, q = 1 - p, 1 - q
        x = add(add(corner, p, u), q, v)
    off = add(x, -1.0, middle)
    squared = (dot(off, e1) / a) ** 2 + (dot(off, e2) / b) ** 2
    density = 0.5 / (np.pi * a * b * (1 + squared) ** 2) + 0.5 / area
    return arriving(s, i, k, lamp, place, normal, n, x) / density


@fast
def inside(corner, u, v, x):
    to = add(x, -1.0, corner)
    uu, uv, vv, ut, vt = dot(u, u), dot(u, v), dot(v, v), dot(u, to), dot(v, to)
    determinant = uu * vv - uv * uv
    p, q = (vv * ut - uv * vt) / determinant, (uu * vt - uv * ut) / determinant
    return p >= 0 and q >= 0 and p + q <= 1


@fast
def arriving(s, i, k, lamp, place, normal, n, x):
    """Illuminance at the receiver per area of the triangle at x."""
    to_lamp, to_place = add(lamp, -1.0, x), add(place, -1.0, x)
    l2, p2 = dot(to_lamp, to_lamp), dot(to_place, to_place)
    to_lamp, to_place = scaled(1 / np.sqrt(l2), to_lamp), scaled(1 / np.sqrt(p2), to_place)
    here = -dot(normal, to_place)
    f = lobe(s, i, n, to_lamp, to_place)
    leaving = lamp_density(s, k, scaled(-1.0, to_lamp))
    if here <= 0 or f <= 0 or leaving <= 0 or not (visible(s, x, place) and visible(s, x, lamp)):
        return 0.0
    return s.lamp_flux[k] * leaving * dot(n, to_lamp) / l2 * f * dot(n, to_place) * here / p2
