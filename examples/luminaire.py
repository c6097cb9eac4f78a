#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A luminaire from its manufacturer's file: the curve of a downlight, and what three of them do in a corridor.

    PYTHONPATH=build/python examples/luminaire.py OUT

writes OUT/corridor.json, a scene for `kalos solve` as well, and OUT/luminaire.png, and prints the figures of EN 12464-1 for
the floor: mean and uniformity. The corridor is 10 m x 2 m x 2.8 m.
"""
from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

import kalos
from kalos.photometry import draw_polar, facts, read_photometry
from kalos.pictures.scale import colour_bar, colour_scale
from kalos.scenes.reading import read_scene
from kalos.vtk import vtkKalosPhotometryReader

FILE = Path(__file__).resolve().parents[1] / "data" / "photometry" / "downlight.ies"
LENGTH, WIDTH, HEIGHT = 10.0, 2.0, 2.8  # m
FLUX = 2000  # lm, of each
COLUMNS, ROWS, ERROR, MOST = 100, 20, 0.02, 200000  # of the floor; 95 % half-width over the value; trajectories


def corridor() -> dict[str, Any]:
    """The scene as `kalos solve` reads it: a luminaire is its file, its place and its flux."""
    l, w, h = LENGTH, WIDTH, HEIGHT
    quads = {"floor": ([0, 0, 0], [l, 0, 0], [0, w, 0], "dark"), "ceiling": ([0, 0, h], [0, w, 0], [l, 0, 0], "light"),
             "front": ([0, 0, 0], [0, 0, h], [l, 0, 0], "wall"), "back": ([0, w, 0], [l, 0, 0], [0, 0, h], "wall"),
             "left": ([0, 0, 0], [0, w, 0], [0, 0, h], "wall"), "right": ([l, 0, 0], [0, 0, h], [0, w, 0], "wall")}
    return {"kalos": 1,
            "materials": {"dark": {"reflectance": 0.2}, "wall": {"reflectance": 0.5}, "light": {"reflectance": 0.7}},
            "surfaces": [{"name": name, "quad": {"origin": o, "u": u, "v": v}, "material": material}
                         for name, (o, u, v, material) in quads.items()],
            "luminaires": [{"name": f"downlight {k + 1}", "position": [l * (k + 0.5) / 3, w / 2, h - 0.01], "aim": [0, 0, -1],
                            "flux": FLUX, "file": str(FILE)} for k in range(3)],
            "receivers": [{"name": "floor", "plane": {"origin": [0, 0, 0], "u": [l, 0, 0], "v": [0, w, 0],
                                                      "resolution": [COLUMNS, ROWS]}}]}


def floor() -> NDArray[np.float64]:
    """Points over the whole floor, up to 5 cm from the walls: they have error bars as all others."""
    x, y = np.meshgrid((np.arange(COLUMNS) + 0.5) * LENGTH / COLUMNS, (np.arange(ROWS) + 0.5) * WIDTH / ROWS)
    return np.stack([x, y, np.zeros_like(x)], axis=-1)


def draw(path: Path, reader: vtkKalosPhotometryReader, lux: kalos.Illuminance) -> None:
    figure = Figure(figsize=(12, 4.6), dpi=110)
    FigureCanvasAgg(figure)
    figure.text(0.02, 0.93, f"{reader.GetLuminaireName()}: {facts(reader)}", fontsize=11)
    draw_polar(figure.add_axes((0.03, 0.02, 0.32, 0.84)), reader)
    plan, profile = figure.add_axes((0.42, 0.6, 0.5, 0.2609)), figure.add_axes((0.42, 0.13, 0.5, 0.33))
    x, y = lux.points[0, :, 0], lux.points[:, 0, 1]
    scale = colour_scale(lux.illuminance)
    plan.pcolormesh(x, y, lux.illuminance, shading="nearest", cmap=scale.colours, norm=scale.norm)
    plan.set_aspect("equal")
    plan.set_ylabel("y, m")
    plan.tick_params(labelbottom=False)
    plan.set_title(f"floor under three of {FLUX} lm", loc="left", fontsize=11)
    colour_bar(plan, scale, "lx")
    for row, where, colour in ((ROWS // 2, "middle", "#0b5d8f"), (0, "foot of the wall", "#c2571a")):
        value, half = lux.illuminance[row], 1.96 * lux.standard_error[row]
        profile.fill_between(x, value - half, value + half, color=colour, alpha=0.25, linewidth=0)
        profile.plot(x, value, color=colour, linewidth=1.2, label=f"{where}, with its 95 % interval")
        profile.plot(x, lux.direct[row], "--", color=colour, linewidth=0.9, label="direct light only")
    profile.set_xlim(0, LENGTH)
    profile.set_ylim(0, None)
    profile.set_xlabel("x, m")
    profile.set_ylabel("lx")
    profile.grid(color="0.92")
    profile.legend(ncol=2, frameon=False, fontsize=8, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    figure.savefig(path, metadata={"Software": None})


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    scene = out / "corridor.json"
    scene.write_text(json.dumps(corridor(), indent=1), encoding="utf-8")
    found = read_scene(scene)
    lux = kalos.illuminance(found.GetOutputDataObject(0), found.GetOutputDataObject(1), floor(), (0, 0, 1), error=ERROR, trajectories=MOST)
    mean, least = lux.illuminance.mean(), lux.illuminance.min()
    print(f"floor: mean {mean:.0f} lx, U0 {least / mean:.2f}; the direct light alone: mean {lux.direct.mean():.0f} lx, "
          f"U0 {lux.direct.min() / lux.direct.mean():.2f}")
    draw(out / "luminaire.png", read_photometry(FILE), lux)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: luminaire.py OUT")
    main(sys.argv[1])
