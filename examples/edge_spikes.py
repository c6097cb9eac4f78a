#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Why local estimation spikes at edges: the foot of a box in the Cornell room by `local` and by `gathered`.

    PYTHONPATH=build/python examples/edge_spikes.py OUT

writes OUT/edge-spikes.png, both for about the same time and on one scale, and prints their largest and mean luminance and their time.
"""
from __future__ import annotations

import sys
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from vtkmodules.vtkCommonDataModel import vtkPolyData

import kalos
from kalos.pictures.scale import colour_bar, colour_scale

PIXELS = 300, 220
TRAJECTORIES = {"local": 2048, "gathered": 32768}  # for about the same time
TITLES = {"local": "plain local estimation", "gathered": "Kalos, gathered"}


def room() -> tuple[list[vtkPolyData], vtkPolyData]:
    """The Cornell room of 5 m with a grey box, from arrays: surfaces and a lamp of 10 000 lm."""
    shell = kalos.box((2.5, 2.5, 2.5), (5, 5, 5), 0.7, inwards=True)
    boxes = [kalos.box((3.3, 1.7, 0.75), (1.5, 1.5, 1.5), 0.7, rotation_z_deg=-17),
             kalos.box((1.7, 3.2, 1.5), (1.5, 1.5, 3.0), 0.7, rotation_z_deg=17)]
    return [shell, *boxes], kalos.luminaire((2.5, 2.5, 4.999), 10000)


def draw(path: Path, pictures: dict[str, kalos.Luminance]) -> None:
    figure = Figure(figsize=(12, 4.6), dpi=110)
    FigureCanvasAgg(figure)
    scale = colour_scale(pictures["gathered"].luminance)
    for k, (method, picture) in enumerate(pictures.items()):
        axes = figure.add_axes((0.01 + 0.455 * k, 0.02, 0.44, 0.88))
        axes.imshow(picture.luminance, cmap=scale.colours, norm=scale.norm, interpolation="nearest")
        axes.set_axis_off()
        axes.set_title(f"{TITLES[method]}: up to {picture.luminance.max():.0f} cd/m²", loc="left", fontsize=13)
    colour_bar(axes, scale, "luminance, cd/m²")
    figure.savefig(path, metadata={"Software": None})


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    surfaces, lamp = room()
    pictures = {method: kalos.luminance(surfaces, lamp, (3.7, 2.7, 1.2), (2.7, 4.8, 0.35), fov_deg=55, resolution=PIXELS, method=method,
                                        trajectories=TRAJECTORIES[method]) for method in TITLES}
    for method, picture in pictures.items():
        print(f"{method}: mean {picture.luminance.mean():.1f} cd/m², largest {picture.luminance.max():.0f} cd/m², "
              f"{picture.cpu_seconds:.1f} s of processor time")
    draw(out / "edge-spikes.png", pictures)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
