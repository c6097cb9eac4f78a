#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A parameter study: the three series of Budak et al. (GraphiCon 2023), Table 1, on the glossy Cornell room.

    PYTHONPATH=build/python examples/parameter_study.py OUT

writes OUT/room.json, the room at a lower resolution, and per method a folder with study.csv, study.json and study.png: luminance
for N trajectories, radius epsilon and distance delta, each with its error against a converged reference near edges and
elsewhere. The last row is what needs no neighbourhood. Takes some minutes; `kalos study --table1` does the same for any scene.
"""
from __future__ import annotations

import json
import sys
from pathlib import Path

from kalos.core.options import Options
from kalos.studies.study import study
from kalos.studies.sweep import table1

ROOM = Path(__file__).resolve().parents[1] / "data" / "cornell" / "cornell-mixed.json"
PIXELS = 48  # a side; the time goes with their number
REFERENCE = 40000  # trajectories of the reference
METHODS = "sphere-published", "sphere-exact"  # as the paper prints it, and with the exact weight


def coarser_room(path: Path) -> None:
    """The room with fewer pixels; its mesh is where it was."""
    scene = json.loads(ROOM.read_text(encoding="utf-8"))
    scene["cameras"][0]["resolution"] = [PIXELS, PIXELS]
    for surface in scene["surfaces"]:
        if "file" in surface:
            surface["file"] = str(ROOM.parent / surface["file"])
    path.write_text(json.dumps(scene, indent=1), encoding="utf-8")


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    coarser_room(out / "room.json")
    for method in METHODS:
        result = study(out / "room.json", out / method, table1([], Options(method=method)), REFERENCE)
        best = min(result["cells"], key=lambda cell: float(cell["rms_near"]))
        published, = (cell for cell in result["cells"]
                      if (cell["method"], cell["trajectories"], cell["delta_m"], cell["epsilon_m"]) == (method, 10000, 0.25, 0.15))
        print(f"{method}, N = 10000, delta = 0.25 m, epsilon = 0.15 m: error near edges {100 * published['rms_near']:.1f} %, bias there "
              f"{100 * published['bias_near']:+.1f} %; the best of the table is {best['method']} with {100 * best['rms_near']:.1f} %")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: parameter_study.py OUT")
    main(sys.argv[1])
