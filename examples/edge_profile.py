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
from typing import Iterator

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from numpy.typing import NDArray

import kalos
from kalos.validation.truths import white_furnace

METHODS = ("local", "clamped", "sphere-published", "sphere-exact", "disc", "direct", "compensated")
SIDE, REFLECTANCE, EXITANCE = 4.0, 0.6, 100.0
DISTANCES = np.geomspace(1e-4, 2, 24)  # m
SEEDS, TRAJECTORIES = range(1, 13), 4000
LOW, HIGH = 0.2, 6  # of the charts; what lies beyond sits on the frame as a triangle
DOT, LINE = "#8fb4cf", "#0b3d62"


def profiles() -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Estimates over the truth, (seeds, distances) a method."""
    cube = kalos.box((0, 0, SIDE / 2), (SIDE, SIDE, SIDE), REFLECTANCE, exitance=EXITANCE, inwards=True)
    points = np.column_stack([DISTANCES - SIDE / 2, np.full_like(DISTANCES, 0.37), np.zeros_like(DISTANCES)])
    truth = white_furnace(REFLECTANCE, EXITANCE)
    for method in METHODS:
        yield method, np.array([kalos.illuminance(cube, None, points, (0, 0, 1), trajectories=TRAJECTORIES, method=method,
                                                  seed=seed).illuminance for seed in SEEDS]) / truth


def draw(path: Path, found: dict[str, NDArray[np.float64]]) -> None:
    figure = Figure(figsize=(12, 6), dpi=110)
    FigureCanvasAgg(figure)
    axes = figure.subplots(2, 4, sharex=True, sharey=True).ravel()
    for one, (method, ratios) in zip(axes, found.items()):
        inside = np.clip(ratios, LOW, HIGH)
        for marks, where in ((".", ratios == inside), ("^", ratios > HIGH), ("v", ratios < LOW)):
            seed, distance = np.nonzero(where)
            one.plot(DISTANCES[distance], inside[seed, distance], marks, color=DOT, markersize=5, clip_on=False)
        one.plot(DISTANCES, np.clip(ratios.mean(axis=0), LOW, HIGH), color=LINE, linewidth=1.5)
        one.axhline(1, color="0.3", linewidth=0.8, linestyle="--")
        worst = np.sqrt(np.mean((ratios - 1) ** 2, axis=0)).max()
        one.set_title(f"{method}: error up to {100 * worst:.2g} %" if worst < 1 else f"{method}: error up to {worst:.2g} times the truth",
                      loc="left", fontsize=10)
        one.set_xscale("log")
        one.set_yscale("log")
        one.set_ylim(LOW, HIGH)
        one.set_yticks([0.2, 0.5, 1, 2, 5])
        one.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        one.yaxis.set_minor_formatter(NullFormatter())
        one.set_xticks([1e-4, 1e-3, 1e-2, 1e-1, 1], ["0.1 mm", "1 mm", "1 cm", "10 cm", "1 m"])
        one.tick_params(labelbottom=True, labelsize=8)
        one.grid(color="0.92")
    key = axes[len(found)]
    key.set_axis_off()
    for k, (mark, colour, text) in enumerate(((".", DOT, "one estimate"), ("^", DOT, "one beyond the chart"),
                                              ("_", LINE, f"mean of {len(SEEDS)} estimates"), ("_", "0.3", "truth, 250 lx"))):
        key.plot(0.08, 0.75 - 0.16 * k, mark, color=colour, markersize=9, transform=key.transAxes, clip_on=False)
        key.text(0.16, 0.75 - 0.16 * k, text, va="center", transform=key.transAxes, fontsize=10)
    figure.suptitle(f"Illuminance beside an edge over its true value, {TRAJECTORIES} trajectories", x=0.05, ha="left", fontsize=13)
    figure.supxlabel("distance from the wall", fontsize=10)
    figure.subplots_adjust(left=0.05, right=0.985, top=0.88, bottom=0.1, hspace=0.28, wspace=0.09)
    figure.savefig(path, metadata={"Software": None})


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
