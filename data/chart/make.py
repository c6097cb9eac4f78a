#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the scenes of `kalos chart` that are hard somewhere beside itself, from those of the neighbouring folders.

edge-cornell.json, edge-furnace.json: 48 points on the floor, evenly in the logarithm from 0.1 mm to 2.5 m off the left wall, 1 m
from the front. wall-cornell.json: a plane of 64 x 64 points 1 mm off the left wall, looking away from it. sobolev-row.json:
Sobolev's planes of reflectance 0.5, 41 points from the foot of the source to 10 H; squares of 200 m stand for the planes.
image-cornell.json: the camera of the room at 512 x 512 pixels. gloss-*.json: the same room of 5 x 4 x 2.6 m with lobes of 4 %
on everything, in satin with one polished box, with a tiled floor, and as a living room: tiles of roughness 0.15, steel of 0.25,
lacquer of 0.08 and three small lamps; with a plane at 0.75 m, a wall, and an image of 256 x 192 pixels.
"""
import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "sobolev"))
from make import dump, scene as sobolev  # noqa: E402

HALF = 100.0  # m: beyond it the planes are cut off


def cornell(receivers):
    scene = json.loads((HERE.parent / "cornell" / "cornell.json").read_text())
    scene["surfaces"][0]["file"] = "../cornell/room.obj"
    scene.pop("cameras")
    return {**scene, "receivers": receivers}


def image():
    scene = json.loads((HERE.parent / "cornell" / "cornell.json").read_text())
    scene["surfaces"][0]["file"] = "../cornell/room.obj"
    scene.pop("receivers")
    scene["cameras"][0]["resolution"] = [512, 512]
    return scene


def furnace(receivers):
    scene = json.loads((HERE.parent / "furnace" / "furnace.json").read_text())
    scene.pop("cameras")
    return {**scene, "receivers": receivers}


def planes(receivers):
    scene = sobolev(0.5, 0.5, 0.5)
    for surface in scene["surfaces"]:
        quad = surface["quad"]
        quad["origin"] = [-HALF, -HALF, quad["origin"][2]]
        quad["u"], quad["v"] = ([2 * HALF if x else 0 for x in quad[side]] for side in ("u", "v"))
    return {**scene, "receivers": receivers}


GLOSS = {"few": {"wall": (0.6, 0.04, 0.3), "floor": (0.3, 0.04, 0.25), "table": (0.5, 0.04, 0.3), "chest": (0.4, 0.04, 0.2)},
         "satin": {"wall": (0.4, 0.3, 0.5), "floor": (0.3, 0.3, 0.4), "table": (0.4, 0.3, 0.3), "chest": (0.1, 0.6, 0.1)},
         "floor": {"wall": (0.6, 0, 1), "floor": (0.3, 0.5, 0.2), "table": (0.5, 0, 1), "chest": (0.4, 0, 1)},
         "living": {"wall": (0.7, 0, 1), "floor": (0.3, 0.04, 0.15), "table": (0.2, 0.6, 0.25), "chest": (0.4, 0.05, 0.08)}}


def glossy(name):
    """Reflectance, specular reflectance and roughness of the materials as GLOSS has them."""
    def quad(surface, origin, u, v, material="wall"):
        return {"name": surface, "quad": {"origin": origin, "u": u, "v": v}, "material": material}

    shell = [quad("floor", [0, 0, 0], [5, 0, 0], [0, 4, 0], "floor"), quad("ceiling", [0, 0, 2.6], [0, 4, 0], [5, 0, 0]),
             quad("left", [0, 0, 0], [0, 4, 0], [0, 0, 2.6]), quad("right", [5, 0, 0], [0, 0, 2.6], [0, 4, 0]),
             quad("front", [0, 0, 0], [0, 0, 2.6], [5, 0, 0]), quad("back", [0, 4, 0], [5, 0, 0], [0, 0, 2.6])]
    boxes = [{"name": "table", "box": {"center": [3.2, 1.6, 0.3], "size": [1.2, 0.7, 0.6], "rotation_z_deg": 15}, "material": "table"},
             {"name": "chest", "box": {"center": [0.4, 2.4, 0.45], "size": [0.5, 1.4, 0.9]}, "material": "chest"}]
    materials = {key: {"reflectance": rho, "specular": f0, "roughness": rough} if f0 else {"reflectance": rho}
                 for key, (rho, f0, rough) in GLOSS[name].items()}
    lamps = [{"name": f"lamp{i}", "position": place, "aim": [0, 0, -1], "flux": 800, "distribution": "isotropic"}
             for i, place in enumerate([[1.2, 1.1, 2.3], [3.7, 2.9, 1.5], [3.4, 1.5, 2.2]][:3 if name == "living" else 1])]
    camera = {"name": "eye", "position": [0.6, 0.3, 1.6], "target": [3.2, 2.6, 0.7], "up": [0, 0, 1], "fov_deg": 60,
              "resolution": [256, 192]}
    receivers = [{"name": "plane", "plane": {"origin": [0, 0, 0.75], "u": [5, 0, 0], "v": [0, 4, 0], "resolution": [44, 35]}},
                 {"name": "wall", "plane": {"origin": [4.999, 0.01, 0.01], "u": [0, 0, 2.58], "v": [0, 3.98, 0], "resolution": [29, 50]}}]
    return {"kalos": 1, "materials": materials, "surfaces": shell + boxes, "luminaires": lamps, "receivers": receivers, "cameras": [camera]}


def points(name, rows):
    lines = [",".join(f"{x:.12g}" for x in row) for row in rows]
    (HERE / name).write_text("x,y,z,nx,ny,nz\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    points("edge.csv", [(x, 1, 0, 0, 0, 1) for x in np.geomspace(1e-4, 2.5, 48)])
    points("row.csv", [(r, 0, 0, 0, 0, 1) for r in np.linspace(0, 10, 41)])
    edge = [{"name": "edge", "points": "edge.csv"}]
    wall = [{"name": "wall", "plane": {"origin": [0.001, 0, 0], "u": [0, 5, 0], "v": [0, 0, 5], "resolution": [64, 64]}}]
    dump(cornell(edge), HERE / "edge-cornell.json")
    dump(furnace(edge), HERE / "edge-furnace.json")
    dump(cornell(wall), HERE / "wall-cornell.json")
    for name in GLOSS:
        dump(glossy(name), HERE / f"gloss-{name}.json")
    dump(image(), HERE / "image-cornell.json")
    dump(planes([{"name": "row", "points": "row.csv"}]), HERE / "sobolev-row.json")
