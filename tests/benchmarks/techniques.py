#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each technique saves: processor time at equal error, with it and without it.

    PYTHONPATH=build/python tests/benchmarks/techniques.py [SCENE.json[:SET] ...] [--trajectories N] [--method METHOD]

The Cornell room on its calculation plane, the same room empty on its floor, an office of 30 desks under 12 luminous
panels, and one of two dozen lit rooms of a building, or the scenes named. Variance falls as one over time, so that time x variance tells methods apart at any error: the
table has that product without a technique over the one with all of them. 1.00: it saves nothing there.
"""
import argparse
import json
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

import kalos  # noqa: F401  finds VTK
from kalos.charts.contenders import Room
from kalos.core.options import DEFAULT_METHOD, METHODS, TECHNIQUES, Options

DATA = Path(__file__).resolve().parents[2] / "data"
SEEDS = 3


def office():
    """A scene file's content: desks with screens in rows under panels, 12 x 9 x 3 m."""
    boxes, panels = [], []
    for i in range(30):
        x, y = 1.2 + 2.0 * (i % 6), 1.0 + 1.7 * (i // 6)
        boxes += [{"name": f"desk{i}", "box": {"center": [x, y, 0.7], "size": [1.6, 0.8, 0.04]}, "material": "wood"},
                  {"name": f"screen{i}", "box": {"center": [x, y + 0.2, 0.98], "size": [0.6, 0.03, 0.4]}, "material": "wood"}]
    for i in range(12):
        panels.append({"name": f"panel{i}", "rectangle": {"center": [1.5 + 3 * (i % 4), 1.5 + 3 * (i // 4), 2.99],
                                                          "u": [1.2, 0, 0], "v": [0, 0.3, 0]}, "aim": [0, 0, -1], "flux": 3600})
    walls = [([0, 0, 0], [12, 0, 0], [0, 9, 0], "floor"), ([0, 0, 3], [0, 9, 0], [12, 0, 0], "white"),
             ([0, 0, 0], [0, 9, 0], [0, 0, 3], "white"), ([12, 0, 0], [0, 0, 3], [0, 9, 0], "white"),
             ([0, 0, 0], [0, 0, 3], [12, 0, 0], "white"), ([0, 9, 0], [12, 0, 0], [0, 0, 3], "white")]
    quads = [{"name": f"wall{i}", "quad": {"origin": o, "u": u, "v": v}, "material": m} for i, (o, u, v, m) in enumerate(walls)]
    return {"kalos": 1, "materials": {"white": {"reflectance": 0.7}, "floor": {"reflectance": 0.2}, "wood": {"reflectance": 0.4}},
            "surfaces": quads + boxes, "luminaires": panels,
            "receivers": [{"name": "desk", "plane": {"origin": [0, 0, 0.75], "u": [12, 0, 0], "v": [0, 9, 0],
                                                     "resolution": [32, 24]}}]}


def building():
    """A scene file's content: lit rooms of 4 x 3 x 2.5 m in three rows, receivers in one of them."""
    surfaces, lamps = [], []
    for i in range(24):
        x, y = 4.1 * (i % 8), 3.1 * (i // 8)
        for name, o, u, v in (("floor", [0, 0, 0], [4, 0, 0], [0, 3, 0]), ("ceiling", [0, 0, 2.5], [0, 3, 0], [4, 0, 0]),
                              ("left", [0, 0, 0], [0, 3, 0], [0, 0, 2.5]), ("right", [4, 0, 0], [0, 0, 2.5], [0, 3, 0]),
                              ("front", [0, 0, 0], [0, 0, 2.5], [4, 0, 0]), ("back", [0, 3, 0], [4, 0, 0], [0, 0, 2.5])):
            surfaces.append({"name": f"{name}{i}", "quad": {"origin": [x + o[0], y + o[1], o[2]], "u": u, "v": v}, "material": "white"})
        lamps.append({"name": f"lamp{i}", "position": [x + 1.7, y + 1.4, 2.2], "aim": [0, 0, -1], "flux": 1500})
    return {"kalos": 1, "materials": {"white": {"reflectance": 0.7}}, "surfaces": surfaces, "luminaires": lamps,
            "receivers": [{"name": "desk", "plane": {"origin": [16.4, 3.1, 0.75], "u": [4, 0, 0], "v": [0, 3, 0],
                                                     "resolution": [24, 18]}}]}


def effort(room, options):
    """Processor seconds of a solve times the mean squared relative standard error, over seeds, and the error in %."""
    seconds, squares = 0.0, 0.0
    for seed in range(1, SEEDS + 1):
        found = room.solve(replace(options, seed=seed), None)
        lit = found.values > 0.01 * found.values.mean()
        seconds += found.cpu_seconds / SEEDS
        squares += np.mean((found.standard_error[lit] / found.values[lit]) ** 2) / SEEDS
    return seconds * squares, 100 * np.sqrt(squares), seconds


def table(scenes, method, trajectories):
    """Prints the table and returns it: per scene, the factors by technique."""
    options, factors = Options(method=method, trajectories=trajectories, threads=1), {}
    print(f"{method}, {trajectories} trajectories: times the processor time for the same error, without")
    print(f"{'scene':<24}" + "".join(f"{name:>14}" for name in TECHNIQUES) + "     with all")
    for name, path, chosen in scenes:
        room = Room(path, chosen)
        whole, error, seconds = effort(room, options)
        factors[name] = [effort(room, replace(options, disable=(technique,)))[0] / whole for technique in TECHNIQUES]
        print(f"{name:<24}" + "".join(f"{factor:14.2f}" for factor in factors[name])
              + f"     {error:.2f} % in {seconds:.2f} s", flush=True)
    return factors


def main():
    parser = argparse.ArgumentParser(description="What each technique saves in processor time at equal error.")
    parser.add_argument("scenes", nargs="*", metavar="SCENE.json[:SET]")
    parser.add_argument("--trajectories", type=int, default=2048, metavar="N")
    parser.add_argument("--method", choices=METHODS, default=DEFAULT_METHOD)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "office.json"
        made.write_text(json.dumps(office()), encoding="utf-8")
        rooms = Path(folder) / "building.json"
        rooms.write_text(json.dumps(building()), encoding="utf-8")
        scenes = [(Path(path.partition(":")[0]).stem, path.partition(":")[0], path.partition(":")[2] or None)
                  for path in arguments.scenes]
        table(scenes or [("Cornell room", DATA / "cornell" / "cornell.json", "desk"),
                         ("Cornell room, empty", DATA / "cornell" / "cornell-empty.json", "floor"), ("office", made, "desk"),
                         ("one of 24 rooms", rooms, "desk")],
              arguments.method, arguments.trajectories)


if __name__ == "__main__":
    main()
