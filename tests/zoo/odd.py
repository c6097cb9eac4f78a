# SPDX-License-Identifier: BSD-3-Clause
"""Rooms that are odd in other ways: long, white, black, far away, lit from behind."""
import numpy as np

from room import Room
from shapes import grid, joined, lamp, obj, panel, quad, room_places, row, scene, shell, sphere

SIZE, TRACED = (4, 3, 2.5), "path tracer of the zoo"
MATERIALS = {"wall": 0.5, "white": 0.8, "whitest": 0.95, "black": 0.02, "glow": {"reflectance": 0.3, "exitance": 5000.0}}
FACES = {"": "wall", "ceiling": "white"}


def odd(name, kind, surfaces, luminaires=(), receivers=None, files=None):
    return Room(name, kind, scene(MATERIALS, surfaces, luminaires), room_places(SIZE) if receivers is None else receivers, TRACED,
                files=files or {})


def corridor(length=40):
    """Two metres wide, lit at one end; receivers from the lamp to the other end."""
    receivers = joined(row((0.7, 3, 0), (0.7, length - 1, 0), (0, 0, 1), 8), row((0, 3, 1.2), (0, length - 1, 1.2), (1, 0, 0), 6))
    return odd("corridor", "long corridor", shell((2, length, 2.5), FACES), [lamp((1.1, 1.0, 2.2))], receivers)


def card():
    """A black room with one white card, which alone sends light to where the lamp does not."""
    surfaces = [*shell(SIZE, "black"), quad("card", (2.0, 1.2, 0.6), (0.2, 0, 0.05), (0, 0.3, 0), "white"),
                quad("screen", (1.2, 0.2, 1.5), (0, 2.6, 0), (2.0, 0, 0), "black")]
    receivers = joined(grid((1.4, 0.5, 1.49), (0, 2, 0), (1.6, 0, 0), 3, 4))
    return odd("card", "white card in a black room", surfaces, [lamp((0.6, 1.4, 1.2), 1000.0, "lambertian", (1, 0, -0.3))], receivers)


def halo():
    """A luminous disc of triangles that faces the wall 1 cm behind it."""
    turn = 2 * np.pi * np.arange(24) / 24
    vertices = [(0.01, 1.4, 1.3)] + [(0.01, 1.4 + 0.3 * np.cos(a), 1.3 + 0.3 * np.sin(a)) for a in turn]
    disc = obj(vertices, [(0, (i + 1) % 24 + 1, i + 1) for i in range(24)])
    beside = row((0, 1.74, 1.3), (0, 2.6, 1.3), (1, 0, 0), 6)
    return odd("halo", "lit from behind", [*shell(SIZE, FACES), {"name": "disc", "file": "disc.obj", "material": "glow"}], (),
               joined(room_places(SIZE), beside), {"disc.obj": disc})


def globe(radius=0.15, center=(1.9, 1.3)):
    """A luminous ball on the floor; receivers around its contact as well."""
    points, faces = sphere(radius, 3, inwards=False)
    points = points - [0, 0, points[:, 2].min()] + [*center, 0]
    near = [[center[0] + d * np.cos(2.4 * i), center[1] + d * np.sin(2.4 * i), 0, 0, 0, 1]
            for i, d in enumerate(np.geomspace(0.005, 0.5, 8))]
    return odd("globe", "luminous ball on the floor", [*shell(SIZE, FACES), {"name": "globe", "file": "globe.obj", "material": "glow"}], (),
               joined(room_places(SIZE), np.array(near)), {"globe.obj": obj(points, faces)})


def far_away(offset=(3000.0, -2000.0, 500.0)):
    """A plain room kilometres from the origin."""
    light = lamp(np.add(offset, (1.8, 1.3, 2.2)))
    return odd("far-away", "far from the origin", shell(SIZE, FACES, offset), [light], room_places(SIZE, offset))


ROOMS = [
    corridor(), card(), halo(), globe(), far_away(),
    odd("white-room", "reflectance 0.95", shell(SIZE, "whitest"), [lamp((1.8, 1.3, 2.0))]),
    odd("wall-washer", "panel beside a wall", shell(SIZE, FACES), [panel((0.05, 1.4, 2.2), (0.06, 0, 0), (0, 1.0, 0), (0, 0, -1), 2000)]),
    odd("sliver", "flat room", shell((4, 3, 0.05), FACES), [lamp((1.8, 1.3, 0.025))],
        joined(row((1.9, 1.4, 0), (2.6, 1.9, 0), (0, 0, 1), 8), row((1.7, 1.2, 0.05), (1.2, 0.8, 0.05), (0, 0, -1), 6))),
]
