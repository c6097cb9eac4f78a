# SPDX-License-Identifier: BSD-3-Clause
"""Light that has to pass several portals one after the other: walks from the lamps in stages, a stage up to each portal.

What passes a portal for the first time is kept; the next stage starts as many walks as the one before, drawn from it evenly
(splitting). Vertices of the last two stages send light to the receivers, which no earlier one sees.
"""
import numpy as np

from tracer_paths import LONGEST, WIDTH, lamp_density, passes, pick, to_receiver
from tracer_surface import add, cosine_direction, dot, fast, hit, reflection, scaled, scatter, vector


@fast
def emitted(s, out):
    """A ray of light from a lamp: place and direction into out[0:6]; its flux."""
    k, place, _ = pick(s)
    z, phi = 2 * np.random.random() - 1, 2 * np.pi * np.random.random()
    r = np.sqrt(max(0.0, 1 - z * z))
    direction = (r * np.cos(phi), r * np.sin(phi), z) if s.lamp_kind[k] == 0 else cosine_direction(vector(s.lamp_axis, k))
    for c in range(3):
        out[c], out[3 + c] = place[c], direction[c]
    return s.lamp_flux.sum() if lamp_density(s, k, direction) > 0 else 0.0


@fast
def follow(s, portal, start, flux, vertex, places, normals, found, sends):
    """Walks on until the portal is passed: then leaves place and direction there in `start` and returns the flux, else 0."""
    place, direction = (start[0], start[1], start[2]), (start[3], start[4], start[5])
    for _ in range(LONGEST):
        face, distance = hit(s, place, direction, 1e30, False)
        if face < 0:
            return 0.0
        end = add(place, distance, direction)
        if len(portal) and passes(portal, place, direction, end):
            n = vector(portal[0], 3)
            x = add(place, dot(add(vector(portal[0], 0), -1.0, place), n) / dot(direction, n), direction)
            for c in range(3):
                start[c], start[3 + c] = x[c], direction[c]
            return flux
        place, n, back = end, vector(s.normal, face), scaled(-1.0, direction)
        if dot(n, direction) > 0:
            n = scaled(-1.0, n)
        if sends:
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
def in_stages(s, portals, places, normals, samples, seed):
    """Means at all receivers of what comes through the portals in their order. Direct light does not: it would be seen."""
    np.random.seed(seed)
    starts, kept, flux = np.empty((samples, 6)), np.empty((samples, 6)), np.empty(samples)
    found, vertex = np.zeros(len(places)), np.empty(WIDTH)
    for i in range(samples):
        flux[i] = emitted(s, starts[i]) / samples
    for stage in range(len(portals) + 1):
        portal, sends = portals[stage:stage + 1], stage >= len(portals) - 1
        count, total = 0, 0.0
        for i in range(samples):
            passed = follow(s, portal, starts[i], flux[i], vertex, places, normals, found, sends) if flux[i] > 0 else 0.0
            if passed > 0:
                kept[count], flux[count] = starts[i], passed
                count, total = count + 1, total + passed
        if count == 0:
            break
        sums = np.cumsum(flux[:count])
        for i in range(samples):
            starts[i] = kept[min(np.searchsorted(sums, np.random.random() * total), count - 1)]
        flux[:] = total / samples
    return found
