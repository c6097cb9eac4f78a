# SPDX-License-Identifier: BSD-3-Clause
"""`kalos chart`: error against time for every method of Kalos and the peers that are installed, on the receivers or a camera
of a scene.

Every contender climbs a ladder of efforts, each twice the last, with several seeds a step, until its share of processor
time is used. Errors are held against a closed form where the scene has one, else against a converged reference by
`compensated`, which is unbiased; its own standard error is stated and taken out of the rms. Times are processor seconds
of the solve, set-up (reading, trees, compilation) apart, and all contenders run on the same number of threads. The bias of a
contender is what its runs have in common; where it states a bias itself, that stands beside it.
"""
import csv
import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from kalos._build import __version__
from kalos.charts.contenders import PEERS, Room, View, assemble
from kalos.charts.convergence import FARTHEST, Truth, bias, deviation_of_mean, errors, parts, time_to
from kalos.charts.picture import draw_chart
from kalos.core.options import REFERENCE_METHOD, REFERENCE_TRAJECTORIES
from kalos.core.output import staged, write_json
from kalos.errors import FAILED, KalosError
from kalos.peers import Absent
from kalos.studies.study import find_reference
from kalos.validation.cases import CASES, DATA, sobolev_case

CLOSED_FORMS = [*CASES, replace(CASES[0], scene="chart/edge-furnace.json"),
                replace(sobolev_case(0.5, 0.5, 0.5), scene="chart/sobolev-row.json")]
GOALS = (0.05, 0.02, 0.01, 0.005, 0.003)
SEEDS, FEWER_SEEDS, MANY = 4, 2, 20000  # least number of runs per step; FEWER where MANY values average the error
MOST_SEEDS, SHARE = 32, 1 / 32  # more runs where a step takes less than this share of the budget: errors of few values are uneven
FLAT = 1.25  # a step that takes less than this times the previous one is dominated by fixed costs; the next step is four times as long
COLUMNS = ("contender", "effort", "seeds", "cpu_seconds", "rays", "rms_of_value", "p95_of_value", "max_of_value", "rms_of_mean",
           "p95_of_mean", "max_of_mean", "mean_off", "mean_off_error", "noise_of_value", "bias_of_value", "noise_of_mean", "bias_of_mean")


def chart(scene, out, receivers=None, methods=None, peers=tuple(PEERS), relative_to="value", budget=60.0,
          reference=REFERENCE_TRAJECTORIES, seed=1, threads=1, say=lambda text: None, camera=None):
    """Measures into the folder `out` and returns what is in chart.json: receivers, or the image of a camera."""
    if camera and receivers:
        raise KalosError("--camera: there are --receivers already, expected one of the two")
    room = View(scene, camera) if camera else Room(scene, receivers)
    with staged(out) as folder:
        contenders = assemble(room, methods, peers, threads, say)
        if not contenders:
            raise KalosError("--methods: nothing is left to measure, expected a method or a peer that can take part")
        truth, file = find_truth(scene, room, reference, Path(out), folder)
        rows, biases = [], {}
        for contender in contenders:
            try:
                found, biases[contender.NAME] = climb(contender, truth, budget, seed)
                rows += found
            except Absent as absent:
                raise KalosError(f"{contender.NAME}: {absent}", FAILED) from None
            finally:
                contender.close()
        result = {"kalos": __version__, "scene": str(scene), "receivers": room.name, "quantity": room.quantity,
                  "lit": int(truth.lit.sum()), "dark": int((~truth.lit).sum()), "relative_to": relative_to, "threads": threads,
                  "reference": {"source": truth.source, "file": file, "rms": truth.noise(relative_to)},
                  "contenders": [{**describe(one, rows, relative_to), "bias": biases[one.NAME]} for one in contenders],
                  "steps": rows}
        compare(result["contenders"])
        write_json(folder / "chart.json", result)
        write_csv(folder / "chart.csv", rows)
        draw_chart(folder, result)
    say(text(result))
    say("pictures\n" + "\n".join(f"  {Path(out) / name}" for name in ("chart.png", "chart.svg")))
    return result


def find_truth(scene, room, count, out, folder):
    """The closed form of a scene of data/ that has one, else the reference; and the reference's file."""
    for case in CLOSED_FORMS:
        if not room.is_image and (DATA / case.scene).resolve() == Path(scene).resolve():
            values = case.truth(room.points, room.normals)
            return Truth(values, np.zeros(len(values)), "closed form"), None
    found, name = find_reference(room, count, out, folder)
    source = f"{int(found.trajectories)} trajectories of {REFERENCE_METHOD}"
    return Truth(found.values, found.standard_error, source, found.mean_error or 0.0), name


def climb(contender, truth, budget, seed):
    """Runs steps of growing effort until the next would exceed the budget: one table row per step, and the bias of all runs together."""
    rows, spent, effort, every, stated = [], 0.0, contender.START, [], []
    least = SEEDS if truth.lit.sum() < MANY else FEWER_SEEDS
    while True:
        runs, seeds = [], least
        while len(runs) < seeds:
            runs.append(contender.solve(effort, seed + len(runs)))
            stated.append(stated_bias(contender))
            if len(runs) == least:
                mean = sum(run.cpu_seconds for run in runs) / least
                seeds = max(least, min(MOST_SEEDS, int(SHARE * budget / max(mean, 1e-4))))
        every += runs
        values, seconds = [run.values for run in runs], [run.cpu_seconds for run in runs]
        spent += sum(seconds)
        rays = None if runs[0].rays is None else float(np.mean([run.rays for run in runs]))
        off, off_error = deviation_of_mean(values, truth)
        row = {"contender": contender.NAME, "effort": runs[0].effort, "seeds": seeds, "cpu_seconds": float(np.mean(seconds)),
               "rays": rays, "mean_off": off, "mean_off_error": off_error}
        for relative_to in ("value", "mean"):
            found = {**errors(values, truth, relative_to), **parts(values, truth, relative_to)}
            row.update({f"{name}_of_{relative_to}": value for name, value in found.items()})
        rows.append(row)
        print(f"{contender.NAME:<16} {contender.EFFORT} {row['effort']:>9}  {row['cpu_seconds']:9.4f} s  "
              f"rms {100 * row['rms_of_value']:7.2f} % of the value, {100 * row['rms_of_mean']:7.2f} % of the mean",
              file=sys.stderr, flush=True)
        if spent + 2 * sum(seconds) > budget:
            break
        effort *= 4 if len(rows) > 1 and row["cpu_seconds"] < FLAT * rows[-2]["cpu_seconds"] else 2
    weights = [run.effort for run in every]
    found = bias([run.values for run in every], weights, truth)
    if all(stated):
        share = np.asarray(weights) / np.sum(weights)
        means, deviations = np.transpose(stated)
        found.update(stated=float(share @ means), stated_error=float(np.sqrt(share**2 @ deviations**2)))
    return rows, found


def stated_bias(contender):
    """The bias that the audit of a contender's last run states, relative to its mean, with its standard error; None if it states none.

    The audit speaks of the gathered light. Where direct light is not told apart, in images, that is taken for all light.
    """
    last = getattr(contender, "last", None)
    for line in last.audit if last else ():
        said = line["subject"] == "bias" and re.fullmatch(r"(\S+) \+- (\S+) %", line["choice"])
        if said:
            share = 1.0 if last.direct is None else 1 - last.direct.mean() / last.values.mean()
            return [share * float(number) / 100 for number in said.groups()]
    return None


def describe(contender, rows, relative_to):
    """The table entry of a contender."""
    own = [row for row in rows if row["contender"] == contender.NAME]
    seconds, found = ([row[key] for row in own] for key in ("cpu_seconds", f"rms_of_{relative_to}"))
    times = {f"{100 * goal:g} %": time_to(goal, seconds, found) for goal in GOALS}
    return {"name": contender.NAME, "label": contender.LABEL, "peer": contender.NAME in PEERS, "version": contender.version,
            "effort": contender.EFFORT, "setup_cpu_seconds": contender.setup_cpu_seconds,
            "seconds_to": {goal: {"cpu_seconds": one.seconds, "how": one.how} for goal, one in times.items()}}


def compare(contenders):
    """Adds to every time the ratio of the best peer's time to it; above 1 is faster."""
    for goal in (f"{100 * goal:g} %" for goal in GOALS):
        peers = [one["seconds_to"][goal]["cpu_seconds"] for one in contenders if one["peer"]]
        best = min((seconds for seconds in peers if seconds), default=None)
        for one in contenders:
            own = one["seconds_to"][goal]
            own["best_peer_over_this"] = best / own["cpu_seconds"] if best and own["cpu_seconds"] else None


def write_csv(path, rows):
    with open(path, "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: "" if value is None else value for key, value in row.items()} for row in rows)


MARKS = {"interpolated": "", "extrapolated": "*", "at most": "<"}


def cell(time):
    """A time and the ratio to the best peer in few characters."""
    if time["cpu_seconds"] is None:
        return "-"
    mark, ratio = MARKS[time["how"]], time["best_peer_over_this"]
    seconds = f"<{time['cpu_seconds']:.3g} s" if mark == "<" else f"{time['cpu_seconds']:.3g} s{mark}"
    return seconds if ratio is None else f"{seconds} ({ratio:.2g}x)"


def text(result):
    """The table for a person."""
    goals = list(result["contenders"][0]["seconds_to"])
    lines = [("processor time to", *goals, "set-up")]
    for one in result["contenders"]:
        setup = one["setup_cpu_seconds"]
        times = (cell(one["seconds_to"][goal]) for goal in goals)
        lines.append((one["label"], *times, "" if setup is None else f"{setup:.2g} s"))
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    table = "\n".join("  " + "  ".join([line[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(line[1:], widths[1:]))]).rstrip()
                      for line in lines)
    reference, of = result["reference"], "each value" if result["relative_to"] == "value" else "the mean"
    threads = "one thread" if result["threads"] == 1 else f"{result['threads']} threads"
    return (f"{result['scene']}, {result['receivers']}: {result['lit']} values, {result['dark']} dark ones left out\n"
            f"rms error relative to {of}; {threads}; reference: {reference['source']}, itself within "
            f"{100 * reference['rms']:.2g} %\n{table}\n{bias_text(result['contenders'])}"
            "  (2x): the best peer takes twice as long; *: extrapolated; <: the least effort is that good; "
            f"-: not in {FARTHEST:g} times the longest run")


def bias_text(contenders):
    """A line for each contender that states a bias of its own."""
    lines = []
    for one in contenders:
        own = one["bias"]
        if "stated" in own:
            lines.append(f"  {one['label']}: bias {100 * own['mean']:+.2g} +- {100 * own['mean_error']:.1g} % of the mean, "
                         f"{100 * own['stated']:+.2g} +- {100 * own['stated_error']:.1g} % by its own account; 95 % of the "
                         f"values are within {100 * own['p95']:.2g} % (noise of {100 * own['p95_noise']:.2g} % taken out)\n")
    return "".join(lines)
