#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scene changes: an office with three luminaires of a photometric file, solved, repainted and solved again on one scale.

    PYTHONPATH=build/python examples/scene_changes.py OUT

writes OUT/dark and OUT/light, each with tables and pictures of two planes, and OUT/office.json, the scene to go on from. With
pyvista installed, pyvista.wrap(result.vtk).plot(scalars="Illuminance") shows a result in a window.
"""
from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import kalos

PENDANT = Path(__file__).resolve().parents[1] / "data" / "photometry" / "pendant.ldt"
TRAJECTORIES = 20000
LOOK = kalos.Look(illuminance=(0, 1000), isolines=True)  # both variants in the same colours


def office() -> kalos.Scene:
    """A room of 5 m x 4 m x 3 m with a desk, three pendants, and planes on the desk and on the floor."""
    scene = kalos.Scene()
    scene.name = "office"
    scene.add_material("walls", reflectance=0.3)
    scene.add_material("wood", reflectance=0.4)
    scene.add("surfaces", "room", box={"center": [2.5, 2, 1.5], "size": [5, 4, 3]}, material="walls")
    scene.add("surfaces", "desk top", box={"center": [2.5, 2, 0.7], "size": [1.8, 0.8, 0.04]}, material="wood")
    for i, x in enumerate((1.25, 2.5, 3.75), 1):
        scene.add_luminaire(f"pendant {i}", (x, 2, 2.2), file=PENDANT)
    scene.add_plane("task", (1.6, 1.6, 0.75), (1.8, 0, 0), (0, 0.8, 0), (18, 8))
    scene.add_plane("floor", (0.1, 0.1, 0), (4.8, 0, 0), (0, 3.8, 0), (24, 19))
    return scene


def main(out: Path) -> None:
    scene = office()
    means = {}
    for name, reflectance in (("dark", 0.3), ("light", 0.75)):
        scene.materials["walls"]["reflectance"] = reflectance
        summary = kalos.solve(scene, out / name, trajectories=TRAJECTORIES, look=LOOK)
        means[name] = summary["receivers"]["task"]["mean"]
        print(f"walls of {reflectance}: task {means[name]:.0f} lx, {summary['receivers']['floor']['left_out']} points of the floor left out")
    scene.write(out / "office.json")

    # The same luminaires over the desk alone, from arrays.
    lamps = [kalos.luminaire((x, 2, 2.2), file=PENDANT) for x in (1.25, 2.5, 3.75)]
    top = kalos.quad((1.6, 1.6, 0.72), (1.8, 0, 0), (0, 0.8, 0), 0.4)
    result = kalos.illuminance(top, lamps, np.array([[2.5, 2.0, 0.75]]), (0, 0, 1), trajectories=1000)
    print(f"without a room: {result.illuminance[0]:.0f} lx ± {result.standard_error[0]:.1f}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
