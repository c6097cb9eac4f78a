#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How a solve scales over MPI ranks of one thread each, and the traffic measured beside its model.

    PYTHONPATH=build/python tests/benchmarks/scaling.py OUT [LARGEST_RANKS]

writes OUT/scaling.png and prints a table. Strong: the same trajectories; weak: trajectories in proportion. The speed-up is that
of the wall clock, and of processor time (one rank's over the busiest rank's), which other programs on the machine disturb
less. The bytes that a rank sends are counted by Open MPI's monitoring.

Model: after each round every rank sends its replicates' sums to the others, 8 (2 + 2 b) bytes per receiver and replicate
with b bands: the first two are KernelCorrection and the largest score. Work is shared by whole replicates, of which there
are 8: the busiest of R ranks has ceil(8 / R), so that no more than 8 ranks shorten a solve; beyond, each rank
takes more threads.
"""
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

SIDE, TRAJECTORIES, REPLICATES, BANDS = 48, 32000, 8, 1  # receivers a side of the plane
PARTICIPANT = "--participant"


def participant(trajectories):
    """One rank: its time, and the sums of the values to see that all agree."""
    from kalos import ranks

    joined = ranks.join()
    import kalos

    room = [kalos.box((2, 2, 1.5), (4, 4, 3), 0.6, inwards=True), kalos.box((2.6, 2.4, 0.5), (1, 1, 1), 0.4)]
    x, y = np.meshgrid((np.arange(SIDE) + 0.5) * 4 / SIDE, (np.arange(SIDE) + 0.5) * 4 / SIDE)
    plane = np.stack([x, y, np.full_like(x, 1.2)], axis=-1)
    before = os.times()
    result = kalos.illuminance(room, kalos.luminaire((2, 2, 2.9), 3000), plane, (0, 0, 1), trajectories=trajectories, threads=1)
    after = os.times()
    print(json.dumps({"rank": joined.rank, "seconds": result.seconds, "cpu": after.user - before.user,
                      "digest": [float(v) for v in (result.illuminance.sum(), result.standard_error.sum())]}), flush=True)


def measure(count, trajectories):
    """Wall clock, processor time of the busiest rank, bytes sent by the first one, digest."""
    with tempfile.TemporaryDirectory() as folder:
        monitor = [] if count == 1 else ["--mca", "pml_monitoring_enable", "1", "--mca", "pml_monitoring_enable_output", "3", "--mca",
                                         "pml_monitoring_filename", f"{folder}/sent"]
        run = subprocess.run(["mpiexec", "--allow-run-as-root", "--bind-to", "none", *monitor, "-n", str(count), sys.executable,
                              __file__, PARTICIPANT, str(trajectories)], capture_output=True, text=True, check=True)
        said = json.JSONDecoder()
        reports, rest = [], run.stdout.strip()
        while rest:  # lines of several ranks may run into each other
            report, end = said.raw_decode(rest)
            reports.append(report)
            rest = rest[end:].strip()
        sent = 0
        for line in (Path(folder) / "sent.0.prof").read_text().splitlines() if count > 1 else ():
            if line.startswith("C\t"):
                sent += int(line.split("\t")[3].split()[0])
    assert len({tuple(report["digest"]) for report in reports}) == 1
    return max(r["seconds"] for r in reports), max(r["cpu"] for r in reports), sent, reports[0]["digest"]


def share(count):
    """Replicates of the busiest rank."""
    return math.ceil(REPLICATES / count)


def modelled_bytes(count, rounds):
    """What an all-gather in a ring moves through the first rank: all sums but those of its neighbour."""
    return rounds * SIDE**2 * REPLICATES * 8 * (2 + 2 * BANDS) * (count - 1) / count


def draw(path, strong, weak):
    figure = Figure(figsize=(11, 4.2), dpi=110)
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2)
    counts = list(strong)
    for axes, found, title, ideal in ((left, strong, "strong scaling: the same work", counts),
                                      (right, weak, "weak scaling: work in proportion", counts)):
        factor = 1 if found is strong else np.array(counts)
        for k, (label, colour) in enumerate((("wall clock", "#c2571a"), ("processor time of the busiest rank", "#0b5d8f"))):
            axes.plot(counts, factor * np.array([found[1][k] / found[c][k] for c in counts]), "o-", color=colour, label=label)
        axes.plot(counts, ideal, "--", color="0.5", label="ideal")
        axes.set_title(title, loc="left", fontsize=11)
        axes.set_xlabel("ranks")
        axes.set_ylabel("speed-up")
        axes.set_xticks(counts)
        axes.set_ylim(0, None)
        axes.grid(color="0.92")
    left.legend(frameon=False, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, metadata={"Software": None})


def main(out, largest):
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    counts = [c for c in (1, 2, 4, 8) if c <= largest]
    strong = {c: measure(c, TRAJECTORIES) for c in counts}
    assert len({tuple(found[3]) for found in strong.values()}) == 1, "ranks have changed the numbers"
    weak = {c: measure(c, TRAJECTORIES * c) for c in counts}
    rounds = {c: max(1, round(strong[c][2] / modelled_bytes(c, 1))) for c in counts[1:]}
    print("ranks  speed-up: wall  cpu   weak: wall  cpu   bytes sent by rank 0   model (rounds)")
    for c in counts:
        traffic = "" if c == 1 else f"{strong[c][2]:>17}   {modelled_bytes(c, rounds[c]):>12.0f} ({rounds[c]})"
        print(f"{c:5}  {strong[1][0] / strong[c][0]:14.2f}  {strong[1][1] / strong[c][1]:4.2f}  "
              f"{c * weak[1][0] / weak[c][0]:10.2f}  {c * weak[1][1] / weak[c][1]:4.2f}  {traffic}")
    each = strong[1][1] / REPLICATES
    print(f"model for 1000 ranks: {each:.3f} s of work a replicate, {8 * (2 + 2 * BANDS)} bytes per receiver, replicate and round; "
          f"speed-up {REPLICATES / share(1000):.0f}: it stops at {REPLICATES} ranks, which then send "
          f"{modelled_bytes(REPLICATES, 1) / 1e6:.1f} MB each and round")
    draw(out / "scaling.png", strong, weak)


if __name__ == "__main__":
    if sys.argv[1:2] == [PARTICIPANT]:
        participant(int(sys.argv[2]))
    elif len(sys.argv) in (2, 3):
        main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else os.cpu_count())
    else:
        sys.exit("usage: scaling.py OUT [LARGEST_RANKS]")
