# SPDX-License-Identifier: BSD-3-Clause
"""`kalos atlas`: which method fails how, on eight scenes, all methods with the same processor time.

Each method takes twice as many trajectories until a run takes its share of the time, then `SEEDS` seeds. What it makes of the
truth is put in words by the rules of `verdict`, and drawn small beside the others.
"""
import csv
from pathlib import Path

import numpy as np

from kalos.charts.atlas_picture import draw_failure, page, percent
from kalos.charts.failures import FAILURES
from kalos.core.options import METHODS
from kalos.core.output import staged, write_json
from kalos.errors import KalosError

SEEDS = 8
WINNERS = 3  # methods of least error that are named
START, MOST = 128, 10**7  # trajectories
NOTICED = 4.0  # standard errors of the mean over the seeds, from which on a deviation is a bias
SMALL = 0.02  # relative: below this nothing is said
DARK = 0.1  # of the truth: light that does not arrive
RARE = 3.0  # times the truth: a single estimate that others pay for with darkness
TAIL = 5.0  # times the median noise along the line, above which noise is a spike
COLUMNS = ("scene", "method", "position_m", "truth_lx", "truth_error_lx", "mean_lx", "noise_lx", "trajectories", "cpu_seconds")


def atlas(out, scenes=None, methods=None, budget=1.0, seed=1, say=lambda text: None):
    """Writes pictures, a page and a table into the folder `out`; returns what is in atlas.json."""
    entries, rows = [], []
    with staged(out) as folder:
        for name in scenes or FAILURES:
            failure = FAILURES[name]()
            truth, error, source = failure.truth()
            say(f"{failure.title}: {truth.min():.3g} to {truth.max():.3g} lx by {source}")
            found = {}
            for method in methods or METHODS:
                found[method] = measure(failure, method, budget, seed)
                found[method]["verdict"] = verdict(found[method], truth, error)
                if "values" in found[method]:
                    found[method]["rms"] = float(np.sqrt(np.mean((found[method]["values"] / truth - 1) ** 2)))
                say(f"  {method:<17} {found[method]['verdict']}")
                rows += table(failure, method, found[method], truth, error)
            draw_failure(folder / f"{name}.png", failure, found, truth, source)
            ranks = sorted((one["rms"], method) for method, one in found.items() if "rms" in one)
            best = [{"method": method, "rms": rms} for rms, method in ranks[:WINNERS]]
            say("  least error: " + ", ".join(f"{one['method']} {percent(one['rms'])}" for one in best))
            entries.append({"name": name, "title": failure.title, "about": failure.about, "truth_lx": truth.tolist(), "source": source, "least_error": best,
                            "verdicts": {method: one["verdict"] for method, one in found.items()}})
        result = {"budget_seconds": budget, "seeds": SEEDS, "scenes": entries}
        write_json(folder / "atlas.json", result)
        with open(folder / "atlas.csv", "w", encoding="ascii", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerows([COLUMNS, *rows])
        (folder / "atlas.html").write_text(page(result), encoding="utf-8")
    say(f"page\n  {Path(out) / 'atlas.html'}")
    return result


def measure(failure, method, budget, seed):
    """Estimates of several seeds that take the budget together, or why there are none."""
    trajectories = START
    try:
        while True:
            run = failure.solve(method, trajectories, seed)
            if run.cpu_seconds >= budget / SEEDS / 2 or trajectories >= MOST:
                break
            trajectories *= 2
        runs = [failure.solve(method, trajectories, seed + 1 + k) for k in range(SEEDS)]
    except KalosError as error:
        return {"refused": str(error).partition("; expected")[0]}
    return {"values": np.array([one.illuminance for one in runs]), "trajectories": trajectories,
            "cpu_seconds": sum(one.cpu_seconds for one in runs)}


def verdict(found, truth, truth_error):
    """How a method does along a line, in words."""
    if "refused" in found:
        return "refuses: " + found["refused"].partition(": ")[2]
    ratios = found["values"] / truth
    mean, noise = ratios.mean(axis=0), ratios.std(axis=0, ddof=1)
    uncertain = np.hypot(noise / np.sqrt(len(ratios)), truth_error / truth)
    said = []
    typical = float(np.sqrt(np.mean(noise**2)))
    if ratios.max() > RARE and np.mean(ratios < DARK) > 1 / 3:
        return f"rare spikes: up to {ratios.max():.2g} times the truth"
    if np.median(mean) < DARK:
        return "never arrives at half of the places"
    if ratios.max() > 1 + TAIL * max(np.median(noise), SMALL) and noise.max() > TAIL * np.median(noise):
        said.append(f"spikes: up to {ratios.max():.2g} times the truth")
    off = np.where(np.abs(mean - 1) > NOTICED * uncertain, mean - 1, 0)
    worst = off[np.argmax(np.abs(off))]
    if abs(worst) > SMALL:
        said.append(f"bias: {'too bright' if worst > 0 else 'too dark'} by up to {percent(abs(worst))}")
    if not said:
        said.append(f"noise: {percent(typical)}" if typical > SMALL else f"within {100 * max(typical, 1e-3):.1g} %")
    return "; ".join(said)


def table(failure, method, found, truth, error):
    if "refused" in found:
        return
    for i, position in enumerate(failure.along):
        values = found["values"][:, i]
        numbers = (position, truth[i], error[i], values.mean(), values.std(ddof=1))
        yield (failure.name, method, *(repr(float(x)) for x in numbers), found["trajectories"], f"{found['cpu_seconds']:.3g}")
