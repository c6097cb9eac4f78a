#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the scene files beside itself: Sobolev's problem, an isotropic source of 1 lm between two diffuse planes 1 m apart.

Squares of 40 m stand for the infinite planes; what they cut off is below 1e-3 of the value (tests/analytic/test_truths.py).
"""
import json
from pathlib import Path

CASES = {"sobolev-5-5": (0.5, 0.5, 0.5), "sobolev-8-8": (0.5, 0.8, 0.8), "sobolev-2-7": (0.9, 0.2, 0.7)}


def scene(h1, rho1, rho2):
    return {
        "kalos": 1,
        "materials": {"lower": {"reflectance": rho1}, "upper": {"reflectance": rho2}},
        "surfaces": [
            {"name": "lower", "quad": {"origin": [-20, -20, 0], "u": [40, 0, 0], "v": [0, 40, 0]}, "material": "lower"},
            {"name": "upper", "quad": {"origin": [-20, -20, 1], "u": [0, 40, 0], "v": [40, 0, 0]}, "material": "upper"}],
        "luminaires": [{"name": "source", "position": [0, 0, h1], "aim": [0, 0, -1], "flux": 1, "distribution": "isotropic"}],
        "receivers": [{"name": "probe", "points": "probe.csv"}]}


def dump(value, path):
    """JSON with one line per element of a list, as a reader would write it."""
    parts = []
    for key, item in value.items():
        if isinstance(item, list):
            item = "[ " + ",\n    ".join(json.dumps(element) for element in item) + " ]"
        else:
            item = json.dumps(item)
        parts.append(f'  "{key}": {item}')
    path.write_text("{\n" + ",\n".join(parts) + "\n}\n")


if __name__ == "__main__":
    here = Path(__file__).parent
    for name, parameters in CASES.items():
        dump(scene(*parameters), here / f"{name}.json")
    (here / "probe.csv").write_text("x,y,z,nx,ny,nz\n" + "".join(f"{r},0,0,0,0,1\n" for r in (0, 0.5, 1, 2)))
