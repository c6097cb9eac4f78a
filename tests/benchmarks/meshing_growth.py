#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how long repair and the search for edges take at 10^4, 10^5 and 10^6 triangles beside n log n.

    tests/benchmarks/meshing_growth.py build/bin/MeshingBenchmarks OUT.png
"""
import re
import subprocess
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def main(program, out):
    run = subprocess.run([program], capture_output=True, text=True)
    print(run.stdout, end="")
    rows = np.array([[float(word) for word in line.split()] for line in run.stdout.splitlines()
                     if re.fullmatch(r"\s*\d+(\s+[\d.]+){5}", line)])
    figure, axes = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
    n = np.geomspace(rows[0, 0], rows[-1, 0], 60)
    for column, name, colour in ((1, "repair", "#3b6fb6"), (2, "singular edges", "#c8553d")):
        seconds = rows[:, column]
        axes.plot(n, seconds[-1] * n * np.log(n) / (n[-1] * np.log(n[-1])), "--", color=colour, linewidth=1, alpha=0.6)
        axes.plot(rows[:, 0], seconds, "o", color=colour)
        above = name != "repair"  # the search for edges takes longer
        axes.annotate(f"{name}, {seconds[-1]:.2g} s", (rows[-1, 0], seconds[-1]), (-10, 4) if above else (6, -22),
                      textcoords="offset points", ha="right", va="bottom" if above else "top", color=colour)
    axes.plot([], [], "--", color="grey", linewidth=1, label="n log n through the last point")
    axes.margins(y=0.1)
    axes.set(xscale="log", yscale="log", xlabel="triangles", ylabel="processor time (s)")
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(True, which="major", color="0.9")
    axes.legend(frameon=False, loc="upper left")
    figure.savefig(out, dpi=150)
    return run.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
