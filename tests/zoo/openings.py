# SPDX-License-Identifier: BSD-3-Clause
"""Dark rooms behind small openings, which few rays and trajectories find."""
import numpy as np

from room import Room
from shapes import lamp, quad, room_places, scene, shell

SIZE, MATERIALS = (3, 3, 2.5), {"white": 0.7, "sky": {"reflectance": 0, "exitance": 2e4}}
TRACED = "path tracer of the zoo, from the opening on"
BRIGHT = lamp((4.7, 1.9, 2.0), 3000.0)


def partition(hole, width=3, height=2.5, x=3.0):
    """Four parts of a thin wall about a hole (y, z, width, height) in it."""
    y, z, w, h = hole
    parts = [((x, 0, 0), y, height), ((x, y + w, 0), width - y - w, height), ((x, y, 0), w, z), ((x, y, z + h), w, height - z - h)]
    return [quad(f"partition{i}", origin, (0, a, 0), (0, 0, b), "white")
            for i, (origin, a, b) in enumerate(parts) if a > 0 and b > 0]


def behind(name, kind, hole):
    """A dark room and a lit one, a hole in the wall between them."""
    y, z, w, h = hole
    surfaces = [*shell(SIZE, "white", name="dark-", leave=("right",)), *shell(SIZE, "white", (3, 0, 0), "bright-", leave=("left",)),
                *partition(hole)]
    return Room(name, kind, scene(MATERIALS, surfaces, [BRIGHT]), room_places(SIZE), TRACED,
                portals=(((3, y, z), (0, 0, h), (0, w, 0)),))


def labyrinth(name, lanes, width=1.0, length=5.0, height=2.5, gap=0.8):
    """Lanes side by side, walls with a gap at alternating ends; the lamp in the first, receivers in the last."""
    surfaces = shell((lanes * width, length, height), "white")
    for i in range(1, lanes):
        surfaces.append(quad(f"wall{i}", (i * width, 0 if i % 2 else gap, 0), (0, length - gap, 0), (0, 0, height), "white"))
    portals = [((i * width, length - gap if i % 2 else 0, 0), (0, gap, 0), (0, 0, height)) for i in range(1, lanes)]
    return Room(name, "labyrinth", scene(MATERIALS, surfaces, [lamp((0.5, 1.2, 2.0), 3000.0)]),
                room_places((width, length, height), ((lanes - 1) * width, 0, 0))[:12], TRACED, portals=tuple(portals))


def light_well(name, depth):
    """A room under a shaft of 1 m x 1 m with a bright sky over it."""
    room = [*shell((4, 4, 2.5), "white", leave=("ceiling",)),
            *(quad(f"ceiling{i}", (x, y, 2.5), (0, b, 0), (a, 0, 0), "white")
              for i, (x, y, a, b) in enumerate([(0, 0, 4, 1.5), (0, 2.5, 4, 1.5), (0, 1.5, 1.5, 1), (2.5, 1.5, 1.5, 1)]))]
    shaft = shell((1, 1, depth), {"": "white", "ceiling": "sky"}, (1.5, 1.5, 2.5), "shaft-", leave=("floor",))
    return Room(name, "light well", scene(MATERIALS, [*room, *shaft]), room_places((4, 4, 2.5)), TRACED,
                portals=(((1.5, 1.5, 2.5), (0, 1, 0), (1, 0, 0)),))


def louvre(name, blades):
    """A dark and a lit room with slanted blades between them."""
    surfaces = [*shell(SIZE, "white", name="dark-", leave=("right",)),
                *shell(SIZE, "white", (3.1, 0, 0), "bright-", leave=("left",))]
    step = 2.5 / blades
    surfaces += [quad(f"blade{i}", (3, 0, i * step), (0.1, 0, 2 * step), (0, 3, 0), "white") for i in range(blades - 1)]
    surfaces += [quad("sill", (3, 0, 0), (0.1, 0, 0), (0, 3, 0), "white"), quad("lintel", (3, 0, 2.5), (0, 3, 0), (0.1, 0, 0), "white"),
                 quad("jamb-a", (3, 0, 0), (0, 0, 2.5), (0.1, 0, 0), "white"), quad("jamb-b", (3, 3, 0), (0.1, 0, 0), (0, 0, 2.5), "white")]
    return Room(name, "slanted blades", scene(MATERIALS, surfaces, [BRIGHT]), room_places(SIZE), TRACED,
                portals=(((3, 0, 0), (0, 0, 2.5), (0, 3, 0)),))


def duct(name, side=0.3):
    """A dark room that a bent duct of square section joins to a lit one."""
    a = side
    surfaces = [*shell(SIZE, "white", name="dark-", leave=("right",)), *partition((1.2, 1.0, a, a)),
                *shell(SIZE, "white", (4.5, 0, 0), "bright-", leave=("left",)),
                *(one | {"name": "far-" + one["name"]} for one in partition((1.9, 1.0, a, a), x=4.5))]
    # The floor plan: along x from the dark room, across along y, and on along x.
    plan = [(3, 1.2), (3.6 + a, 1.2), (3.6 + a, 1.9), (4.5, 1.9), (4.5, 1.9 + a), (3.6, 1.9 + a), (3.6, 1.2 + a), (3, 1.2 + a)]
    for i, (one, other) in enumerate(zip(plan, plan[1:])):
        along = np.subtract(other, one)
        if i != 3:
            surfaces.append(quad(f"duct{i}", (*one, 1.0), (float(along[0]), float(along[1]), 0), (0, 0, a), "white"))
    for level in (1.0, 1.0 + a):
        word = "bottom" if level == 1.0 else "top"
        surfaces += [quad(f"duct-{word}{i}", (x, y, level), (w, 0, 0), (0, h, 0), "white")
                     for i, (x, y, w, h) in enumerate([(3, 1.2, 0.6, a), (3.6, 1.2, a, 0.7 + a), (3.6 + a, 1.9, 0.9 - a, a)])]
    light = lamp((6.2, 1.9, 2.0), 3000.0)
    portals = (((4.5, 1.9, 1.0), (0, 0, a), (0, a, 0)), ((3.6, 1.7, 1.0), (a, 0, 0), (0, 0, a)), ((3, 1.2, 1.0), (0, 0, a), (0, a, 0)))
    return Room(name, "bent duct", scene(MATERIALS, surfaces, [light]), room_places(SIZE), TRACED, portals=portals)


ROOMS = [behind("door-1cm", "door ajar", (1.2, 0.0, 0.01, 2.0)), behind("door-10cm", "door ajar", (1.2, 0.0, 0.1, 2.0)),
         behind("keyhole", "keyhole", (1.2, 1.0, 0.02, 0.04)), labyrinth("labyrinth-3", 3), labyrinth("labyrinth-7", 7),
         light_well("light-well-3m", 3), louvre("louvre", 25), duct("duct")]
