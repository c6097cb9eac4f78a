# SPDX-License-Identifier: BSD-3-Clause
"""Lamps near surfaces: direct light that falls as 1/d2 from millimetres on."""
import numpy as np

from closed import integrating_sphere, planes
from room import Room
from shapes import box, joined, lamp, obj, quad, room_places, row, scene, shell, sphere

SOBOLEV = "closed form: V. V. Sobolev's two infinite planes, a Hankel transform; the planes of the scene are 120 m wide"
SPHERE = "closed form: integrating sphere, Phi/(4 pi R2) rho/(1 - rho) and the lamp's own light; the mesh has its area"

MESH = 0.001  # relative error that the sphere's 32768 triangles make


def below_ceiling(name, distance, height=3.0, floor=0.3, ceiling=0.8, flux=1000.0):
    """A pendant under a white ceiling without walls; receivers on the floor and on the ceiling."""
    surfaces = [quad("floor", (-60, -60, 0), (120, 0, 0), (0, 120, 0), "floor"),
                quad("ceiling", (-60, -60, height), (0, 120, 0), (120, 0, 0), "ceiling")]
    receivers = joined(row((0.2, 0.3, 0), (4, 3, 0), (0, 0, 1), 8), row((0.5, -0.4, height), (4, -2.5, height), (0, 0, -1), 6))
    return Room(name, "lamp near a surface", scene({"floor": floor, "ceiling": ceiling}, surfaces, [lamp((0, 0, height - distance), flux)]),
                receivers, SOBOLEV, planes(flux, distance, height, floor, ceiling))


def in_sphere(name, distance, level=6, radius=2.0, reflectance=0.6, flux=1000.0):
    """A lamp off the wall of an integrating sphere, over the middle of a triangle; receivers at the middles of others."""
    points, faces = sphere(radius, level)
    middles = points[faces].mean(axis=1)
    normals = -middles / (middles**2).sum(axis=1)[:, None] ** 0.5
    foot = 11
    position = middles[foot] + distance * normals[foot]
    far = range(len(faces) // 20, len(faces), len(faces) // 14)
    receivers = joined(*([[*middles[i], *normals[i]]] for i in far))
    surfaces = [{"name": "sphere", "file": "sphere.obj", "material": "wall"}]
    return Room(name, "lamp near a surface", scene({"wall": reflectance}, surfaces, [lamp(position, flux)]), receivers, SPHERE,
                integrating_sphere(flux, position, radius, reflectance), slack=MESH, files={"sphere.obj": obj(points, faces)})


SIZE, TRACED = (4, 3, 2.5), "path tracer of the zoo"
MATERIALS = {"white": 0.8, "wall": 0.5, "dark": 0.25}
FACES = {"": "wall", "ceiling": "white", "floor": "dark"}
TABLE = box("table", (1.4, 1.0, 0.7), (1.2, 0.8, 0.04), "wall", 15)


def furnished(name, kind, luminaires, more=(), portals=()):
    """A room with a table, and what else the lamps are beside."""
    return Room(name, kind, scene(MATERIALS, [*shell(SIZE, FACES), TABLE, *more], luminaires), room_places(SIZE), TRACED, portals=portals)


def housing(center, half, opening):
    """A box of five closed sides and a bottom with a square opening."""
    x, y, z = center
    size, edge = (2 * half,) * 3, half - opening / 2
    sides = shell(size, "white", (x - half, y - half, z - half), "housing-", leave=("floor",))
    bottom = [quad("rim-a", (x - half, y - half, z - half), (2 * half, 0, 0), (0, edge, 0), "white"),
              quad("rim-b", (x - half, y + opening / 2, z - half), (2 * half, 0, 0), (0, edge, 0), "white"),
              quad("rim-c", (x - half, y - opening / 2, z - half), (edge, 0, 0), (0, opening, 0), "white"),
              quad("rim-d", (x + opening / 2, y - opening / 2, z - half), (edge, 0, 0), (0, opening, 0), "white")]
    return sides + bottom


def housed(name, opening, center=(2.1, 1.3, 2.2), half=0.15):
    x, y, z = center
    portal = ((x - opening / 2, y - opening / 2, z - half), (0, opening, 0), (opening, 0, 0))
    return furnished(name, "housing with a small opening", [lamp(center)], housing(center, half, opening), (portal,))


def shade(center, radius, height, sides=12):
    """The text of an OBJ file: a thin tube about a vertical axis, open above and below."""
    turn = 2 * np.pi * np.arange(sides) / sides
    x, y, z = center
    vertices = [(x + radius * np.cos(a), y + radius * np.sin(a), z + up) for up in (-height / 2, height / 2) for a in turn]
    return obj(vertices, [(i, (i + 1) % sides, (i + 1) % sides + sides, i + sides) for i in range(sides)])


def shaded(name):
    center = (1.9, 1.4, 1.9)
    tube = {"name": "shade", "file": "shade.obj", "material": "white"}
    room = scene(MATERIALS, [*shell(SIZE, FACES), TABLE, tube], [lamp(center)])
    return Room(name, "lamp under a shade", room, room_places(SIZE), TRACED, files={"shade.obj": shade(center, 0.15, 0.25)})


COVE = [quad("cornice", (3.8, 0, 2.3), (0.2, 0, 0), (0, 3, 0), "white"), quad("lip", (3.8, 0, 2.3), (0, 3, 0), (0, 0, 0.12), "white")]
UPLIGHTS = [lamp((3.9, 0.25 + 0.5 * i, 2.33), 300, name=f"uplight{i}") for i in range(6)]

ROOMS = [
    below_ceiling("pendant-30cm", 0.3), below_ceiling("pendant-10cm", 0.1), below_ceiling("pendant-3cm", 0.03),
    below_ceiling("pendant-1cm", 0.01), below_ceiling("pendant-1mm", 0.001), in_sphere("sphere-lamp-10cm", 0.1),
    in_sphere("sphere-lamp-1mm", 0.001),
    furnished("room-pendant-10cm", "lamp near a surface", [lamp((2.1, 1.3, 2.4))]),
    furnished("room-pendant-1cm", "lamp near a surface", [lamp((2.1, 1.3, 2.49))]),
    furnished("wall-lamp-0.1mm", "lamp near a surface", [lamp((0.0001, 1.4, 1.3))]),
    furnished("corner-lamp-1cm", "lamp near a surface", [lamp((0.01, 0.01, 2.49))]),
    furnished("table-lamp-2cm", "lamp near a surface", [lamp((1.5, 1.1, 0.74))]),
    furnished("cove", "uplights behind a cornice", UPLIGHTS, COVE),
    housed("housing-6cm", 0.06), housed("housing-2cm", 0.02),
    shaded("shade"),
]
