#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""First light: a small office from NumPy arrays, the lux on its desk plane and what one sees from the door.

    PYTHONPATH=build/python examples/first_light.py OUT

writes OUT/first-light.png and prints the figures a lighting engineer asks for. The office is 4 m x 3 m x 2.8 m with a desk and
a low cupboard, under two luminous panels.
"""
from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

import kalos
from kalos.pictures.scale import colour_bar, colour_scale

ERROR, MOST = 0.03, 60000  # of the lux: 95 % half-width over the value, at every point; trajectories
PIXELS, TRAJECTORIES = (240, 180), 1024  # of the view
DESK = (0.4, 2.1), (1.8, 2.9)  # m, corners of the desk seen from above


def office() -> tuple[list[vtkPolyData], vtkPolyData]:
    """Surfaces and luminaires: floor, ceiling, front, back, left, right; a wooden desk top in three bands; a cupboard."""
    room = kalos.box((2, 1.5, 1.4), (4, 3, 2.8), np.array([0.3, 0.8, 0.6, 0.6, 0.6, 0.6]), inwards=True)
    (x0, y0), (x1, y1) = DESK
    top = kalos.box(((x0 + x1) / 2, (y0 + y1) / 2, 0.7), (x1 - x0, y1 - y0, 0.04), [[0.5, 0.35, 0.2]])
    cupboard = kalos.box((3.6, 1.2, 0.3), (0.7, 1.4, 0.6), 0.45)
    panels = kalos.panel([(1.2, 1.5, 2.79), (2.8, 1.5, 2.79)], u=(0.6, 0, 0), v=(0, 1.2, 0), flux=2700)
    return [room, top, cupboard], panels


def plane(columns: int = 40, rows: int = 30, height: float = 0.75) -> NDArray[np.float64]:
    """A grid over the whole floor: every value has an error bar, also beside the walls, so no border is left out."""
    x, y = np.meshgrid((np.arange(columns) + 0.5) * 4 / columns, (np.arange(rows) + 0.5) * 3 / rows)
    return np.stack([x, y, np.full_like(x, height)], axis=-1)


def draw(path: Path, lux: kalos.Illuminance, view: kalos.Luminance) -> None:
    figure = Figure(figsize=(12, 4.4), dpi=110)
    FigureCanvasAgg(figure)
    left, right = figure.add_axes((0.055, 0.12, 0.37, 0.74)), figure.add_axes((0.54, 0.12, 0.37, 0.74))
    scale = colour_scale(lux.illuminance)
    left.pcolormesh(lux.points[0, :, 0], lux.points[:, 0, 1], lux.illuminance, shading="nearest", cmap=scale.colours,
                    norm=scale.norm)
    (x0, y0), (x1, y1) = DESK
    left.plot([x0, x1, x1, x0, x0], [y0, y0, y1, y1, y0], color="black", linewidth=1)
    left.annotate("desk", (x0, y0), xytext=(4, 4), textcoords="offset points")
    left.set_aspect("equal")
    left.set_xlabel("x, m")
    left.set_ylabel("y, m")
    left.set_title("0.75 m above the floor", loc="left")
    colour_bar(left, scale, "illuminance, lx")
    scale = colour_scale(view.luminance)
    right.imshow(view.luminance, cmap=scale.colours, norm=scale.norm, interpolation="nearest")
    right.set_axis_off()
    right.set_title("seen from the corner", loc="left")
    colour_bar(right, scale, "luminance, cd/m²")
    figure.savefig(path, metadata={"Software": None})


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    surfaces, luminaires = office()
    lux = kalos.illuminance(surfaces, luminaires, plane(), (0, 0, 1), error=ERROR, trajectories=MOST,
                            progress=True)
    x, y = lux.points[..., 0], lux.points[..., 1]
    (x0, y0), (x1, y1) = DESK
    desk = lux.illuminance[(x0 < x) & (x < x1) & (y0 < y) & (y < y1)]
    print(f"desk: mean {desk.mean():.0f} lx, U0 {desk.min() / desk.mean():.2f}; largest standard error "
          f"{100 * (lux.standard_error / lux.illuminance).max():.2f} % after {lux.trajectories} trajectories")
    view = kalos.luminance(surfaces, luminaires, (3.1, 0.1, 1.6), (1.1, 2.6, 0.9), fov_deg=62, resolution=PIXELS,
                           trajectories=TRAJECTORIES, progress=True)
    draw(out / "first-light.png", lux, view)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: first_light.py OUT")
    main(sys.argv[1])
