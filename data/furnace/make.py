#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the furnaces with receivers near edges beside itself: near-edge.json (reflectance 0.6) and near-edge-95.json (0.95).

Every receiver set goes from 0.1 mm to 1 m: off an edge of two walls (on the floor, then on the wall), off a corner of
three (on the floor), and off the contact of the tall box with the floor (on the floor, then on the box). The set `middle`
is the middle of a wall, for comparison.
"""
import json
from pathlib import Path

import numpy as np

DISTANCES = (1e-4, 1e-3, 1e-2, 1e-1, 1)  # m
SIDE = 5.0
BOXES = {"short": {"center": [3.3, 1.7, 0.75], "size": [1.5, 1.5, 1.5], "rotation_z_deg": -17},
         "tall": {"center": [1.7, 3.2, 1.5], "size": [1.5, 1.5, 3.0], "rotation_z_deg": 17}}
QUADS = {"floor": ([0, 0, 0], [5, 0, 0], [0, 5, 0]), "ceiling": ([0, 0, 5], [0, 5, 0], [5, 0, 0]),
         "left": ([0, 0, 0], [0, 5, 0], [0, 0, 5]), "right": ([5, 0, 0], [0, 0, 5], [0, 5, 0]),
         "front": ([0, 0, 0], [0, 0, 5], [5, 0, 0]), "back": ([0, 5, 0], [5, 0, 0], [0, 0, 5])}
UP = np.array([0, 0, 1.0])


def places():
    """Name of a set: rows of point and normal."""
    angle = np.radians(BOXES["tall"]["rotation_z_deg"])
    away = np.array([np.cos(angle), np.sin(angle), 0])  # normal of the side of the tall box that faces the open floor
    contact = np.array([*BOXES["tall"]["center"][:2], 0]) + 0.75 * away
    edge = np.array([0, SIDE / 2, 0])
    x = np.array([1.0, 0, 0])
    return {"edge": [(edge + d * x, UP) for d in DISTANCES] + [(edge + d * UP, x) for d in DISTANCES],
            "corner": [(np.array([d, d, 0]), UP) for d in DISTANCES],
            "lip": [(contact + d * away, UP) for d in DISTANCES] + [(contact + d * UP, away) for d in DISTANCES],
            "middle": [(np.array([0, SIDE / 2, SIDE / 2]), x)]}


def scene(reflectance):
    surfaces = [{"name": name, "quad": dict(zip(("origin", "u", "v"), quad)), "material": "glow"} for name, quad in QUADS.items()]
    surfaces += [{"name": name, "box": box, "material": "glow"} for name, box in BOXES.items()]
    return {"kalos": 1, "materials": {"glow": {"reflectance": reflectance, "exitance": 100}}, "surfaces": surfaces,
            "receivers": [{"name": name, "points": f"near-{name}.csv"} for name in places()]}


def dump(value):
    """JSON with one line per element of a list, as a reader would write it."""
    parts = []
    for key, item in value.items():
        lines = isinstance(item, list)
        text = "[ " + ",\n    ".join(map(json.dumps, item)) + " ]" if lines else json.dumps(item)
        parts.append(f'  "{key}": {text}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


if __name__ == "__main__":
    here = Path(__file__).parent
    for name, reflectance in (("near-edge", 0.6), ("near-edge-95", 0.95)):
        (here / f"{name}.json").write_text(dump(scene(reflectance)))
    for name, rows in places().items():
        lines = [",".join(f"{x:.12g}" for x in (*point, *normal)) for point, normal in rows]
        (here / f"near-{name}.csv").write_text("x,y,z,nx,ny,nz\n" + "\n".join(lines) + "\n")
