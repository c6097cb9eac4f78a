#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error against processor time on a row of scenes, easy and hard, of Kalos and a path tracer: one table and one picture.

    PYTHONPATH=build/python tests/benchmarks/rows.py OUT [--rows a,b,...] [--budget SECONDS] [--peers a,b] [--of value|mean]

Rows, each a `kalos chart` in OUT/ROW: floor, plane and walls of the Cornell room, a plane of 96 x 64 points in an office of
275 000 triangles under 8 rectangles, 48 points from 0.1 mm to 2.5 m off an edge in the room (edge) and in the white furnace
(furnace), 64 x 64 points 1 mm off a wall (wall), Sobolev's planes, and an image of 512 x 512 pixels. Glossy ones: 4 % lobes on everything (few), a polished floor (tiles), all
satin but for a polished chest (satin), and a living room of tiles, steel and lacquer: plane, wall and image (living...). Rows that are not asked
for keep what an earlier run left in OUT; `--rows none` only draws. Peers are found as by `kalos chart`.

rows.txt, rows.csv and rows.png show all rows in OUT: processor seconds to 5, 2, 1, 0.5 and 0.3 % rms error, how many times
longer the best peer takes, and the bias of `gathered`, measured and by its own account.
"""
import argparse
import csv
import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from rows_picture import draw

import kalos  # noqa: F401  finds VTK
from kalos.charts.chart import GOALS, chart
from kalos.charts.contenders import PEERS
from kalos.charts.convergence import time_to

DATA = Path(__file__).resolve().parents[2] / "data"
OFFICE = "office"  # its scene is made into OUT when it is first asked for


@dataclass(frozen=True)
class Row:
    title: str
    scene: str  # below data/, or OFFICE
    receivers: str = None
    camera: str = None
    reference: int = 400_000  # trajectories, where no closed form is known; its noise is taken out of the errors


ROWS = {"floor": Row("Cornell room, floor 64 x 64", "cornell/cornell.json", "floor"),
        "plane": Row("Cornell room, plane 64 x 64", "cornell/cornell.json", "desk"),
        "walls": Row("Cornell room, walls", "cornell/cornell.json", "walls", reference=200_000),
        "office": Row("office, plane 96 x 64", OFFICE, "desks", reference=60_000),
        "edge": Row("Cornell room, 0.1 mm to 2.5 m off an edge", "chart/edge-cornell.json", reference=1_000_000),
        "furnace": Row("white furnace, 0.1 mm to 2.5 m off an edge", "chart/edge-furnace.json"),
        "wall": Row("Cornell room, 64 x 64 points 1 mm off a wall", "chart/wall-cornell.json"),
        "sobolev": Row("Sobolev's planes, 0 to 10 H", "chart/sobolev-row.json"),
        "image": Row("Cornell room, image 512 x 512", "chart/image-cornell.json", camera="front", reference=16_000),
        "few": Row("lobes of 4 %, plane", "chart/gloss-few.json", "plane"),
        "tiles": Row("polished floor, plane", "chart/gloss-floor.json", "plane"),
        "satin": Row("all satin, a polished chest, plane", "chart/gloss-satin.json", "plane"),
        "living": Row("living room, plane", "chart/gloss-living.json", "plane"),
        "living-wall": Row("living room, a wall", "chart/gloss-living.json", "wall"),
        "living-image": Row("living room, image 256 x 192", "chart/gloss-living.json", camera="eye", reference=64_000)}
METHODS = ("gathered", "compensated")
NAMES = [f"{100 * goal:g} %" for goal in GOALS]


def measure(name, out, peers, budget, methods=METHODS):
    row = ROWS[name]
    scene = DATA / row.scene
    if row.scene == OFFICE:
        scene = out / "office-scene" / "office-rectangles.json"
        if not scene.exists():
            subprocess.run([sys.executable, DATA / "office" / "make.py", scene.parent], check=True)
    print(f"{name}: {row.title}", file=sys.stderr, flush=True)
    chart(scene, out / name, row.receivers, methods, peers, budget=budget, reference=row.reference, camera=row.camera,
          say=lambda text: print(text, flush=True))


def read(out):
    """The results of all rows that OUT holds, in their order."""
    return {name: json.loads((out / name / "chart.json").read_text()) for name in ROWS if (out / name / "chart.json").exists()}


def times(result, of):
    """Per contender and goal: seconds, how found, and the best peer's seconds over them; relative to `of`."""
    found = {}
    for one in result["contenders"]:
        steps = [step for step in result["steps"] if step["contender"] == one["name"]]
        seconds, errors = ([step[key] for step in steps] for key in ("cpu_seconds", f"rms_of_{of}"))
        found[one["name"]] = [time_to(goal, seconds, errors) for goal in GOALS]
    peers = [found[one["name"]] for one in result["contenders"] if one["peer"]]
    best = [min((times[k].seconds for times in peers if times[k].seconds), default=None) for k in range(len(GOALS))]
    return {name: [(one.seconds, one.how, best[k] / one.seconds if best[k] and one.seconds else None)
                   for k, one in enumerate(own)] for name, own in found.items()}


def cell(seconds, how, ratio, peer):
    if seconds is None:
        return "-"
    mark = {"interpolated": "", "extrapolated": "*", "at most": "<"}[how]
    text = f"<{seconds:.3g}" if mark == "<" else f"{seconds:.3g}{mark}"
    return text if peer or ratio is None else f"{text} ({ratio:.2g}x)"


def table(results, of):
    """The table for a person, and its rows for a file."""
    lines, rows = [("row", "", *NAMES)], []
    for name, result in results.items():
        found = times(result, of)
        for one in result["contenders"]:
            lines.append((name if one is result["contenders"][0] else "", one["name"],
                          *(cell(*time, one["peer"]) for time in found[one["name"]])))
            rows += [(name, one["name"], goal, seconds, how, ratio) for goal, (seconds, how, ratio) in zip(NAMES, found[one["name"]])]
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    drawn = "\n".join("  ".join([line[0].ljust(widths[0]), line[1].ljust(widths[1]),
                                 *(c.rjust(w) for c, w in zip(line[2:], widths[2:]))]).rstrip() for line in lines)
    note = ("(2x): the best peer takes twice as long; *: extrapolated; <: the least effort is that good; -: not in 16 times the "
            "longest run")
    return f"processor seconds to an rms error, relative to each {of}\n{drawn}\n{note}\n", rows


def biases(results):
    """What `gathered` is off by in each row: measured, by its own account, and at 95 % of the values."""
    lines = [("row", "bias of the mean, %", "by its own account, %", "95 % of the values within, %", "noise taken out, %")]
    for name, result in results.items():
        for one in result["contenders"]:
            own = one["bias"]
            if one["name"] == "gathered" and "stated" in own:
                lines.append((name, f"{100 * own['mean']:+.3f} +- {100 * own['mean_error']:.3f}",
                              f"{100 * own['stated']:+.3f} +- {100 * own['stated_error']:.3f}", f"{100 * own['p95']:.2f}",
                              f"{100 * own['p95_noise']:.2f}"))
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join("  ".join(c.ljust(w) for c, w in zip(line, widths)).rstrip() for line in lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Error against processor time on a row of scenes, with one table and one picture.")
    parser.add_argument("out", type=Path, metavar="OUT")
    parser.add_argument("--rows", default=",".join(ROWS), metavar="a,b,...", help=f"some of {', '.join(ROWS)}, or none")
    parser.add_argument("--peers", default="mitsuba", metavar="a,b,...", help=f"some of {', '.join(PEERS)}, or none (%(default)s)")
    parser.add_argument("--budget", type=float, default=40.0, metavar="SECONDS", help="per method and row (%(default)g)")
    parser.add_argument("--of", choices=("value", "mean"), default="value", help="what errors are relative to (%(default)s)")
    arguments = parser.parse_args()
    wanted, peers = ([name for name in text.split(",") if name != "none"] for text in (arguments.rows, arguments.peers))
    for name, known in [(name, ROWS) for name in wanted] + [(name, PEERS) for name in peers]:
        if name not in known:
            parser.error(f"{name!r} is not known, expected some of {', '.join(known)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in wanted:
        measure(name, arguments.out, peers, arguments.budget)
    results = read(arguments.out)
    if not results:
        parser.error(f"{arguments.out} holds no row yet")
    text, rows = table(results, arguments.of)
    text += "\nbias of gathered\n" + biases(results)
    print(text, end="")
    (arguments.out / "rows.txt").write_text(text, encoding="utf-8")
    with open(arguments.out / "rows.csv", "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("row", "contender", "rms_error", "cpu_seconds", "how", "best_peer_over_this"))
        writer.writerows(tuple("" if value is None else value for value in row) for row in rows)
    draw(arguments.out / "rows.png", {name: (ROWS[name].title, result, times(result, arguments.of)) for name, result in results.items()},
         arguments.of, NAMES)


if __name__ == "__main__":
    main()
