#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed against accuracy: how long every method takes for an error of 5, 2, 1, 0.5 and 0.3 % on the desk plane of the Cornell room.

    PYTHONPATH=build/python examples/speed_accuracy.py OUT

writes OUT/chart.csv, chart.json, chart.png and chart.svg, and prints the fastest for every goal. Mitsuba 3 and Radiance take
part where KALOS_PEERS_PYTHON names a Python that has them. Times are processor seconds of one thread, errors are the root
mean square over the receivers and four seeds, over the mean of a converged reference. `kalos chart` does this for any scene.
"""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, Sequence

import kalos
from kalos.charts.contenders import PEERS

ROOM = Path(__file__).resolve().parents[1] / "data" / "cornell" / "cornell.json"
METHODS = ("compensated", "gathered", "local", "sphere-exact")
BUDGET, REFERENCE = 60.0, 4_000_000  # s of processor time each; trajectories of the reference


def fastest(result: dict[str, Any], goal: str) -> tuple[float, str] | None:
    """Name and time of the contender that reaches the goal first; nothing when none does."""
    times = [(one["seconds_to"][goal]["cpu_seconds"], one["label"]) for one in result["contenders"]]
    return min((time for time in times if time[0] is not None), default=None)


def main(out: str | Path, peers: Sequence[str] = tuple(PEERS)) -> None:
    result = kalos.chart(ROOM, out, receivers="desk", methods=METHODS, peers=peers, relative_to="mean", budget=BUDGET,
                         reference_trajectories=REFERENCE, say=print)
    for goal in result["contenders"][0]["seconds_to"]:
        found = fastest(result, goal)
        print(f"{goal}: " + (f"{found[1]}, {found[0]:.3g} s" if found else "none"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: speed_accuracy.py OUT")
    main(sys.argv[1])
