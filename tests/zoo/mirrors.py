# SPDX-License-Identifier: BSD-3-Clause
"""Mirrors, whose chains of images do not end."""
from closed import mirror_box
from room import Room
from shapes import joined, lamp, quad, row, scene, shell

LATTICE = "closed form: the lamp and all its images, up to {} reflections"
SIZE, POSITION, FLUX = (2, 3, 2.5), (0.7, 1.2, 1.4), 1000.0
PLACES = joined(row((0.4, 0.5, 0.6), (1.6, 2.4, 0.6), (0, 0, 1), 6), row((0.3, 2.2, 0.4), (0.3, 0.6, 2.1), (1, 0, 0), 6))


def six(name, mirror, shells):
    """A lamp in a box of six mirrors."""
    return Room(name, "mirrors around a lamp", scene({"mirror": {"reflectance": 0, "mirror": mirror}}, shell(SIZE, "mirror"), [lamp(POSITION, FLUX)]),
                PLACES, LATTICE.format(shells), mirror_box(FLUX, POSITION, SIZE, (mirror,) * 3, shells))


def two(name, mirror, shells):
    """A lamp between two facing mirrors 60 m wide."""
    surfaces = [quad("left", (0, -30, -30), (0, 60, 0), (0, 0, 60), "mirror"), quad("right", (2, -30, -30), (0, 0, 60), (0, 60, 0), "mirror")]
    return Room(name, "facing mirrors", scene({"mirror": {"reflectance": 0, "mirror": mirror}}, surfaces, [lamp(POSITION, FLUX)]),
                PLACES, LATTICE.format(shells), mirror_box(FLUX, POSITION, SIZE, (mirror, 0, 0), shells))


ROOMS = [six("mirrors-0.7", 0.7, 50), six("mirrors-0.9", 0.9, 120)]
