#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the scenes of `kalos chart` that are hard somewhere beside itself, from those of the neighbouring folders.

edge-cornell.json, edge-furnace.json: 48 points on the floor, evenly in the logarithm from 0.1 mm to 2.5 m off the left wall, 1 m
from the front. wall-cornell.json: a plane of 64 x 64 points 1 mm off the left wall, looking away from it. sobolev-row.json:
Sobolev's planes of reflectance 0.5, 41 points from the foot of the source to 10 H; squares of 200 m stand for the planes.
image-cornell.json: the camera of the room at 512 x 512 pixels.
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
    dump(image(), HERE / "image-cornell.json")
    dump(planes([{"name": "row", "points": "row.csv"}]), HERE / "sobolev-row.json")
