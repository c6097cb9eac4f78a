# SPDX-License-Identifier: BSD-3-Clause
"""Bidirectional path tracing from lamps and receivers, compiled by numba.

Every path from a lamp to a receiver is found in all ways that split it into a part drawn from the lamp and one drawn from the
receiver; the balance heuristic weighs them. Its sums over the ways are carried along as in I. Georgiev, "Implementing vertex
connection and merging" (2012): `vcm` and `vc` there are `first` and `rest` here. Roulette ends paths on what is absorbed.
"""
import numpy as np

from tracer_scene import ISOTROPIC, RECTANGLE, TRIANGLE
from tracer_surface import NEAR, add, cosine_direction, dot, fast, hit, lobe, reflection, scaled, scatter, vector, visible

LONGEST = 512  # vertices of a part; longer ones have never been seen at reflectances up to 0.95
PLACE, NORMAL, BACK, FLUX, FIRST, REST, FACE = 0, 3, 6, 9, 10, 11, 12  # columns of a vertex
WIDTH = 13


@fast
def pick(s):
    """A lamp in proportion to its flux, a point on it, and the density of both (1/m2; of points: 1)."""
    k = min(np.searchsorted(s.lamp_sum, np.random.random()), len(s.lamp_flux) - 1)
    share = s.lamp_flux[k] / s.lamp_total
    a, b = np.random.random(), np.random.random()
    if s.lamp_kind[k] == TRIANGLE and a + b > 1:
        a, b = 1 - a, 1 - b
    place = add(add(vector(s.lamp_place, k), a, vector(s.lamp_u, k)), b, vector(s.lamp_v, k))
    return k, place, share / s.lamp_area[k]


@fast
def lamp_density(s, k, direction):
    """Density per sr with which light of lamp k leaves in a direction."""
    if s.lamp_kind[k] == ISOTROPIC:
        return 1 / (4 * np.pi)
    return max(0.0, dot(vector(s.lamp_axis, k), direction)) / np.pi


@fast
def lamp_cosine(s, k, direction):
    return dot(vector(s.lamp_axis, k), direction) if s.lamp_kind[k] >= RECTANGLE else 1.0


@fast
def step(s, place, direction, first, rest):
    """Follows a ray: face (-1: none), point, normal towards the ray, distance; the sums divided by what the arrival costs."""
    face, distance = hit(s, place, direction, 1e30, False)
    if face < 0:
        return face, place, place, first, rest
    n = vector(s.normal, face)
    if dot(n, direction) > 0:
        n = scaled(-1.0, n)
    cosine = max(1e-30, -dot(n, direction))
    return face, add(place, distance, direction), n, first * distance * distance / cosine, rest / cosine


@fast
def turn(s, face, n, back, first, rest):
    """The next direction of a part: kind (0 ended, 1 drawn, 2 mirrored), direction, weight, and the sums after it."""
    kind, onward = scatter(s, face, n, back)
    if kind == 0:
        return kind, onward, 0.0, first, rest
    cosine = dot(n, onward)
    if kind == 2:
        return kind, onward, 1.0, 0.0, rest * cosine
    f, forward, backward = reflection(s, face, n, onward, back)
    if forward <= 0:
        return 0, onward, 0.0, first, rest
    return kind, onward, f * cosine / forward, 1 / forward, cosine / forward * (rest * backward + first)


@fast
def passes(portals, start, direction, end):
    """Whether a ray passes a portal between two points, the first of which may lie on one."""
    for portal in portals:
        corner, u, v, n = vector(portal, 0), vector(portal, 1), vector(portal, 2), vector(portal, 3)
        slope = dot(direction, n)
        if slope == 0:
            continue
        to = add(corner, -1.0, start)
        t = dot(to, n) / slope
        if NEAR < t and t * t < dot(add(end, -1.0, start), add(end, -1.0, start)):
            at = add(scaled(t, direction), -1.0, to)
            if 0 <= dot(at, u) <= dot(u, u) and 0 <= dot(at, v) <= dot(v, v):
                return True
    return False


@fast
def light_part(s, vertices):
    """Draws the part from a lamp and leaves its vertices; returns how many."""
    k, place, density = pick(s)
    if s.lamp_kind[k] == ISOTROPIC:
        z, phi = 2 * np.random.random() - 1, 2 * np.pi * np.random.random()
        r = np.sqrt(max(0.0, 1 - z * z))
        direction = (r * np.cos(phi), r * np.sin(phi), z)
    else:
        direction = cosine_direction(vector(s.lamp_axis, k))
    leaving = lamp_density(s, k, direction)
    if leaving <= 0:
        return 0
    flux = s.lamp_total
    first = 1 / leaving
    rest = lamp_cosine(s, k, direction) / (density * leaving) if s.lamp_kind[k] == TRIANGLE else 0.0
    return walk(s, place, direction, flux, first, rest, vertices)


@fast
def walk(s, place, direction, flux, first, rest, vertices):
    """Vertices of light that leaves a place in a direction."""
    count = 0
    while count < LONGEST:
        face, place, n, first, rest = step(s, place, direction, first, rest)
        if face < 0:
            break
        back = scaled(-1.0, direction)
        v = vertices[count]
        for k in range(3):
            v[PLACE + k], v[NORMAL + k], v[BACK + k] = place[k], n[k], back[k]
        v[FLUX], v[FIRST], v[REST], v[FACE] = flux, first, rest, face
        count += 1
        kind, direction, weight, first, rest = turn(s, face, n, back, first, rest)
        if kind == 0:
            break
        flux *= weight
    return count


@fast
def read(v):
    return (v[0], v[1], v[2]), (v[3], v[4], v[5]), (v[6], v[7], v[8]), v[FLUX], v[FIRST], v[REST], int(v[FACE])


@fast
def to_receiver(s, v, place, normal, lit, rivals):
    """Illuminance at a receiver from a light vertex. `lit`: it is the lamp's first; `rivals`: rays from the receiver find it as well."""
    point, n, back, flux, first, rest, face = read(v)
    to = add(place, -1.0, point)
    d2 = dot(to, to)
    if d2 == 0:
        return 0.0
    to = scaled(1 / np.sqrt(d2), to)
    here, there = -dot(normal, to), dot(n, to)
    if here <= 0 or there <= 0:
        return 0.0
    f, forward, backward = reflection(s, face, n, to, back)
    if lit and s.apart:
        f -= lobe(s, face, n, to, back)
    if f <= 0 or not visible(s, point, place):
        return 0.0
    weight = 1 / (1 + here * there / (np.pi * d2) * (first + rest * backward)) if rivals else 1.0
    return flux * f * here * there / d2 * weight


@fast
def connect(s, v, face, place, n, back, first, rest):
    """Transport from a light vertex to a vertex of the receiver's part."""
    point, ln, lback, flux, lfirst, lrest, lface = read(v)
    to = add(place, -1.0, point)
    d2 = dot(to, to)
    if d2 == 0:
        return 0.0
    to = scaled(1 / np.sqrt(d2), to)
    here, there = -dot(n, to), dot(ln, to)
    if here <= 0 or there <= 0:
        return 0.0
    lf, lforward, lbackward = reflection(s, lface, ln, to, lback)
    f, forward, backward = reflection(s, face, n, scaled(-1.0, to), back)
    if lf <= 0 or f <= 0 or not visible(s, point, place):
        return 0.0
    # `forward` of a pair draws the direction to the other vertex from the one that its part came from.
    from_here, from_there = forward * there / d2, lforward * here / d2
    others = from_here * (lfirst + lrest * lbackward) + from_there * (first + rest * backward)
    return flux * lf * f * here * there / d2 / (1 + others)


@fast
def next_event(s, face, place, n, back, first, rest, seen):
    """Light of one lamp at a vertex of the receiver's part, reflected along it. `seen`: it is the receiver's first."""
    k, point, density = pick(s)
    to = add(point, -1.0, place)
    d2 = dot(to, to)
    if d2 == 0:
        return 0.0
    to = scaled(1 / np.sqrt(d2), to)
    here, leaving = dot(n, to), lamp_density(s, k, scaled(-1.0, to))
    if here <= 0 or leaving <= 0:
        return 0.0
    f, forward, backward = reflection(s, face, n, to, back)
    if seen and s.apart:
        f -= lobe(s, face, n, to, back)
    if f <= 0 or not visible(s, place, point):
        return 0.0
    at_lamp = lamp_cosine(s, k, scaled(-1.0, to))
    others = leaving * here / d2 * (first + rest * backward)
    if s.lamp_kind[k] == TRIANGLE:
        others += forward * at_lamp / (d2 * density)
    # Flux times density of leaving over cosine is intensity over area: of points the density is 1.
    return s.lamp_total * leaving * f * here / d2 / (1 + others)


@fast
def receiver_part(s, place, direction, beta, first, vertices, count):
    """What the part that starts with this ray gathers. `first` is 0 for a given ray, 1/density for one that was drawn."""
    total, rest = 0.0, 0.0
    share = 1 / s.lamp_total
    for depth in range(LONGEST):
        face, place, n, first, rest = step(s, place, direction, first, rest)
        if face < 0:
            break
        back = scaled(-1.0, direction)
        if s.emitter[face] >= 0 and dot(vector(s.normal, face), back) > 0:
            leaving = dot(n, back) / np.pi
            density = s.exitance[face] * share  # of picking the point, 1/m2
            total += beta * s.exitance[face] / np.pi / (1 + density * (first + leaving * rest))
        if s.reflectance[face] > 0 or s.gloss[face] >= 0:
            total += beta * next_event(s, face, place, n, back, first, rest, depth == 0)
            for k in range(count):
                total += beta * connect(s, vertices[k], face, place, n, back, first, rest)
        kind, direction, weight, first, rest = turn(s, face, n, back, first, rest)
        if kind == 0:
            break
        beta *= weight
    return total
