# SPDX-License-Identifier: BSD-3-Clause
"""Light that has to pass small openings, followed from there.

A place on the first portal is drawn, and what arrives at it is traced backwards, in the whole scene; where it goes on is traced
forwards, until it passes that portal again, as what comes back has been traced backwards then. Of several portals in a row the
light walks in stages: what passes the next one for the first time is kept, and as many walks start from there, drawn from it in
proportion to their flux (splitting).
"""
import numpy as np

from tracer_direct import area_lamps, point_lamps
from tracer_paths import LONGEST, WIDTH, lamp_density, light_part, passes, pick, receiver_part, to_receiver
from tracer_scene import TRIANGLE
from tracer_surface import add, cosine_direction, dot, fast, hit, reflection, scaled, scatter, vector, visible


@fast
def arriving(s, portal, x, vertices, count):
    """Flux that arrives at a point drawn evenly from a portal, and its direction: by reflection, or straight from a luminaire."""
    m, u, v = vector(portal, 3), vector(portal, 1), vector(portal, 2)
    twice = 2 * np.sqrt(dot(u, u) * dot(v, v))  # its sides are at right angles; each way is taken half of the times
    if np.random.random() < 0.5:
        direction = cosine_direction(m)
        return twice * np.pi * receiver_part(s, x, scaled(-1.0, direction), 1.0, 0.0, vertices, count), direction
    k, point, _ = pick(s)
    to = add(x, -1.0, point)
    d2 = dot(to, to)
    to = scaled(1 / np.sqrt(d2), to)
    cosine, leaving = dot(m, to), lamp_density(s, k, to)
    if s.lamp_kind[k] == TRIANGLE or not (cosine > 0 and leaving > 0 and visible(s, point, x)):
        return 0.0, to
    return twice * s.lamp_total * leaving * cosine / d2, to


@fast
def on_portal(portal):
    return add(add(vector(portal, 0), np.random.random(), vector(portal, 1)), np.random.random(), vector(portal, 2))


@fast
def seen_through(s, portal, x, place, normal, vertices, count):
    """What a receiver sees through a point of a portal."""
    to = add(x, -1.0, place)
    d2 = dot(to, to)
    to = scaled(1 / np.sqrt(d2), to)
    here, there, u, v = dot(normal, to), -dot(vector(portal, 3), to), vector(portal, 1), vector(portal, 2)
    if here <= 0 or there <= 0 or not visible(s, place, x):
        return 0.0
    return receiver_part(s, x, to, 1.0, 0.0, vertices, count) * here * there / d2 * np.sqrt(dot(u, u) * dot(v, v))


@fast
def follow(s, portals, stage, start, flux, vertex, places, normals, found):
    """Walks on until the portal of a stage is passed: leaves place and direction there in `start` and returns the flux, else 0.

    The vertices of the last two stages send light to the receivers, which no earlier one sees.
    """
    place, direction = (start[0], start[1], start[2]), (start[3], start[4], start[5])
    for _ in range(LONGEST):
        face, distance = hit(s, place, direction, 1e30, False)
        end = add(place, distance, direction)
        if face < 0 or passes(portals[:1], place, direction, end):
            return 0.0
        if passes(portals[stage:stage + 1], place, direction, end):
            n = vector(portals[stage], 3)
            x = add(place, dot(add(vector(portals[stage], 0), -1.0, place), n) / dot(direction, n), direction)
            for c in range(3):
                start[c], start[3 + c] = x[c], direction[c]
            return flux
        place, n, back = end, vector(s.normal, face), scaled(-1.0, direction)
        if dot(n, direction) > 0:
            n = scaled(-1.0, n)
        if stage >= len(portals) - 1:
            for c in range(3):
                vertex[c], vertex[3 + c], vertex[6 + c] = place[c], n[c], back[c]
            vertex[9], vertex[10], vertex[11], vertex[12] = flux, 0.0, 0.0, face
            for r in range(len(places)):
                found[r] += to_receiver(s, vertex, vector(places, r), vector(normals, r), False, False)
        kind, direction = scatter(s, face, n, back)
        if kind == 0:
            return 0.0
        if kind == 1:
            f, forward, _ = reflection(s, face, n, direction, back)
            flux *= f * dot(n, direction) / forward
    return 0.0


@fast
def split(starts, flux, samples):
    """Draws as many starts as there were samples, all of the same flux, from those that have some."""
    kept = starts.copy()
    sums = np.cumsum(flux)
    total = sums[-1]
    for i in range(samples):
        starts[i] = kept[min(np.searchsorted(sums, np.random.random() * total), samples - 1)]
    flux[:] = total / samples


@fast
def through_portals(s, portals, places, normals, samples, seed):
    """Means at all receivers of direct light and of what comes through the portals, whose normals point onward."""
    np.random.seed(seed)
    starts, flux, found = np.empty((samples, 6)), np.empty(samples), np.zeros(len(places))
    vertices, vertex = np.empty((LONGEST, WIDTH)), np.empty(WIDTH)
    for i in range(samples):
        count = light_part(s, vertices)
        x = on_portal(portals[0])
        arrived, direction = arriving(s, portals[0], x, vertices, count)
        flux[i] = arrived / samples
        for c in range(3):
            starts[i, c], starts[i, 3 + c] = x[c], direction[c]
        for r in range(len(places)):
            place, normal = vector(places, r), vector(normals, r)
            found[r] += area_lamps(s, place, normal, False) / samples
            if len(portals) == 1:
                found[r] += seen_through(s, portals[0], x, place, normal, vertices, count) / samples
    for stage in range(1, len(portals) + 1):
        if flux.sum() == 0:
            break
        split(starts, flux, samples)
        for i in range(samples):
            flux[i] = follow(s, portals, stage, starts[i], flux[i], vertex, places, normals, found)
    for r in range(len(places)):
        found[r] += point_lamps(s, vector(places, r), vector(normals, r))
    return found
