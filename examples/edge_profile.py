#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What every method makes of an edge: the illuminance from 0.1 mm to 2 m off a wall, where the truth is known.

    PYTHONPATH=build/python examples/edge_profile.py OUT

writes OUT/edge-profile.csv and OUT/edge-profile.png. The scene is the white furnace: a cube of 4 m whose faces reflect 0.6 and
emit 100 lm/m2, so that the illuminance is 250 lx everywhere. Each method gets the same trajectories, with several seeds. Its
dots are single estimates over the truth; the line is their mean.
"""
from __future__ import annotations

import csv
import sys
from pathlib import Path
from typing import Callable, Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from numpy.typing import NDArray

import kalos
from kalos.charts.families import FAMILIES, style
from kalos.validation.truths import white_furnace

METHODS = ("compensated", "gathered", "local", "sphere-published", "sphere-exact", "disc", "clamped", "direct", "radiosity", "photon-map",
           "paths", "bidirectional")
SIDE, REFLECTANCE, EXITANCE = 4.0, 0.6, 100.0
DISTANCES = np.geomspace(1e-4, 2, 24)  # m
SEEDS, TRAJECTORIES = range(1, 13), 4000
LOW, HIGH = 0.2, 6  # of the charts; what lies beyond sits on the frame as a triangle
PARTS = (("bias: the mean of all seeds over the truth, less one", lambda ratios: np.abs(ratios.mean(axis=0) - 1)),
         ("noise: the spread of the seeds over the truth", lambda ratios: ratios.std(axis=0, ddof=1)))
LEAST, MOST = 0.1, 1000  # %, of the panels of bias and noise
MATTERS = 1  # %


def profiles() -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Estimates over the truth, (seeds, distances) a method."""
    cube = kalos.box((0, 0, SIDE / 2), (SIDE, SIDE, SIDE), REFLECTANCE, exitance=EXITANCE, inwards=True)
    points = np.column_stack([DISTANCES - SIDE / 2, np.full_like(DISTANCES, 0.37), np.zeros_like(DISTANCES)])
    truth = white_furnace(REFLECTANCE, EXITANCE)
    for method in METHODS:
        yield method, np.array([kalos.illuminance(cube, None, points, (0, 0, 1), trajectories=TRAJECTORIES, method=method,
                                                  seed=seed).illuminance for seed in SEEDS]) / truth


def draw(path: Path, found: dict[str, NDArray[np.float64]]) -> None:
    rows = -(-len(found) // 4)
    figure = Figure(figsize=(12, 3.4 + 2.1 * rows), dpi=110)
    FigureCanvasAgg(figure)
    grid = figure.add_gridspec(rows + 1, 4, height_ratios=[1.5] + rows * [1], left=0.05, right=0.985, top=1 - 0.85 / (3.4 + 2.1 * rows),
                               bottom=0.55 / (3.4 + 2.1 * rows), hspace=0.42, wspace=0.12)
    for k, (title, part) in enumerate(PARTS):
        summary(figure.add_subplot(grid[0, 2 * k:2 * k + 2]), title, part, found)
    names = [name for one in FAMILIES for name in one.about if name in found]
    for k, method in enumerate(names):
        single(figure.add_subplot(grid[1 + k // 4, k % 4]), method, found[method])
    figure.suptitle(f"Illuminance beside an edge over its true value, 250 lx; {TRAJECTORIES} trajectories, {len(SEEDS)} seeds", x=0.05, ha="left",
                    fontsize=13)
    figure.supxlabel("distance from the wall; dots are single estimates, triangles lie beyond the chart, lines are means", fontsize=10)
    figure.savefig(path, metadata={"Software": None})


def distances(one: Axes) -> None:
    one.set_xscale("log")
    one.set_xticks([1e-4, 1e-3, 1e-2, 1e-1, 1], ["0.1 mm", "1 mm", "1 cm", "10 cm", "1 m"])
    one.tick_params(labelsize=8)
    one.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    one.yaxis.set_minor_formatter(NullFormatter())
    one.grid(color="0.92")
    for side in ("top", "right"):
        one.spines[side].set_visible(False)


def summary(one: Axes, title: str, part: Callable[[NDArray[np.float64]], NDArray[np.float64]],
            found: dict[str, NDArray[np.float64]]) -> None:
    """One part of every method's error, %; those that matter anywhere carry their names."""
    ends, small = [], []
    for method, ratios in found.items():
        values = np.clip(100 * part(ratios), LEAST, MOST)
        one.plot(DISTANCES, values, linewidth=1.5, color=style(method)["color"], clip_on=False)
        if values.max() > MATTERS:
            ends.append((np.log(values[-1]), method))
        else:
            small.append(method)
    one.set_yscale("log")
    one.set_ylim(LEAST, MOST)
    one.set_xlim(DISTANCES[0], 40)
    distances(one)
    step, last = np.log(MOST / LEAST) / 13, np.log(LEAST) - np.log(MOST / LEAST) / 26
    for value, method in sorted(ends):
        last = max(value, last + step)
        one.annotate(method, (DISTANCES[-1], np.exp(value)), xytext=(3.2, np.exp(last)), fontsize=8, color=style(method)["color"], va="center",
                     arrowprops={"arrowstyle": "-", "color": style(method)["color"], "linewidth": 0.4, "shrinkA": 0, "relpos": (0, 0.5)},
                     annotation_clip=False)
    one.set_title(f"{title}, %", loc="left", fontsize=10)
    if small:
        one.text(0, 1.02, f"below {MATTERS:g} % everywhere: {', '.join(small)}", transform=one.transAxes, fontsize=8, color="0.4", va="bottom")
        one.set_title(f"{title}, %", loc="left", fontsize=10, pad=17)


def single(one: Axes, method: str, ratios: NDArray[np.float64]) -> None:
    """The estimates of one method over the truth."""
    colour, inside = style(method)["color"], np.clip(ratios, LOW, HIGH)
    for marks, where in ((".", ratios == inside), ("^", ratios > HIGH), ("v", ratios < LOW)):
        seed, distance = np.nonzero(where)
        one.plot(DISTANCES[distance], inside[seed, distance], marks, color=colour, alpha=0.35, markeredgewidth=0, markersize=5, clip_on=False)
    one.plot(DISTANCES, np.clip(ratios.mean(axis=0), LOW, HIGH), color=colour, linewidth=1.6)
    one.axhline(1, color="0.3", linewidth=0.8, linestyle="--")
    worst = np.sqrt(np.mean((ratios - 1) ** 2, axis=0)).max()
    one.set_title(f"{method}: error up to {100 * worst:.2g} %" if worst < 1 else f"{method}: error up to {worst:.2g} times the truth",
                  loc="left", fontsize=9.5, color=colour)
    one.set_yscale("log")
    one.set_ylim(LOW, HIGH)
    one.set_yticks([0.2, 0.5, 1, 2, 5])
    distances(one)


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    found = dict(profiles())
    with (out / "edge-profile.csv").open("w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["method", "distance_m", "mean_over_truth", "rms_error"])
        for method, ratios in found.items():
            for k, distance in enumerate(DISTANCES):
                writer.writerow([method, repr(float(distance)), repr(float(ratios[:, k].mean())),
                                 repr(float(np.sqrt(np.mean((ratios[:, k] - 1) ** 2))))])
    draw(out / "edge-profile.png", found)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: edge_profile.py OUT")
    main(sys.argv[1])
