#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A solve on several processes: a hall with racks, whose trajectories MPI ranks share out.

    PYTHONPATH=build/python mpiexec -n 4 examples/mpi_hall.py OUT

The first rank writes OUT/mpi-hall.png and OUT/mpi-hall.npz and prints a digest of the numbers: it is the same for every number of
ranks, without mpiexec too. The call is the same as in one process; ranks.join() is all that MPI adds.
"""
from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos import ranks

joined = ranks.join()  # before anything is solved: from here on the filters share their work with the other ranks
import kalos  # noqa: E402
from kalos.pictures.scale import colour_bar, colour_scale  # noqa: E402

LENGTH, WIDTH, HEIGHT = 30.0, 20.0, 7.0  # m
COLUMNS, ROWS, TRAJECTORIES = 90, 60, 1600


def hall() -> tuple[list[vtkPolyData], vtkPolyData]:
    """Three double rows of racks under five rows of panels."""
    shell = kalos.box((LENGTH / 2, WIDTH / 2, HEIGHT / 2), (LENGTH, WIDTH, HEIGHT), [0.25, 0.7, 0.5, 0.5, 0.5, 0.5], inwards=True)
    racks = [kalos.box((LENGTH / 2, y, 2.25), (22, 2.2, 4.5), 0.35) for y in (4.0, 10.0, 16.0)]
    x, y = np.meshgrid(np.linspace(3, LENGTH - 3, 7), np.linspace(1.5, WIDTH - 1.5, 5))
    panels = kalos.panel(np.stack([x, y, np.full_like(x, HEIGHT - 0.3)], axis=-1).reshape(-1, 3), (1.2, 0, 0), (0, 0.3, 0), 12000)
    return [shell, *racks], panels


def floor() -> NDArray[np.float64]:
    x, y = np.meshgrid((np.arange(COLUMNS) + 0.5) * LENGTH / COLUMNS, (np.arange(ROWS) + 0.5) * WIDTH / ROWS)
    return np.stack([x, y, np.full_like(x, 0.02)], axis=-1)


def draw(path: Path, lux: kalos.Illuminance) -> None:
    figure = Figure(figsize=(12, 3.9), dpi=110)
    FigureCanvasAgg(figure)
    x, y = lux.points[0, :, 0], lux.points[:, 0, 1]
    racks = lux.illuminance < 0.02 * lux.illuminance.mean()  # what stands on the floor
    error = np.where(racks, 0, 100 * lux.standard_error / np.where(racks, 1, lux.illuminance))
    for left, title, values, label in ((0.055, "illuminance on the floor", lux.illuminance, "lx"),
                                       (0.555, "its relative standard error", error, "%")):
        axes = figure.add_axes((left, 0.13, 0.37, 0.77))
        scale = colour_scale(values)
        shown = np.where(racks, np.nan, values)
        axes.set_facecolor("0.85")
        axes.pcolormesh(x, y, shown, shading="nearest", cmap=scale.colours, norm=scale.norm)
        axes.set_aspect("equal")
        axes.set_title(title, loc="left", fontsize=11)
        axes.set_xlabel("x, m")
        axes.set_ylabel("y, m")
        axes.set_yticks(range(0, int(WIDTH) + 1, 5))
        colour_bar(axes, scale, label)
    figure.savefig(path, metadata={"Software": None})


def main(out: str | Path) -> None:
    surfaces, panels = hall()
    lux = kalos.illuminance(surfaces, panels, floor(), (0, 0, 1), method="gathered", trajectories=TRAJECTORIES, progress=True)
    if joined.rank:
        return  # every rank has the result; one is enough to write it
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    np.savez(out / "mpi-hall.npz", illuminance=lux.illuminance, standard_error=lux.standard_error)
    digest = hashlib.sha256(lux.illuminance.tobytes() + lux.standard_error.tobytes()).hexdigest()
    print(f"{joined.size} ranks: mean {lux.illuminance.mean():.1f} lx, {lux.seconds:.1f} s, digest {digest[:16]}")
    draw(out / "mpi-hall.png", lux)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: mpi_hall.py OUT")
    main(sys.argv[1])
