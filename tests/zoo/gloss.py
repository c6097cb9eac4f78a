# SPDX-License-Identifier: BSD-3-Clause
"""Gloss: lobes are spikes by direction, as edges are spikes by distance."""
import numpy as np

from room import Room
from shapes import box, grid, joined, lamp, quad, room_places, row, scene, shell

from kalos.validation.gloss import glossy_plane

SIZE = (4, 3, 2.5)
TRACED = "path tracer of the zoo"
PALE = {"": "wall", "ceiling": "white"}


def glossy(specular, roughness, reflectance=0.3):
    return {"reflectance": reflectance, "specular": specular, "roughness": roughness}


def polished_floor(name, roughness):
    """A floor with a lobe of 0.5 under a lamp; receivers on walls and ceiling."""
    materials = {"wall": 0.5, "white": 0.8, "tiles": glossy(0.5, roughness)}
    return Room(name, "glossy floor", scene(materials, shell(SIZE, {**PALE, "floor": "tiles"}), [lamp((1.6, 1.3, 1.7))]),
                room_places(SIZE)[3:], TRACED)


def plane(name, roughness, height):
    """A lamp over a polished plane 80 m wide and nothing else; receivers look down on it."""
    material, position = glossy(0.5, roughness), (0.0, 0.0, height)
    surfaces = [quad("plane", (-40, -40, 0), (80, 0, 0), (0, 80, 0), "plane")]
    receivers = joined(row((0.1, 0.2, 1.2), (3.0, 0.9, 1.2), (0, 0, -1), 6), row((1.5, -0.7, 0.4), (1.5, -0.7, 2.4), (-1, 0, 0), 6))
    return Room(name, "lamp over a glossy plane", scene({"plane": material}, surfaces, [lamp(position)]), receivers,
                "quadrature over the plane", glossy_plane(1000.0, position, 0.3, 0.5, roughness), slack=0.0005)


def block_foot(name, roughness):
    """Receivers on the floor, 1 mm to 0.5 m from the foot of a polished block that is higher than the lamp."""
    materials = {"wall": 0.5, "white": 0.8, "steel": glossy(0.5, roughness, 0.1)}
    surfaces = [*shell(SIZE, PALE | {"floor": "wall"}), box("block", (1.0, 1.5, 0.9), (0.8, 0.8, 1.8), "steel")]
    places = [[1.4 + d, 1.3 + 0.05 * i, 0, 0, 0, 1] for i, d in enumerate(np.geomspace(0.001, 0.5, 10))]
    return Room(name, "foot of a polished block", scene(materials, surfaces, [lamp((2.7, 1.2, 1.4))]), np.array(places), TRACED)


def lamp_above_plate(name, roughness):
    """A lamp 1 cm above a polished plate; receivers on walls and ceiling."""
    materials = {"wall": 0.5, "white": 0.8, "plate": glossy(0.5, roughness, 0.2)}
    surfaces = [*shell(SIZE, PALE | {"floor": "wall"}), box("plate", (1.5, 1.4, 0.7), (1.0, 0.8, 0.05), "plate")]
    return Room(name, "lamp above a polished plate", scene(materials, surfaces, [lamp((1.45, 1.35, 0.735))]), room_places(SIZE)[3:],
                TRACED)


def all_glossy(name, kind, walls, floor, block, luminous):
    """Lobes on all surfaces, under a luminous panel (mesh) or a lamp."""
    materials = {"wall": walls, "floor": floor, "block": block, "glow": {"reflectance": 0, "exitance": 4000.0}}
    surfaces = [*shell(SIZE, {"": "wall", "floor": "floor"}), box("block", (2.4, 1.0, 0.4), (0.8, 0.7, 0.8), "block", 25)]
    glow = [quad("panel", (1.5, 1.2, 2.45), (0, 0.5, 0), (0.5, 0, 0), "glow")] if luminous else []
    return Room(name, kind, scene(materials, surfaces + glow, [] if luminous else [lamp((1.6, 1.3, 1.9))]),
                joined(room_places(SIZE), grid((0.2, 0.2, 0.8), (1.4, 0, 0), (0, 2.6, 0), 2, 3)), TRACED)


ROOMS = [
    *(polished_floor(f"gloss-floor-{roughness:g}", roughness) for roughness in (0.05, 0.1, 0.2, 0.3)),
    plane("gloss-plane-0.05", 0.05, 1.0), plane("gloss-plane-0.2", 0.2, 1.0), plane("gloss-plane-near", 0.2, 0.01),
    block_foot("gloss-foot-0.05", 0.05), block_foot("gloss-foot-0.2", 0.2),
    lamp_above_plate("gloss-plate-0.05", 0.05), lamp_above_plate("gloss-plate-0.2", 0.2),
    all_glossy("gloss-4-percent", "4 % lobes", glossy(0.04, 0.3, 0.6), glossy(0.04, 0.2, 0.3), glossy(0.04, 0.15, 0.5), True),
    all_glossy("gloss-4-percent-lamp", "4 % lobes", glossy(0.04, 0.3, 0.6), glossy(0.04, 0.25, 0.3), glossy(0.04, 0.3, 0.5), False),
    all_glossy("gloss-satin", "all satin, one polished", glossy(0.3, 0.4, 0.4), glossy(0.3, 0.3, 0.3), glossy(0.6, 0.1, 0.1), True),
    all_glossy("gloss-satin-lamp", "all satin", glossy(0.3, 0.5, 0.4), glossy(0.3, 0.4, 0.3), glossy(0.6, 0.3, 0.1), False),
]
