# SPDX-License-Identifier: BSD-3-Clause
"""Mirrors, whose chains of images do not end."""
from closed import mirror_box
from room import Room
from shapes import joined, lamp, obj, quad, room_places, row, scene, shell, sphere

LATTICE = "closed form: the lamp and all its images, up to {} reflections"
SIZE, POSITION, FLUX = (2, 3, 2.5), (0.7, 1.2, 1.4), 1000.0
PLACES = joined(row((0.4, 0.5, 0.6), (1.6, 2.4, 0.6), (0, 0, 1), 6), row((0.3, 2.2, 0.4), (0.3, 0.6, 2.1), (1, 0, 0), 6))


def between(name, kind, mirror, surfaces, per_axis, most):
    return Room(name, kind, scene({"mirror": {"reflectance": 0, "mirror": mirror}}, surfaces, [lamp(POSITION, FLUX)]), PLACES,
                LATTICE.format(most), mirror_box(FLUX, POSITION, SIZE, per_axis, most))


def six(name, mirror, most):
    """A lamp in a box of six mirrors."""
    return between(name, "mirrors around a lamp", mirror, shell(SIZE, "mirror"), (mirror,) * 3, most)


def two(name, mirror, most):
    """A lamp between two facing mirrors 60 m wide."""
    surfaces = [quad("left", (0, -30, -30), (0, 60, 0), (0, 0, 60), "mirror"),
                quad("right", (2, -30, -30), (0, 0, 60), (0, 60, 0), "mirror")]
    return between(name, "facing mirrors", mirror, surfaces, (mirror, 0, 0), most)


def mirrored_room(name, kind, faces, more=(), files=None):
    """A room with mirrors lit by a luminous panel, which rays from the receivers meet by way of the mirrors."""
    materials = {"wall": 0.5, "mirror": {"reflectance": 0, "mirror": 0.9}, "glow": {"reflectance": 0, "exitance": 5000.0}}
    glow = quad("panel", (1.5, 1.2, 2.45), (0, 0.5, 0), (0.5, 0, 0), "glow")
    size = (4, 3, 2.5)
    return Room(name, kind, scene(materials, [*shell(size, {"": "wall", **faces}), glow, *more]), room_places(size)[:9], TRACED,
                files=files or {})


TRACED = "path tracer of the zoo"
BALL = {"ball.obj": obj(*sphere(0.5, 5, inwards=False, center=(2.6, 1.7, 0.7)))}
ROOMS = [six("mirrors-0.7", 0.7, 50), six("mirrors-0.9", 0.9, 120), two("facing-mirrors-0.9", 0.9, 300),
         mirrored_room("mirror-walls", "mirrors and diffuse walls", {"right": "mirror", "back": "mirror"}),
         mirrored_room("mirror-ball", "curved mirror of 8192 triangles", {},
                       [{"name": "ball", "file": "ball.obj", "material": "mirror"}], BALL)]
