#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the scene files and probe points of CIE 171:2006 beside itself, one scene a case.

5-2 point source, 5-3 area source, 5-4 flux conservation, 5-6 diffuse reflection, 5-7 the same with an obstruction,
5-8-RR interreflection in a cube of reflectance RR %, 5-9 to 5-12 daylight through an opening, without and with glass,
in the roof or in the facade. The closed forms are in kalos.truths.
"""
import json
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
REFLECTANCES = (5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 95)
GAUSS_ORDER = 8  # points a side of the floor of 5.8, so that a weighted sum is the mean over the surface


def quad(name, origin, u, v, material="black"):
    return {"name": name, "quad": {"origin": origin, "u": u, "v": v}, "material": material}


def room(a, b, h, material="black", floor="black", back="black"):
    """Six quads of a room a by b by h, normals inwards."""
    return [quad("floor", [0, 0, 0], [a, 0, 0], [0, b, 0], floor),
            quad("ceiling", [0, 0, h], [0, b, 0], [a, 0, 0], material),
            quad("left", [0, 0, 0], [0, b, 0], [0, 0, h], material),
            quad("right", [a, 0, 0], [0, 0, h], [0, b, 0], material),
            quad("front", [0, 0, 0], [0, 0, h], [a, 0, 0], material),
            quad("back", [0, b, 0], [a, 0, 0], [0, 0, h], back)]


def lamp(position, flux, distribution):
    return {"name": "lamp", "position": position, "aim": [0, 0, -1], "flux": flux, "distribution": distribution}


def with_hole(name, corner, u, v, low, high):
    """The quads that are left of a wall from `corner` along u and v, m, around a hole from low to high along both."""
    corner, u, v = (np.array(one, float) for one in (corner, u, v))
    across, up = np.linalg.norm(u), np.linalg.norm(v)
    parts = ((0, 0, across, low[1]), (0, high[1], across, up), (0, low[1], low[0], high[1]), (high[0], low[1], across, high[1]))
    return [quad(f"{name}-{i}", (corner + a / across * u + b / up * v).tolist(), ((c - a) / across * u).tolist(),
                 ((d - b) / up * v).tolist()) for i, (a, b, c, d) in enumerate(parts) if c > a and d > b]


def daylit(hole):
    """The black room 4 x 4 x 3 m with an opening in the roof or in the facade y = 4, and the glass in it."""
    shell = {one["name"]: one for one in room(4, 4, 3)}
    place, size = hole
    low = [(4 - size[0]) / 2, (4 - size[1]) / 2] if place == "ceiling" else [(4 - size[0]) / 2, 1 if size[1] < 3 else 0]
    high = [low[0] + size[0], low[1] + size[1]]
    corner = [0, 0, 3] if place == "ceiling" else [0, 4, 0]
    v, up = ([0, 4, 0], [0, 1, 0]) if place == "ceiling" else ([0, 0, 3], [0, 0, 1])
    del shell[place]
    start = np.array(corner) + low[0] * np.array([1, 0, 0]) + low[1] * np.array(up)
    pane = quad("pane", start.tolist(), [size[0], 0, 0], (size[1] * np.array(up)).tolist(), "glass")
    return list(shell.values()) + with_hole(place, corner, [4, 0, 0], v, low, high), pane


def dump(name, materials, surfaces, luminaires, probes, **more):
    """JSON with one line per element of a list, as a reader would write it, and a CSV per probe."""
    value = {"kalos": 1, "materials": materials, "surfaces": surfaces}
    if luminaires:
        value["luminaires"] = luminaires
    value.update(more)
    value["receivers"] = []
    for probe, rows in probes.items():
        file = f"{name}-{probe}.csv" if not name.startswith("5-8") else "5-8-floor.csv"
        value["receivers"].append({"name": probe, "points": file})
        lines = [",".join(repr(float(x)) for x in row) + "\n" for row in rows]
        (HERE / file).write_text("x,y,z,nx,ny,nz\n" + "".join(lines))
    parts = []
    for key, item in value.items():
        text = "[ " + ",\n    ".join(json.dumps(e) for e in item) + " ]" if isinstance(item, list) else json.dumps(item)
        parts.append(f'  "{key}": {text}')
    (HERE / f"{name}.json").write_text("{\n" + ",\n".join(parts) + "\n}\n")


def main():
    black = {"black": {"reflectance": 0}}
    steps = np.arange(0.25, 4, 0.5)
    heights = np.arange(2.75, 0, -0.5)

    # 5.2: 1000 cd straight down, cosine distribution, 3 m over the middle of a 4 m square.
    grid = [(0, 0), (0.5, 0), (1, 0), (1.5, 0), (0.5, 0.5), (1, 0.5), (1.5, 0.5), (1, 1), (1.5, 1), (1.5, 1.5)]
    dump("5-2", black, [quad("floor", [-2, -2, 0], [4, 0, 0], [0, 4, 0])],
         [lamp([0, 0, 3], 1000 * np.pi, "lambertian")], {"floor": [(x, y, 0, 0, 0, 1) for x, y in grid]})

    # 5.3: a luminous square of 1 m in the middle of the ceiling of a black room 4 x 4 x 3 m.
    panel = {"name": "panel", "rectangle": {"center": [2, 2, 3], "u": [1, 0, 0], "v": [0, 1, 0]}, "aim": [0, 0, -1],
             "flux": 1000 * np.pi}
    wall = [(2, 0, z, 0, 1, 0) for z in heights]
    floor = [(2, y, 0, 0, 0, 1) for y in steps]
    dump("5-3", black, room(4, 4, 3), [panel], {"wall": wall, "floor": floor})

    # 5.4: an isotropic source of 10 000 lm in the same room; the fluxes of the surfaces sum to it.
    dump("5-4", black, room(4, 4, 3), [lamp([2, 2, 1.5], 10000, "isotropic")], {})
    text = (HERE / "5-4.json").read_text().replace('"receivers": [  ]', '"receivers": [ ' + ",\n    ".join(
        json.dumps({"name": s["name"], "surface": s["name"], "edge_length": 0.25}) for s in room(4, 4, 3)) + " ]")
    (HERE / "5-4.json").write_text(text)

    # 5.6: the floor reflects 30 % of an even illuminance of 1000 lx; so it gives off 300 lm/m2.
    lit = {**black, "lit": {"reflectance": 0.3, "exitance": 300}}
    wall = [(2, 0, z, 0, 1, 0) for z in np.arange(0.75, 3, 0.5)]
    ceiling = [(2, y, 3, 0, 0, -1) for y in steps[:4]]
    dump("5-6", lit, room(4, 4, 3, floor="lit"), [], {"wall": wall, "ceiling": ceiling})

    # 5.7: the wall y = 4 gives off as much, past an obstruction 1 m high and 0.2 m thick across the room.
    box = {"name": "obstruction", "box": {"center": [2, 2.6, 0.5], "size": [4, 0.2, 1]}, "material": "black"}
    wall = [(2, 0, z, 0, 1, 0) for z in heights]
    floor = [(2, y, 0, 0, 0, 1) for y in np.arange(0.25, 2.5, 0.5)]
    dump("5-7", lit, room(4, 4, 3, back="lit") + [box], [], {"wall": wall, "floor": floor})

    # 5.9 to 5.12: an opening in the roof or in the facade, under the skies of the CIE; the sun is over the facade, in the south.
    outside = {"sky": {"cie": 1, "horizontal_illuminance": 10000, "sun": {"elevation_deg": 60, "azimuth_deg": 180}}, "north_deg": 180,
               "ground": {"reflectance": 0.3}}
    wall, floor = [(2, 0, z, 0, 1, 0) for z in heights], [(2, y, 0, 0, 0, 1) for y in steps]
    glass = {**black, "glass": {"glass": {"transmittance": 0.88, "refractive_index": 1.52}}}
    for case, hole in (("5-9-1", ("ceiling", (1, 1))), ("5-9-4", ("ceiling", (4, 4))), ("5-11-2", ("back", (2, 1))),
                       ("5-11-4", ("back", (4, 3)))):
        surfaces, pane = daylit(hole)
        probes = {"wall": wall, "floor": floor}
        if case.startswith("5-11"):
            probes["ceiling"] = [(2, y, 3, 0, 0, -1) for y in steps]
        dump(case, black, surfaces, [], probes, **outside)
        dump(case.replace("5-9", "5-10").replace("5-11", "5-12"), glass, surfaces + [pane], [], probes, **outside)

    # 5.8: an isotropic source in the middle of a cube of 4 m; by symmetry the floor stands for every face.
    nodes = 2 + 2 * np.polynomial.legendre.leggauss(GAUSS_ORDER)[0]
    floor = [(x, y, 0, 0, 0, 1) for y in nodes for x in nodes]
    for percent in REFLECTANCES:
        dump(f"5-8-{percent:02d}", {"grey": {"reflectance": percent / 100}}, room(4, 4, 4, "grey", "grey", "grey"),
             [lamp([2, 2, 2], 10000, "isotropic")], {"floor": floor})


if __name__ == "__main__":
    main()
