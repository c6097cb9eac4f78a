# SPDX-License-Identifier: BSD-3-Clause
"""Lamps near surfaces: direct light that falls as 1/d2 from millimetres on."""
from closed import integrating_sphere, planes
from room import Room
from shapes import joined, lamp, obj, quad, row, scene, sphere

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


ROOMS = [below_ceiling("pendant-30cm", 0.3), below_ceiling("pendant-10cm", 0.1), below_ceiling("pendant-3cm", 0.03),
         below_ceiling("pendant-1cm", 0.01), below_ceiling("pendant-1mm", 0.001), in_sphere("sphere-lamp-10cm", 0.1),
         in_sphere("sphere-lamp-1mm", 0.001)]
