# SPDX-License-Identifier: BSD-3-Clause
"""Dim rooms beside bright ones in one scene: trajectories go where the light is, not where the receivers are."""
import numpy as np

from closed import furnace, integrating_sphere
from room import Room
from shapes import joined, lamp, obj, room_places, scene, shell, sphere

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


ROOMS = [glowing_closet("closet-glowing"), sphere_closet("closet-sphere")]
