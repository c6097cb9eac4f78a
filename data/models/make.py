#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes classroom.glb beside itself: a model as modellers export it, without a scene file around it.

A room of 9 x 6 x 3 m with a board; 12 desks that share a mesh (nodes below one node), 12 stools that share one
(EXT_mesh_gpu_instancing); six pendants, which are one point of 250 cd on six nodes, and a spot of 900 cd on the board
(KHR_lights_punctual); a camera. Nothing stands higher than 0.75 m, so that on the work plane direct light is I cos / d^2.
All is written here with z up, and turned to y up in the file, as glTF wants it.
"""
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests" / "filters"))
from gltf import Gltf  # noqa: E402

ROOM = (9.0, 6.0, 3.0)  # m
REFLECTANCE = {"floor": 0.25, "ceiling": 0.8, "wall": 0.6, "board": 0.1, "wood": 0.4, "seat": 0.3}
BOARD = ((4.5, 5.98, 1.5), (3.0, 0.04, 1.2))  # centre and size
DESK = [((0, 0, 0.715), (1.2, 0.6, 0.03)), ((-0.58, 0, 0.349), (0.02, 0.55, 0.698)), ((0.58, 0, 0.349), (0.02, 0.55, 0.698))]
STOOL = [((0, 0, 0.44), (0.38, 0.34, 0.04)), ((0, 0, 0.209), (0.06, 0.06, 0.418))]
DESKS = [(x, y, 0) for y in (1.2, 2.6, 4.0) for x in (1.5, 3.5, 5.5, 7.5)]
STOOLS = [(x + 0.1 * np.sin(3 * k), y - 0.55, 0, 30 * np.sin(5 * k)) for k, (x, y, _) in enumerate(DESKS)]  # x, y, z, degrees
PENDANTS, CANDELA = [(x, y, 2.4) for y in (1.5, 4.5) for x in (1.5, 4.5, 7.5)], 250.0
SPOT = {"position": (4.5, 3.6, 2.9), "target": (4.5, 5.96, 1.5), "candela": 900.0, "inner": 0.35, "outer": 0.55}  # rad
CAMERA = {"position": (0.5, 0.4, 2.0), "target": (6.0, 4.5, 0.8), "yfov": 1.0}


def y_up(p):
    x, y, z = np.moveaxis(np.asarray(p, float), -1, 0)
    return np.stack([x, z, -y], -1)


def boxes(parts):
    """Points (y up) and triangles of boxes, counter-clockwise from outside."""
    corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    points = np.concatenate([corners * size + center for center, size in parts])
    faces = np.array([(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)])
    return y_up(points), np.concatenate([faces + 8 * k for k in range(len(parts))])


def looking(position, target):
    """Position and rotation (a quaternion) of a node that looks along -z from one point at another, the y axis up."""
    back = y_up(np.subtract(position, target))
    back /= np.linalg.norm(back)
    right = np.cross((0, 1, 0), back)
    right /= np.linalg.norm(right)
    turn = np.stack([right, np.cross(back, right), back], axis=1)
    w = np.sqrt(max(0, 1 + np.trace(turn))) / 2  # never near 0 here: nothing looks backwards
    x, y, z = (np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / (4 * w)).tolist()
    return {"translation": y_up(position).tolist(), "rotation": [x, y, z, float(w)]}


def classroom():
    model = Gltf()
    material = {name: model.material((value,) * 3, name=name) for name, value in REFLECTANCE.items()}

    def mesh(parts, name, inwards=False):
        points, faces = boxes(parts)
        return model.mesh(points, (faces[:, ::-1] if inwards else faces).ravel(), material=material[name])

    # The room's six faces, seen from inside.
    points, faces = boxes([(np.array(ROOM) / 2, ROOM)])
    room = {"wall": faces[:8, ::-1], "floor": faces[8:10, ::-1], "ceiling": faces[10:, ::-1]}
    primitives = [{"attributes": {"POSITION": model.accessor(points)}, "indices": model.accessor(part.ravel(), 5123, "SCALAR"),
                   "material": material[name]} for name, part in room.items()]
    model.node(name="room", mesh=model.add("meshes", primitives=primitives))
    model.node(name="board", mesh=mesh([BOARD], "board"))

    desk = mesh(DESK, "wood")
    desks = [model.node(root=False, name=f"desk {k}", mesh=desk, translation=y_up(at).tolist()) for k, at in enumerate(DESKS, 1)]
    model.node(name="desks", children=desks)

    half = np.radians([turn for *_, turn in STOOLS]) / 2
    places = {"TRANSLATION": model.accessor(y_up([at for *at, _ in STOOLS])),
              "ROTATION": model.accessor(np.stack([0 * half, np.sin(half), 0 * half, np.cos(half)], 1), kind="VEC4")}
    model["extensionsUsed"] = ["KHR_lights_punctual", "EXT_mesh_gpu_instancing"]
    model.node(name="stools", mesh=mesh(STOOL, "seat"), extensions={"EXT_mesh_gpu_instancing": {"attributes": places}})

    first = model.light({"name": "pendant 1", "translation": y_up(PENDANTS[0]).tolist()}, type="point", intensity=CANDELA, name="pendant")
    shared = model["nodes"][first]["extensions"]
    for k, at in enumerate(PENDANTS[1:], 2):
        model.node(name=f"pendant {k}", translation=y_up(at).tolist(), extensions=shared)
    model.light({"name": "spot", **looking(SPOT["position"], SPOT["target"])}, type="spot", intensity=SPOT["candela"], name="spot",
                spot={"innerConeAngle": SPOT["inner"], "outerConeAngle": SPOT["outer"]})
    lens = {"yfov": CAMERA["yfov"], "aspectRatio": 1.5, "znear": 0.1}
    model.node(name="corner", camera=model.add("cameras", type="perspective", perspective=lens),
               **looking(CAMERA["position"], CAMERA["target"]))
    return model


if __name__ == "__main__":
    print(classroom().save(HERE, "classroom.glb"))
