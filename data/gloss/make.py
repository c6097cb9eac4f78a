#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the scene files beside itself: a lamp over a glossy plane, the same in front of a mirror, and a uniformly bright box
over a glossy floor. Squares of 80 m stand for infinite planes; what they cut off is below 1e-3 of the values.
"""
import json
from pathlib import Path

LAMP = {"aim": [0, 0, -1], "flux": 1000, "distribution": "isotropic"}
PROBES = {"plane": [(0.1 + 0.58 * i, 0.2 + 0.14 * i, 1.2, 0, 0, -1) for i in range(6)]
          + [(1.5, -0.7, 0.4 + 0.4 * i, -1, 0, 0) for i in range(6)],
          "mirror": [(1.0 + 0.5 * i, 0.3, 1.3, 0, 0, -1) for i in range(5)] + [(4.0, 0.5, 0.5 + 0.4 * i, -1, 0, 0) for i in range(4)],
          "furnace": [(2, 1.5, 0, 0, 0, 1), (0.5, 0.4, 0, 0, 0, 1), (2, 1.5, 2.5, 0, 0, -1), (4, 1, 0.5, -1, 0, 0), (4, 2, 1.2, -1, 0, 0),
                      (2, 1.5, 0.5, 0, 0, -1), (1, 3, 1.8, 0, -1, 0)]}


def quad(name, origin, u, v, material):
    return {"name": name, "quad": {"origin": origin, "u": u, "v": v}, "material": material}


def wide(name, axes, material):
    """A square of 80 m about the origin."""
    (u, v) = axes
    origin = [-40 * (abs(a) + abs(b)) for a, b in zip(u, v)]
    return quad(name, origin, [80 * x for x in u], [80 * x for x in v], material)


def scene(name, materials, surfaces, luminaires):
    return {"kalos": 1, "materials": materials, "surfaces": surfaces, "luminaires": luminaires,
            "receivers": [{"name": "probe", "points": f"{name}.csv"}]}


def scenes():
    floor = wide("floor", ([1, 0, 0], [0, 1, 0]), "floor")
    yield "plane", scene("plane", {"floor": {"reflectance": 0.3, "specular": 0.5, "roughness": 0.2}}, [floor],
                         [{"name": "lamp", "position": [0, 0, 1], **LAMP}])
    half = quad("floor", [0, -40, 0], [80, 0, 0], [0, 80, 0], "floor")
    mirror = quad("mirror", [0, -40, 0], [0, 80, 0], [0, 0, 80], "mirror")
    yield "mirror", scene("mirror", {"floor": {"reflectance": 0.3, "specular": 0.3, "roughness": 0.2},
                                     "mirror": {"reflectance": 0, "mirror": 0.8}}, [half, mirror],
                          [{"name": "lamp", "position": [1.5, 0, 1], **LAMP}])
    glow = [quad("x-", [0, 0, 0], [0, 3, 0], [0, 0, 2.5], "glow"), quad("x+", [4, 0, 0], [0, 0, 2.5], [0, 3, 0], "glow"),
            quad("y-", [0, 0, 0], [0, 0, 2.5], [4, 0, 0], "glow"), quad("y+", [0, 3, 0], [4, 0, 0], [0, 0, 2.5], "glow"),
            quad("ceiling", [0, 0, 2.5], [0, 3, 0], [4, 0, 0], "glow")]
    yield "furnace", scene("furnace", {"floor": {"reflectance": 0.4, "specular": 0.3, "roughness": 0.3},
                                       "glow": {"reflectance": 0, "exitance": 1000}},
                           [quad("floor", [0, 0, 0], [4, 0, 0], [0, 3, 0], "floor"), *glow], [])


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
    for name, written in scenes():
        dump(written, here / f"{name}.json")
        rows = "".join(",".join(f"{x:.12g}" for x in probe) + "\n" for probe in PROBES[name])
        (here / f"{name}.csv").write_text("x,y,z,nx,ny,nz\n" + rows)
