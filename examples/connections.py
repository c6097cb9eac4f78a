#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What double, triple and quadruple local estimates are worth: variance times time over the number of connections, on five scenes.

    PYTHONPATH=build/python examples/connections.py OUT

writes OUT/connections.csv and OUT/connections.png. Connection k joins a trajectory of light to the k-1st bounce of a path from the
receiver: 1 is the local estimate, 2 the double one; `all` weighs all of them by the balance heuristic. Each dot is the
squared error beside the truth times the processor time, over that of `all`: below one is cheaper than `all`.
"""
import csv
import sys
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

import kalos
from kalos.charts.failures import FAILURES

SCENES = ("furnace-edge", "contact", "keyhole", "glossy-room", "many-lamps")
CONNECTIONS = (1, 2, 3, 4, 5, 6)
SEEDS, TRAJECTORIES = range(1, 7), 256
COLOURS = ("#0b5d8f", "#2f9fd0", "#7a3e9d", "#d1457b", "#8c6d31")
HIGHEST = 1000.0  # of the chart; what costs more sits on the frame as a triangle


def cost(failure, truth, connections):
    """Mean squared relative error over the receivers times the processor time of a run."""
    own = {} if connections is None else {"connections": connections}
    runs = [kalos.illuminance(failure.surfaces, failure.luminaires, failure.points, failure.normal, method="bidirectional",
                              method_options=own, trajectories=TRAJECTORIES, seed=seed, threads=1) for seed in SEEDS]
    squares = np.mean([np.mean((run.illuminance / truth - 1) ** 2) for run in runs])
    return float(squares * np.mean([run.cpu_seconds for run in runs]))


def measure():
    """Cost of each number of connections over that of all, a row a scene."""
    found = {}
    for name in SCENES:
        failure = FAILURES[name]()
        truth, _, _ = failure.truth()
        whole = cost(failure, truth, None)
        found[failure.title] = [cost(failure, truth, k) / whole for k in CONNECTIONS]
    return found


def draw(path, found):
    figure = Figure(figsize=(8.2, 5.0), dpi=110)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.09, 0.13, 0.56, 0.7))
    axes.axhline(1, color="0.4", linewidth=1, linestyle="--")
    ends = sorted((min(max(costs[-1], 0.05), HIGHEST), title) for title, costs in found.items())
    places, step = {}, 0.42
    for value, title in ends:
        last = max(places.values(), default=-np.inf)
        places[title] = max(np.log(value), last + step)
    for colour, (title, costs) in zip(COLOURS, found.items()):
        shown = np.minimum(costs, HIGHEST)
        axes.plot(CONNECTIONS, shown, color=colour, linewidth=1.8, marker="o", markersize=4.5, clip_on=False)
        beyond = [k for k, value in zip(CONNECTIONS, costs) if value > HIGHEST]
        axes.plot(beyond, [HIGHEST] * len(beyond), "^", color=colour, markersize=7, clip_on=False)
        axes.annotate(title, (CONNECTIONS[-1], shown[-1]), xytext=(CONNECTIONS[-1] + 0.25, np.exp(places[title])), fontsize=9, color=colour,
                      va="center", annotation_clip=False, arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.5})
    axes.set_yscale("log")
    axes.set_xticks(CONNECTIONS, ["1\nlocal", "2\ndouble", "3\ntriple", "4\nquadruple", "5", "6"])
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.grid(axis="y", color="0.92")
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.set_ylabel("squared error × time, over that of all")
    figure.text(0.09, 0.95, "What n-fold local estimates are worth", fontsize=13.5, va="top")
    figure.text(0.09, 0.885, f"{len(SEEDS)} seeds of {TRAJECTORIES} trajectories; one thread; a shorter path has its longest connection. Dashed: all together.",
                fontsize=9, color="0.4", va="top")
    figure.savefig(path, metadata={"Software": None})


def main(out):
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    found = measure()
    with (out / "connections.csv").open("w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["scene", *(f"{k}_over_all" for k in CONNECTIONS)])
        writer.writerows([title, *(f"{value:.4g}" for value in costs)] for title, costs in found.items())
    draw(out / "connections.png", found)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: connections.py OUT")
    main(sys.argv[1])
