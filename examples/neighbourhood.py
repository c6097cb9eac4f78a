#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How to choose delta and epsilon: the error near edges over both, on four scenes, and where the automatic rule lands.

    PYTHONPATH=build/python examples/neighbourhood.py OUT

writes OUT/neighbourhood.csv and OUT/neighbourhood.png, in a few minutes. The error is the root mean square of the relative
errors at random points nearer than 0.25 m to a concave edge or contact, over several seeds. Above: delta varies and
epsilon = 0.6 delta. Below: epsilon varies at the delta of the rule. The scenes: white furnace with boxes, the Cornell room
with and without its boxes, a tessellated sphere (all of it a shallow concave edge). The truth of the furnace is known, of
the others it is an estimate by `compensated` with forty times the trajectories.
"""
from __future__ import annotations

import csv
import re
import sys
from pathlib import Path
from typing import Any, Dict, Iterator

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.core.options import REFERENCE_SEED, Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.results.fields import audit
from kalos.results.receivers import from_dataset, point_receivers
from kalos.scenes.clearance import clearance, triangles
from kalos.scenes.reading import read_scene
from kalos.validation import truths

DATA = Path(__file__).resolve().parents[1] / "data"
SCENES = {"furnace, boxes": "furnace/furnace.json", "Cornell room": "cornell/cornell.json",
          "Cornell room, empty": "cornell/cornell-empty.json", "sphere": "sphere/sphere-3.json"}
Row = Dict[str, Any]
NEAR, POINTS, TRAJECTORIES, SEEDS = 0.25, 400, 10000, (1, 2, 3)
LENGTHS = (0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.25, 0.4, 0.7)
COLOURS = {"sphere-exact": "#0b5d8f", "clamped": "#c2571a"}
MARKS, SIZES = {"sphere-exact": "*", "clamped": "D"}, {"sphere-exact": 16, "clamped": 6}  # of the automatic choice


def receivers_near_edges(faces: NDArray[np.float64]) -> vtkPolyData:
    """Random points on the fronts of the faces, uniform by area, as vtkPolyData with normals; seed 1."""
    rng = np.random.default_rng(1)
    across = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
    areas = np.linalg.norm(across, axis=1)
    points, normals = np.zeros((0, 3)), np.zeros((0, 3))
    while len(points) < POINTS:
        chosen = rng.choice(len(faces), 2000, p=areas / areas.sum())
        candidates = np.einsum("nk,nkx->nx", rng.dirichlet((1, 1, 1), 2000), faces[chosen])
        fronts = across[chosen] / areas[chosen, None]
        near = clearance(candidates, fronts, faces) < NEAR
        points, normals = np.concatenate([points, candidates[near]]), np.concatenate([normals, fronts[near]])
    return point_receivers(points[:POINTS], normals[:POINTS])


class Study:
    """One scene, its receivers near edges and the truth there."""

    def __init__(self, name: str, path: Path) -> None:
        self.name, self.reader = name, read_scene(path)
        self.receivers = receivers_near_edges(triangles(self.reader.GetOutputDataObject(0)))
        self.truth = self.solve(Options(trajectories=40 * TRAJECTORIES, seed=REFERENCE_SEED))[0]
        # Random points fall inside the boxes too, on what stands on the floor: no one measures there.
        self.valid = self.truth > 0.02 * np.median(self.truth)
        if name.startswith("furnace"):
            furnace = truths.white_furnace(0.6, 100)
            self.valid = np.abs(self.truth / furnace - 1) < 0.2
            self.truth = np.full(len(self.truth), furnace)

    def solve(self, options: Options) -> tuple[NDArray[np.float64], str]:
        """Values and what the audit says about the kernel."""
        estimator = illuminance_filter(self.reader, options)
        estimator.SetInputDataObject(0, self.receivers)
        update(estimator)
        output = estimator.GetOutputDataObject(0)
        kernel, = (entry["choice"] + " " + entry["reason"] for entry in audit(output) if entry["subject"] == "kernel")
        return from_dataset(self.name, output).illuminance, kernel

    def error(self, **settings: Any) -> float:
        """Root mean square relative error over receivers and seeds."""
        squares = []
        for seed in SEEDS:
            values, self.kernel = self.solve(Options(trajectories=TRAJECTORIES, seed=seed, **settings))
            squares.append(np.mean((values[self.valid] / self.truth[self.valid] - 1) ** 2))
        return float(np.sqrt(np.mean(squares)))

    def rows(self) -> Iterator[Row]:
        """Dictionaries for the table: series, method, delta, epsilon, error."""
        rule = self.error(method="sphere-exact")
        epsilon, delta = map(float, re.findall(r"([0-9.]+) m\b", self.kernel)[:2])  # the audit says what was chosen

        def row(series: str, method: str, delta: float | None, epsilon: float | None, error: float) -> Row:
            print(f"{self.name:<20} {series:<8} {method:<13} {delta or 0:8.3f} {epsilon or 0:8.3f} {100 * error:8.2f} %", flush=True)
            return dict(zip(FIELDS, (self.name, series, method, delta, epsilon, error)))

        yield row("rule", "sphere-exact", delta, epsilon, rule)
        yield row("rule", "clamped", delta, None, self.error(method="clamped"))
        yield row("none", "compensated", None, None, self.error(method="compensated"))
        for length in LENGTHS:
            for method in ("sphere-exact", "clamped"):
                error = self.error(method=method, delta=length, epsilon=0.6 * length)
                yield row("delta", method, length, 0.6 * length, error)
        for length in LENGTHS:
            yield row("epsilon", "sphere-exact", delta, length, self.error(method="sphere-exact", delta=delta, epsilon=length))


FIELDS = ("scene", "series", "method", "delta_m", "epsilon_m", "rms_near")


def draw(path: Path, rows: list[Row]) -> None:
    figure = Figure(figsize=(13, 6.6), dpi=150)
    FigureCanvasAgg(figure)
    grid = figure.subplots(2, len(SCENES), sharey="col", squeeze=False)
    top = 1.15 * max(row["rms_near"] for row in rows) * 100
    for column, name in enumerate(SCENES):
        own = [row for row in rows if row["scene"] == name]
        for axes, series, length in zip(grid[:, column], ("delta", "epsilon"), ("delta_m", "epsilon_m")):
            for method, colour in COLOURS.items():
                line = [row for row in own if row["series"] == series and row["method"] == method]
                mark = [row for row in own if row["series"] == "rule" and row["method"] == method and row[length]]
                if line:
                    axes.plot([r[length] for r in line], [100 * r["rms_near"] for r in line], "o-", markersize=3, linewidth=1.2,
                              color=colour, label=method)
                    axes.plot([r[length] for r in mark], [100 * r["rms_near"] for r in mark], MARKS[method], markersize=SIZES[method],
                              color=colour, markeredgecolor="white", zorder=4 if method == "clamped" else 3, label=f"{method}, automatic")
            flat, = (row for row in own if row["method"] == "compensated")
            axes.axhline(100 * flat["rms_near"], color="0.4", linestyle="--", linewidth=1, label="compensated")
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_xlabel("δ, m  (ε = 0.6 δ)" if series == "delta" else "ε, m  (δ of the rule)")
            axes.grid(True, which="both", color="0.92")
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
                axis.set_minor_formatter(NullFormatter())
            axes.set_yticks([0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500])
            axes.set_ylim(max(0.7 * min(100 * r["rms_near"] for r in own), 0.1), min(top, 1.4 * 100 * max(r["rms_near"] for r in own)))
        grid[0, column].set_title(name, loc="left", fontsize=11)
    for axes in grid[:, 0]:
        axes.set_ylabel("error near edges, %")
    figure.suptitle(f"Error near edges and the size of the neighbourhood, {TRAJECTORIES} trajectories", x=0.06, ha="left", fontsize=13)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=len(labels), frameon=False)
    figure.subplots_adjust(left=0.06, right=0.985, top=0.87, bottom=0.16, hspace=0.34, wspace=0.22)
    figure.savefig(path, metadata={"Software": None})


def main(out: str | Path) -> None:
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    rows = [row for name, path in SCENES.items() for row in Study(name, DATA / path).rows()]
    with (out / "neighbourhood.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    draw(out / "neighbourhood.png", rows)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: neighbourhood.py OUT")
    main(sys.argv[1])
