#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes an office of about 275 000 triangles: 12 desks with chairs, screens and small things under 8 luminaires.

    data/office/make.py [FOLDER]        the folder of this script if none is given; the mesh is 9 MB and stays out of git

office.obj             the mesh, metres, floor at z = 0, 9.6 m x 6.4 m x 3 m
panel.ies              the luminaire: I = 1100 cd (cos gamma) (1 + 0.3 sin^2 gamma cos 2C), flux 1100 pi lm, 0.6 m square
office.json            the scene under 8 of them
office-rectangles.json the same under 8 luminous rectangles of the same size and flux
Both have a calculation plane of 96 x 64 points at desk height and a camera.
"""
import json
import shutil
import sys
from pathlib import Path

import numpy as np

ROOM = (9.6, 6.4, 3.0)  # m
DESKS = [(x, y, turned) for x in (1.4, 3.7, 6.0, 8.3) for y, turned in ((1.1, True), (3.1, False), (5.1, True))]
LAMPS = [(x, y) for y in (1.6, 4.8) for x in (1.2, 3.6, 6.0, 8.4)]
SIDE, FLUX = 0.6, 1100 * np.pi
MATERIALS = {"wall": 0.7, "ceiling": 0.8, "floor": 0.25, "wood": 0.45, "metal": 0.35, "cloth": 0.12, "plastic": 0.08, "paper": 0.75}


class Mesh:
    """Points and faces by material; bodies are closed, their faces counter-clockwise from outside."""

    def __init__(self):
        self.points, self.faces, self.count = [], [], 0

    def add(self, material, points, faces):
        self.points.append(points)
        self.faces.append((material, np.asarray(faces) + self.count))
        self.count += len(points)

    def triangles(self):
        return sum(len(faces) * (faces.shape[1] - 2) for _, faces in self.faces)

    def write(self, path):
        with path.open("w") as file:
            for points in self.points:
                np.savetxt(file, points, "v %.5f %.5f %.5f")
            for material, faces in self.faces:
                file.write(f"usemtl {material}\n")
                np.savetxt(file, faces + 1, "f" + " %d" * faces.shape[1])


def box(center, size):
    corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners * size + center, np.array(faces)


def lathe(profile, around):
    """The body of revolution about z of a profile of (radius, height) from the bottom pole to the top pole."""
    profile = np.asarray(profile, float)
    angle = 2 * np.pi * np.arange(around) / around
    inner = profile[1:-1]
    rings = np.stack([inner[:, :1] * np.cos(angle), inner[:, :1] * np.sin(angle), np.repeat(inner[:, 1:], around, 1)], -1)
    points = np.concatenate([[(0, 0, profile[0, 1])], rings.reshape(-1, 3), [(0, 0, profile[-1, 1])]])
    k, next_k = np.arange(around), (np.arange(around) + 1) % around
    start = 1 + around * np.arange(len(inner) - 1)[:, None]
    a, b, c, d = start + k, start + next_k, start + around + next_k, start + around + k
    top, last = len(points) - 1, 1 + around * (len(inner) - 1)
    faces = [np.stack([np.zeros_like(k), 1 + next_k, 1 + k], -1), np.stack([a, b, c], -1).reshape(-1, 3),
             np.stack([a, c, d], -1).reshape(-1, 3), np.stack([last + k, last + next_k, np.full_like(k, top)], -1)]
    return points, np.concatenate(faces)


def cylinder(radius, low, high, around=24):
    return lathe([(0, low), (radius, low), (radius, high), (0, high)], around)


def cushion(size, around, along, power=0.35):
    """A superellipsoid: a box with soft edges."""
    t = np.linspace(-np.pi / 2, np.pi / 2, along)
    soft = lambda v: np.sign(v) * np.abs(v) ** power  # noqa: E731
    points, faces = lathe(np.stack([np.cos(t), np.sin(t)], -1), around)
    angle, radius = np.arctan2(points[:, 1], points[:, 0]), np.hypot(points[:, 0], points[:, 1])
    points = np.stack([soft(np.cos(angle)) * soft(radius), soft(np.sin(angle)) * soft(radius), soft(points[:, 2])], -1)
    return 0.5 * points * size, faces


def placed(body, shift, turn=0.0, tip=0.0):
    """Tipped about x, turned about z (degrees), then shifted."""
    points, faces = body
    c, s, ct, st = np.cos(np.radians(turn)), np.sin(np.radians(turn)), np.cos(np.radians(tip)), np.sin(np.radians(tip))
    rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, ct, -st], [0, st, ct]])
    return points @ rotation.T + shift, faces


def chair():
    """About the spring, looking to +y."""
    yield "cloth", placed(cushion((0.5, 0.48, 0.09), 72, 40), (0, 0, 0.46))
    yield "cloth", placed(cushion((0.46, 0.08, 0.6), 72, 40), (0, -0.27, 0.86), tip=-8)
    yield "metal", cylinder(0.03, 0.1, 0.415)
    for x in (-0.3, 0.3):
        yield "plastic", placed(cushion((0.07, 0.28, 0.04), 40, 16), (x, -0.02, 0.68))
        yield "metal", placed(cylinder(0.012, 0.44, 0.66, 16), (x * 0.97, -0.02, 0))
    ball = np.linspace(-np.pi / 2, np.pi / 2, 13)
    for turn in range(0, 360, 72):
        x, y = 0.29 * np.cos(np.radians(turn)), 0.29 * np.sin(np.radians(turn))
        yield "plastic", placed(lathe(0.028 * np.stack([np.cos(ball), np.sin(ball)], -1), 24), (x, y, 0.029))
        yield "metal", placed(box((0.155, 0, 0.078), (0.27, 0.04, 0.03)), (0, 0, 0), turn)


def desk():
    """About the middle of the top's front edge, the user sits at -y."""
    yield "wood", box((0, 0.4, 0.725), (1.6, 0.8, 0.03))
    for x in (-0.75, 0.75):
        for y in (0.05, 0.75):
            yield "metal", placed(cylinder(0.025, 0.001, 0.709, 32), (x, y, 0))
    yield "wood", box((0.52, 0.42, 0.34), (0.4, 0.6, 0.58))
    yield "plastic", box((0, 0.6, 1.0), (0.6, 0.03, 0.36))
    yield "plastic", box((0, 0.63, 0.8), (0.06, 0.02, 0.118))
    yield "plastic", placed(lathe([(0, 0.741), (0.12, 0.741), (0.12, 0.75), (0.02, 0.757), (0, 0.757)], 48), (0, 0.63, 0))
    for row in range(5):
        for key in range(15):
            yield "plastic", box((-0.21 + 0.03 * key, 0.16 + 0.03 * row, 0.748), (0.025, 0.025, 0.012))
    for sheet in range(5):
        yield "paper", placed(box((0, 0, 0.7415 + 0.004 * sheet), (0.21, 0.297, 0.003)), (-0.55, 0.3, 0), 4 * sheet)
    mug = [(0, 0.741), (0.035, 0.741), *((0.04 + 0.003 * np.sin(6 * z), 0.745 + 0.09 * z) for z in np.linspace(0, 1, 14)),
           (0.036, 0.835), *((0.036, 0.835 - 0.085 * z) for z in np.linspace(0.05, 1, 10)), (0, 0.75)]
    yield "paper", placed(lathe(mug, 48), (0.35, 0.2, 0))
    bin_ = [(0, 0.001), (0.1, 0.001), *((0.1 + 0.04 * z, 0.001 + 0.3 * z) for z in np.linspace(0.1, 1, 12)), (0.137, 0.301),
            *((0.137 - 0.04 * z, 0.301 - 0.29 * z) for z in np.linspace(0.1, 1, 12)), (0, 0.011)]
    yield "metal", placed(lathe(bin_, 48), (-0.6, 0.55, 0))


def office():
    mesh = Mesh()
    x, y, z = ROOM
    points, faces = box((x / 2, y / 2, z / 2), ROOM)
    for material, face in zip(("wall", "wall", "wall", "wall", "floor", "ceiling"), faces):
        mesh.add(material, points[face], [(3, 2, 1, 0)])  # seen from inside
    for k, (px, py, turned) in enumerate(DESKS):
        turn = 180 if turned else 0
        side = -1 if turned else 1
        for material, body in desk():
            mesh.add(material, *placed(body, (px, py, 0), turn))
        for material, body in chair():
            mesh.add(material, *placed(body, (px + 0.05 * np.sin(5 * k), py - side * 0.42, 0), turn + 25 * np.sin(3 * k)))
    return mesh


def scene(luminaires):
    x, y, _ = ROOM
    return {"kalos": 1, "materials": {name: {"reflectance": value} for name, value in MATERIALS.items()},
            "surfaces": [{"name": "office", "file": "office.obj"}], "luminaires": luminaires,
            "receivers": [{"name": "desks", "plane": {"origin": [0, 0, 0.8], "u": [x, 0, 0], "v": [0, y, 0], "resolution": [96, 64]}}],
            "cameras": [{"name": "view", "position": [0.4, 0.4, 1.9], "target": [6, 4, 0.7], "fov_deg": 62, "resolution": [480, 320]}]}


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    mesh = office()
    mesh.write(folder / "office.obj")
    shutil.copyfile(Path(__file__).parents[1] / "photometry" / "panel.ies", folder / "panel.ies")
    lamps = {"office.json": [{"position": [x, y, ROOM[2]], "file": "panel.ies"} for x, y in LAMPS],
             "office-rectangles.json": [{"rectangle": {"center": [x, y, ROOM[2]], "u": [SIDE, 0, 0], "v": [0, SIDE, 0]},
                                         "flux": FLUX} for x, y in LAMPS]}
    for name, luminaires in lamps.items():
        named = [{"name": f"lamp {i}", **one, "aim": [0, 0, -1]} for i, one in enumerate(luminaires, 1)]
        (folder / name).write_text(json.dumps(scene(named), indent=1) + "\n")
    print(f"{folder / 'office.json'}: {mesh.triangles()} triangles")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
