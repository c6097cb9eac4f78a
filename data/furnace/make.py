#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the furnaces with receivers near edges beside itself: near-edge.json (reflectance 0.6) and near-edge-95.json (0.95).

Every receiver set goes from 0.1 mm to 1 m: off an edge of two walls (on the floor, then on the wall), off a corner of
three (on the floor), and off the contact of the tall box with the floor (on the floor, then on the box). The set `middle`
is the middle of a wall, for comparison.

angles.json and angles-95.json are furnaces of another shape, angles.obj: an irregular closed mesh whose walls meet at
5 to 170 degrees, below tilted planes; receivers on a wall, off the edge of each of these angles.
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


# Corners of the plan, counter-clockwise, m; and the corner where its walls meet at an angle, degrees.
PLAN = np.array([(0, 0), (3.462, 0), (3.462, 4.851), (2.69, 9.226), (2.132, 7.691), (-3.678, 5.37), (-5.518, 1.083),
                 (-3.126, 1.367), (-1.21, -2.17), (-1.982, -4.354)])
EDGES = {90: 1, 170: 2, 30: 3, 135: 5, 60: 6, 5: 9}


def heights(x, y):
    """Of floor and ceiling, m: both tilted, so that they meet no wall at a right angle."""
    return 0.05 * x, 3 + 0.1 * x - 0.05 * y


def angle_places():
    """Name of a set: rows of point and normal, on the wall that ends in that edge, half-way up."""
    def place(corner, distance):
        end, start = PLAN[corner], PLAN[corner - 1]
        along = (start - end) / np.linalg.norm(start - end)
        x, y = end + distance * along
        return np.array([x, y, np.mean(heights(x, y))]), np.array([along[1], -along[0], 0])

    places = {f"angle-{angle}": [place(corner, d) for d in DISTANCES] for angle, corner in sorted(EDGES.items())}
    places["middle"] = [place(5, np.linalg.norm(PLAN[5] - PLAN[4]) / 2)]
    return places


def ears(plan):
    """Triangles (indices) of a polygon without holes: cuts off a corner that holds no other corner."""
    left, triangles = list(range(len(plan))), []
    while len(left) > 2:
        for k in range(len(left)):
            a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
            turns = [np.cross(plan[j] - plan[i], plan - plan[i]) for i, j in ((a, b), (b, c), (c, a))]
            if turns[0][c] > 0 and not any(min(t[i] for t in turns) >= 0 for i in left if i not in (a, b, c)):
                triangles.append((a, b, c))
                del left[k]
                break
    return triangles


def angle_mesh():
    """Text of angles.obj; normals point inwards."""
    n = len(PLAN)
    lines = ["# Irregular room, walls meeting at 5 to 170 degrees, normals inwards; written by make.py."]
    lines += [f"v {x:.12g} {y:.12g} {heights(x, y)[level]:.12g}" for level in (0, 1) for x, y in PLAN]
    faces = [face for a, b, c in ears(PLAN) for face in ((a, b, c), (n + c, n + b, n + a))]
    for i in range(n):
        k = (i + 1) % n
        faces += [(k, i, n + i), (k, n + i, n + k)]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in face) for face in faces]) + "\n"


def angle_scene(reflectance):
    return {"kalos": 1, "materials": {"glow": {"reflectance": reflectance, "exitance": 100}},
            "surfaces": [{"name": "room", "file": "angles.obj", "material": "glow"}],
            "receivers": [{"name": name, "points": f"angles-{name.removeprefix('angle-')}.csv"} for name in angle_places()]}


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
        (here / f"{name.replace('near-edge', 'angles')}.json").write_text(dump(angle_scene(reflectance)))
    (here / "angles.obj").write_text(angle_mesh())
    sets = {f"near-{name}": rows for name, rows in places().items()}
    sets |= {f"angles-{name.removeprefix('angle-')}": rows for name, rows in angle_places().items()}
    for name, rows in sets.items():
        lines = [",".join(f"{x:.12g}" for x in (*point, *normal)) for point, normal in rows]
        (here / f"{name}.csv").write_text("x,y,z,nx,ny,nz\n" + "\n".join(lines) + "\n")
