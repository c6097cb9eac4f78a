# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance at receivers by bidirectional path tracing, a program independent of Kalos: means over samples, per receiver.

Light that comes to the receivers through small openings alone is followed from there: a place on the opening is drawn, what
arrives at it is traced backwards, and where that goes on the receivers' side forwards. Several openings in a row are passed in stages.
"""
import numpy as np

from tracer_highlights import highlight
from tracer_paths import LONGEST, WIDTH, lamp_cosine, lamp_density, light_part, pick, receiver_part, to_receiver, walk
from tracer_scene import LAMBERTIAN, RECTANGLE, TRIANGLE, bands, read
from tracer_stages import in_stages
from tracer_surface import add, cosine_direction, dot, fast, scaled, vector, visible

LUMINOUS_SHARES = {1: (1.0,), 3: (0.2126, 0.7152, 0.0722)}  # of bands


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
    return s.lamp_flux.sum() * leaving * here / d2 / (1 + rival)


@fast
def illuminance(s, places, normals, samples, seed):
    """Means at all receivers."""
    np.random.seed(seed)
    vertices, found = np.empty((LONGEST, WIDTH)), np.zeros(len(places))
    for r in range(len(places)):
        place, normal = vector(places, r), vector(normals, r)
        total = 0.0
        for _ in range(samples):
            count = light_part(s, vertices)
            for k in range(count):
                total += to_receiver(s, vertices[k], place, normal, k == 0, True)
            direction = cosine_direction(normal)
            cosine = dot(normal, direction)
            if cosine > 0:
                total += receiver_part(s, place, direction, np.pi, np.pi / cosine, vertices, count)
            total += area_lamps(s, place, normal, True)
            if s.apart:
                total += highlight(s, place, normal)
        found[r] = total / samples + point_lamps(s, place, normal)
    return found


@fast
def on_portal(portals):
    """A point drawn evenly over all portals, the normal there, and their area."""
    total, chosen = 0.0, 0
    for k in range(len(portals)):
        area = np.sqrt(dot(vector(portals[k], 1), vector(portals[k], 1)) * dot(vector(portals[k], 2), vector(portals[k], 2)))
        total += area
        if np.random.random() * total < area:
            chosen = k
    portal = portals[chosen]
    place = add(add(vector(portal, 0), np.random.random(), vector(portal, 1)), np.random.random(), vector(portal, 2))
    return place, vector(portal, 3), total


@fast
def through_portals(s, portals, places, normals, samples, seed):
    """Means at all receivers of what comes through the portals, which have right angles and normals towards the receivers."""
    np.random.seed(seed)
    vertices, onward, found = np.empty((LONGEST, WIDTH)), np.empty((LONGEST, WIDTH)), np.zeros(len(places))
    for _ in range(samples):
        count = light_part(s, vertices)
        x, m, area = on_portal(portals)
        direction = cosine_direction(m)
        luminance = receiver_part(s, x, scaled(-1.0, direction), 1.0, 0.0, vertices, count)
        after = walk(s, portals, x, direction, luminance * np.pi * area, 0.0, 0.0, onward) if luminance > 0 else 0
        after = hand_on(s, onward, after, places, normals, found)
        after = walk_from_lamp(s, portals, x, m, area, onward)
        hand_on(s, onward, after, places, normals, found)
        for r in range(len(places)):
            place, normal = vector(places, r), vector(normals, r)
            to = add(x, -1.0, place)
            d2 = dot(to, to)
            to = scaled(1 / np.sqrt(d2), to)
            here, there = dot(normal, to), -dot(m, to)
            if here > 0 and there > 0 and visible(s, place, x):
                found[r] += receiver_part(s, x, to, 1.0, 0.0, vertices, count) * here * there / d2 * area
            found[r] += area_lamps(s, place, normal, False)
    found /= samples
    for r in range(len(places)):
        found[r] += point_lamps(s, vector(places, r), vector(normals, r))
    return found


@fast
def hand_on(s, vertices, count, places, normals, found):
    """Adds what vertices send to the receivers."""
    for k in range(count):
        for r in range(len(places)):
            found[r] += to_receiver(s, vertices[k], vector(places, r), vector(normals, r), False, False)
    return 0


@fast
def walk_from_lamp(s, portals, x, m, area, onward):
    """Light that comes straight from a luminaire to x: its vertices behind the portal."""
    k, point, _ = pick(s)
    if s.lamp_kind[k] == TRIANGLE:
        return 0
    to = add(x, -1.0, point)
    d2 = dot(to, to)
    to = scaled(1 / np.sqrt(d2), to)
    cosine, leaving = dot(m, to), lamp_density(s, k, to)
    if not (cosine > 0 and leaving > 0 and visible(s, point, x)):
        return 0
    return walk(s, portals, x, to, s.lamp_flux.sum() * leaving * cosine / d2 * area, 0.0, 0.0, onward)


class Tracer:
    """A room's scene, traced in batches of so many samples (per receiver, or per opening)."""

    def __init__(self, room):
        scene, places = room.traced or room.scene, room.receivers
        self.places, self.normals = np.ascontiguousarray(places[:, :3], float), np.ascontiguousarray(places[:, 3:], float)
        corners = [[np.array(one, float) for one in portal] for portal in room.portals]
        self.portals = np.array([[o, u, v, np.cross(u, v) / np.linalg.norm(np.cross(u, v))] for o, u, v in corners]).reshape(-1, 4, 3)
        self.shares = LUMINOUS_SHARES[bands(scene)]
        self.arrays = [read(scene, room.files, band) for band in range(len(self.shares))]

    def batch(self, samples, number):
        """Illuminance at the receivers, lx. Every number has its own random numbers."""
        found = np.zeros(len(self.places))
        for band, (share, arrays) in enumerate(zip(self.shares, self.arrays)):
            seed = number * len(self.shares) + band
            if len(self.portals) > 1:
                found += share * in_stages(arrays, self.portals, self.places, self.normals, samples, seed)
            elif len(self.portals):
                found += share * through_portals(arrays, self.portals, self.places, self.normals, samples, seed)
            else:
                found += share * illuminance(arrays, self.places, self.normals, samples, seed)
        return found
