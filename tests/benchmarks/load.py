#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `kalos solve` takes of time and memory where scenes grow large, with fitted exponents, beside the memory predicted.

    PYTHONPATH=build/python tests/benchmarks/load.py OUT [--largest N] [--series NAME]

One number grows, the others stay as in growth.py: 100 receivers on a plane, 100 boxes in a room, one luminaire, 640
trajectories. Each solve is a process of its own on one thread, with everything: reading the mesh from a PLY file, its repair, the
search for singular edges, the solve, tables and pictures. Time is processor time, memory the most that the process held. The
exponents are slopes through the last three sizes, of memory of what it has more than at the smallest, where that is 20 MB or more. Writes OUT/load.png and OUT/load.json.
At the largest sizes, 10^7 triangles, 10^6 receivers, 10^4 luminaires, some minutes and some gigabytes.
"""
import argparse
import json
import multiprocessing
import os
import subprocess
import tempfile
from pathlib import Path

import growth
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from kalos.solving import memory

KALOS = Path(__file__).resolve().parents[2] / "build" / "bin" / "kalos"
SIZES = {"triangles": (10**4, 10**5, 10**6, 10**7), "receivers": (10**3, 10**4, 10**5, 10**6), "luminaires": (10, 100, 1000, 10**4)}
COLOURS = {"triangles": "#0b5d8f", "receivers": "#c2571a", "luminaires": "#3f7f4f"}
LABELS = {"triangles": (-2, 9, -9, "left"), "receivers": (-2, -8, 6, "right"), "luminaires": (0, 0, -7, "left")}  # point, offset, side
GROWN = 20e6  # bytes beyond the smallest scene's that say something of growth


def write_ply(path, points, triangles):
    faces = np.empty(len(triangles), [("corners", "u1"), ("corner", "<i4", 3)])
    faces["corners"], faces["corner"] = 3, triangles
    with open(path, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\n" f"element vertex {len(points)}\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        points.astype("<f8").tofile(file)
        faces.tofile(file)


def write_scene(folder, triangles, receivers, luminaires):
    """A scene file; returns how many triangles and receivers there are."""
    points, faces = growth.room_mesh(triangles)
    write_ply(folder / "room.ply", points, faces)
    side = round(np.sqrt(receivers))
    places = growth.lamp_places(luminaires)
    scene = {"kalos": 1, "materials": {"grey": {"reflectance": 0.5}},
             "surfaces": [{"name": "room", "file": "room.ply", "material": "grey"}],
             "luminaires": [{"name": f"lamp {k}", "position": place, "aim": [0, 0, -1], "flux": 100000 / luminaires,
                             "distribution": "lambertian"} for k, place in enumerate(places)],
             "receivers": [{"name": "plane", "plane": {"origin": [0, 0, 0.75], "u": [growth.SIDE, 0, 0], "v": [0, growth.SIDE, 0],
                                                       "resolution": [side, side]}}]}
    (folder / "scene.json").write_text(json.dumps(scene))
    return len(faces), side * side


def measure(triangles=1000, receivers=100, luminaires=1):
    """Counts, seconds and bytes of one solve."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with multiprocessing.Pool(1) as pool:  # a child's most is never less than what its parent once held
            triangles, receivers = pool.apply(write_scene, (folder, triangles, receivers, luminaires))
        command = [KALOS, "solve", folder / "scene.json", "--out", folder / "out", "--trajectories", "640", "--threads", "1"]
        with open(folder / "log", "w") as log:
            process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(process.pid, 0)
        if status:
            raise SystemExit((folder / "log").read_text())
        result = json.loads((folder / "out" / "summary.json").read_text())
    return {"triangles": triangles, "receivers": receivers, "luminaires": luminaires,
            "seconds": usage.ru_utime + usage.ru_stime, "solve": result["cpu_seconds"], "bytes": 1024 * usage.ru_maxrss,
            "predicted": memory.demand(triangles, receivers, luminaires)}


def grow(name, sizes):
    """Measures and prints a series; with its exponents of time and memory where there are sizes enough."""
    rows = []
    print(f"{name:>11} {'all, s':>10} {'solve, s':>10} {'memory, GB':>11} {'predicted':>10}")
    for size in sizes:
        row = measure(**{name: size})
        rows.append(row)
        print(f"{row[name]:>11} {row['seconds']:>10.2f} {row['solve']:>10.2f} {row['bytes'] / 1e9:>11.3f} "
              f"{row['predicted'] / 1e9:>10.3f}", flush=True)
    if len(rows) < 3:
        return rows, None
    slopes = exponents(name, rows)
    print(f"   exponent {slopes[0]:>10.2f} {'':>10} {'-' if slopes[1] is None else format(slopes[1], '.2f'):>11}\n", flush=True)
    return rows, slopes


def exponents(name, rows):
    """Of time, and of memory; None where that hardly grows."""
    counts, more = (np.array([row[key] for row in rows], float) for key in (name, "bytes"))
    more -= more[0]
    grown = more > GROWN
    return [growth.exponent(counts, np.array([row["seconds"] for row in rows])),
            growth.exponent(counts[grown], more[grown]) if grown.sum() > 1 else None]


def draw(path, series):
    figure = Figure(figsize=(11, 4.6), dpi=110, layout="constrained")
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2)
    for name, (rows, slopes) in series.items():
        counts = [row[name] for row in rows]
        for axes, key, unit, slope in ((left, "seconds", 1, 0), (right, "bytes", 1e9, 1)):
            values = [row[key] / unit for row in rows]
            axes.plot(counts, values, "o-", color=COLOURS[name], linewidth=1.6, markersize=4)
            label = name + (f", exponent {slopes[slope]:.2f}" if slopes and slopes[slope] is not None else "")
            at, right_by, up_by, side = LABELS[name]
            at = at % len(rows)
            axes.annotate(label, (counts[at], values[at]), (right_by, up_by), textcoords="offset points", ha=side,
                          va="bottom" if up_by > 0 else "top", color=COLOURS[name], fontsize=9)
        right.plot(counts, [row["predicted"] / 1e9 for row in rows], "--", color=COLOURS[name], linewidth=1, alpha=0.7)
    right.plot([], [], "--", color="0.5", linewidth=1, label="predicted: what a solve is refused by")
    right.legend(frameon=False, fontsize=9, loc="upper left")
    for axes, title, label in ((left, "Time of kalos solve", "processor time, s"), (right, "Memory", "most held, GB")):
        axes.set_title(title, loc="left", fontsize=11)
        axes.set(xscale="log", yscale="log", xlabel="triangles, receivers or luminaires", ylabel=label)
        axes.margins(0.08, 0.14)
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(True, which="major", color="0.92")
    figure.savefig(path, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description="Time and memory of large scenes.")
    parser.add_argument("out", type=Path)
    parser.add_argument("--largest", type=int, default=10**9, metavar="N", help="leave out sizes beyond N")
    parser.add_argument("--series", choices=SIZES, action="append", help="only this one; may be repeated")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    series = {name: grow(name, [size for size in SIZES[name] if size <= arguments.largest])
              for name in arguments.series or SIZES}
    (arguments.out / "load.json").write_text(json.dumps({name: {"rows": rows, "exponents": slopes}
                                                         for name, (rows, slopes) in series.items()}, indent=1))
    draw(arguments.out / "load.png", series)
    print(arguments.out / "load.png")


if __name__ == "__main__":
    main()
