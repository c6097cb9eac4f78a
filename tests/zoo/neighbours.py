# SPDX-License-Identifier: BSD-3-Clause
"""Dim rooms beside bright ones in one scene: trajectories go where the light is, not where the receivers are."""
import numpy as np

from closed import furnace, integrating_sphere
from room import Room
from shapes import box, joined, lamp, obj, quad, room_places, scene, shell, sphere

HALL = shell((20, 20, 8), "white", (5, 0, 0), "hall-")
FLOOD = lamp((15, 9, 6), 1e6, name="flood")


def glowing_closet(name):
    """A white furnace of 1 lm beside a hall of 1e6 lm."""
    size, exitance, grey = (1, 1, 2), 0.1, 0.5
    surfaces = [*shell(size, "glow", name="closet-"), *HALL]
    return Room(name, "closet beside a hall", scene({"glow": {"reflectance": grey, "exitance": exitance}, "white": 0.7}, surfaces, [FLOOD]),
                room_places(size), "closed form: white furnace, M0/(1 - rho) everywhere", furnace(grey, exitance))


def sphere_closet(name):
    """An integrating sphere with a lamp of 1 lm beside a hall of 1e6 lm."""
    radius, position, grey = 0.6, (0.1, -0.2, 1.1), 0.6
    points, faces = sphere(radius, 4, center=(0, 0, 1))
    middles = points[faces].mean(axis=1)
    normals = np.array([0, 0, 1]) - middles
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    receivers = joined(*([[*middles[i], *normals[i]]] for i in range(50, len(faces), len(faces) // 12)))
    surfaces = [{"name": "closet", "file": "closet.obj", "material": "grey"}, *HALL]
    return Room(name, "closet beside a hall", scene({"grey": grey, "white": 0.7}, surfaces, [lamp(position, 1.0), FLOOD]), receivers,
                "closed form: integrating sphere, Phi/(4 pi R2) rho/(1 - rho) and the lamp's own light; the mesh has its area",
                integrating_sphere(1.0, np.array(position), radius, grey), slack=0.003, files={"closet.obj": obj(points, faces)})


CLOSET, TRACED = (1, 1, 2), "path tracer of the zoo, of the receivers' room alone"
DIM = {"white": 0.7, "dim": {"reflectance": 0, "exitance": 10.0}, "bright": {"reflectance": 0, "exitance": 1e6}}


def lit_closet(name):
    """A closet with a lamp of 1 lm beside a hall of 1e6 lm."""
    closet, light = shell(CLOSET, "white", name="closet-"), lamp((0.4, 0.55, 1.6), 1.0)
    return Room(name, "closet beside a hall", scene(DIM, [*closet, *HALL], [light, FLOOD]), room_places(CLOSET), TRACED,
                traced=scene(DIM, closet, [light]))


def panel_closet(name):
    """A closet with a luminous mesh of 1 lm beside a hall with one of 1e6 lm."""
    closet = [*shell(CLOSET, "white", name="closet-"), quad("dim", (0.3, 0.3, 1.95), (0, 0.3162, 0), (0.3162, 0, 0), "dim")]
    bright = quad("bright", (14, 9, 7.9), (0, 1, 0), (1, 0, 0), "bright")
    return Room(name, "closet beside a hall", scene(DIM, [*closet, *HALL, bright]), room_places(CLOSET), TRACED, traced=scene(DIM, closet))


def next_to(name, ratio):
    """A room of 100 lm beside one of `ratio` times as much: one floor under both, a thin wall between."""
    size = (3, 3, 2.5)
    floor = quad("floor", (0, 0, 0), (6, 0, 0), (0, 3, 0), "white")
    dim = shell(size, "white", leave=("floor",))
    bright = shell(size, "white", (3, 0, 0), "bright-", leave=("floor", "left"))
    lamps = [lamp((1.3, 1.6, 2.0), 100.0, name="dim"), lamp((4.4, 1.2, 2.0), 100.0 * ratio, name="bright")]
    return Room(name, "dim room beside a bright one", scene(DIM, [floor, *dim, *bright], lamps), room_places(size), TRACED,
                traced=scene(DIM, [*dim, floor], lamps[:1]))


def hut(name):
    """A windowless hut with a room lamp on ground that stadium lights light."""
    size, ground = (3, 4, 2.5), quad("ground", (-40, -40, 0), (80, 0, 0), (0, 80, 0), "grass")
    materials = {"grass": 0.2, "wood": 0.5}
    walls, light = shell(size, "wood", leave=("floor",)), lamp((1.3, 1.7, 2.1), 800.0, "lambertian")
    masts = [lamp((x, y, 25), 5e5, "lambertian", (1.5 - x, 2 - y, -25), f"mast{i}")
             for i, (x, y) in enumerate([(-30, -25), (33, -25), (33, 29), (-30, 29)])]
    return Room(name, "hut under stadium lights", scene(materials, [ground, *walls], [light, *masts]), room_places(size), TRACED,
                traced=scene(materials, [ground, *walls], [light]))


def building(name, columns, rows):
    """Lit rooms with furniture on one storey; receivers in one of them."""
    size, surfaces, lamps = (4, 3, 2.5), [], []
    for i in range(columns):
        for j in range(rows):
            x, y, word = 4.1 * i, 3.1 * j, f"room{i}-{j}-"
            surfaces += shell(size, "white", (x, y, 0), word) + [box(word + "desk", (x + 2.6, y + 0.6, 0.4), (1.2, 0.7, 0.8), "white", 20)]
            lamps.append(lamp((x + 1.7, y + 1.4, 2.2), 1500.0, "lambertian", name=word + "lamp"))
    here, count = columns // 2 * rows + rows // 2, rows * columns
    mine = surfaces[7 * here:7 * (here + 1)]
    receivers = room_places(size, (4.1 * (here // rows), 3.1 * (here % rows), 0))
    return Room(name, f"building of {count} rooms", scene(DIM, surfaces, lamps), receivers, TRACED,
                traced=scene(DIM, mine, lamps[here:here + 1]), ordinary=count == 1)


ROOMS = [glowing_closet("closet-glowing"), sphere_closet("closet-sphere"), lit_closet("closet-lamps"), panel_closet("closet-panels"),
         hut("hut"), next_to("next-to-1e3", 1e3), next_to("next-to-1e5", 1e5), building("building-1", 1, 1), building("building-40", 8, 5)]
