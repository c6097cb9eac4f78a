# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance at receivers by bidirectional path tracing, a program independent of Kalos: means over samples, per receiver.

Light that comes to the receivers through small openings alone is followed from there (tracer_portals.py).
"""
import numpy as np

from tracer_direct import area_lamps, point_lamps
from tracer_highlights import highlight
from tracer_paths import LONGEST, WIDTH, light_part, receiver_part, to_receiver
from tracer_portals import through_portals
from tracer_scene import bands, read
from tracer_surface import cosine_direction, dot, fast, vector

LUMINOUS_SHARES = {1: (1.0,), 3: (0.2126, 0.7152, 0.0722)}  # of bands


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
            if len(self.portals):
                found += share * through_portals(arrays, self.portals, self.places, self.normals, samples, seed)
            else:
                found += share * illuminance(arrays, self.places, self.normals, samples, seed)
        return found
