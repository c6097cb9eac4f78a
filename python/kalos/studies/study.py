# SPDX-License-Identifier: BSD-3-Clause
"""`kalos study`: many settings on one scene, each against a converged reference.

study.csv and study.json have one row per distinct setting; study.png shows the images. Errors are relative to the
reference value by value: the root of their mean square over the values nearer than NEAR to a concave edge or contact, and
over all others. The bias is the mean of estimate less reference over the mean of the reference: of one solve, so that the
noise of a mean over all values is in it.
"""
import csv
from pathlib import Path
from typing import Any

import numpy as np

from kalos._build import __version__
from kalos.core.options import REFERENCE_METHOD, REFERENCE_SEED, Options, named_options
from kalos.core.output import staged, write_json
from kalos.errors import KalosError
from kalos.studies.picture import draw_study
from kalos.studies.subject import Estimate, Subject

NEAR = 0.25  # m
COLUMNS = ("method", "trajectories", "delta_m", "epsilon_m", "seed", "rms_near", "rms_elsewhere", "bias", "bias_near",
           "seconds", "cpu_seconds", "untrusted_share")


def study(scene: Any, out: Any, rows: Any, reference_trajectories: int, say: Any = lambda text: None) -> Any:
    """Solves the settings of `rows` (kalos.sweep) on a scene file into the folder `out`; returns what is in study.json."""
    subject = Subject(scene)
    distinct = list(dict.fromkeys(panel.options for row in rows for panel in row.panels))
    with staged(out) as folder, named_options():
        # The settings first: one that is not possible shows at once, not after the reference.
        estimates = {options: subject.solve(options, f"{i} of {len(distinct)}") for i, options in enumerate(distinct, 1)}
        reference, file = find_reference(subject, reference_trajectories, Path(out), folder)
        clear = subject.clearances()
        cells = [describe(options, estimates[options], reference, clear) for options in distinct]
        result = {"kalos": __version__, "scene": str(scene), "subject": subject.name, "quantity": subject.quantity,
                  "unit": subject.unit, "near_m": NEAR, "values": int(np.isfinite(clear).sum()),
                  "values_near": int((clear < NEAR).sum()),
                  "reference": {"method": REFERENCE_METHOD, "trajectories": reference.trajectories, "seed": REFERENCE_SEED,
                                "rms_near": relative_noise(reference, clear < NEAR),
                                "rms_elsewhere": relative_noise(reference, clear >= NEAR),
                                "seconds": reference.seconds, "file": file},
                  "cells": cells}
        write_json(folder / "study.json", result)
        write_csv(folder / "study.csv", cells)
        draw_study(folder / "study.png", subject, rows, estimates, dict(zip(distinct, cells)), result["reference"], NEAR)
    say(text(result))
    say(f"pictures\n  {Path(out) / 'study.png'}")
    return result


def find_reference(subject, count, out, folder):
    """The converged estimate and the name of its file: from `out` when an earlier study left it there."""
    name = f"reference-{subject.digest(REFERENCE_METHOD, count, __version__)}.npz"
    try:
        with np.load(out / name) as file:
            mean_error = float(file["mean_error"]) if "mean_error" in file.files else None
            return Estimate(file["values"], file["standard_error"], None, *file["effort"].tolist(), mean_error=mean_error), name
    except FileNotFoundError:
        pass
    except (OSError, ValueError, KeyError) as error:
        raise KalosError(f"{out / name}: file: not a reference that can be read ({error}), expected one of an earlier study; "
                         "remove it") from None
    found = subject.solve(Options(method=REFERENCE_METHOD, trajectories=count, seed=REFERENCE_SEED), "reference")
    np.savez(folder / name, values=found.values, standard_error=found.standard_error,
             effort=[found.trajectories, found.seconds, found.cpu_seconds],
             **({} if found.mean_error is None else {"mean_error": found.mean_error}))
    return found, name


def relative_noise(estimate, where):
    """Root mean square of the relative standard errors; None where there is no such value."""
    where = where & (estimate.values > 0)
    if not where.any():
        return None
    return float(np.sqrt(np.mean((estimate.standard_error[where] / estimate.values[where]) ** 2)))


def rms_error(values, reference, where):
    where = where & (reference > 0)
    if not where.any():
        return None
    return float(np.sqrt(np.mean((values[where] / reference[where] - 1) ** 2)))


def bias(values, reference, where):
    total = reference[where].sum()
    return float((values[where].sum() - total) / total) if total > 0 else None


def describe(options, estimate, reference, clear):
    """A row of the table: lengths that are None are automatic."""
    values, truth = estimate.values, reference.values
    return dict(zip(COLUMNS, (
        options.method, estimate.trajectories, options.delta, options.epsilon, options.seed,
        rms_error(values, truth, clear < NEAR), rms_error(values, truth, clear >= NEAR),
        bias(values, truth, np.isfinite(clear)), bias(values, truth, clear < NEAR), estimate.seconds, estimate.cpu_seconds,
        None if estimate.trusted is None else float(np.mean(~estimate.trusted)))))


def write_csv(path, cells):
    with open(path, "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for cell in cells:
            writer.writerow(["" if cell[name] is None else cell[name] for name in COLUMNS])


def percent(value):
    return "-" if value is None else f"{100 * value:.3g} %"


def text(result):
    """The table for a person."""
    head = ("method", "N", "delta m", "epsilon m", "seed", f"rms < {NEAR} m", "rms elsewhere", "bias", "bias near", "s", "untrusted")
    lines = [head]
    for cell in result["cells"]:
        lengths = ["auto" if cell[name] is None else f"{cell[name]:g}" for name in ("delta_m", "epsilon_m")]
        lines.append((cell["method"], str(cell["trajectories"]), *lengths, str(cell["seed"]),
                      *(percent(cell[name]) for name in ("rms_near", "rms_elsewhere", "bias", "bias_near")),
                      f"{cell['seconds']:.2f}", percent(cell["untrusted_share"])))
    widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
    table = "\n".join("  " + "  ".join([line[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(line[1:], widths[1:]))])
                      for line in lines)
    reference = result["reference"]
    return (f"study of {result['subject']}: {result['values_near']} of {result['values']} values are nearer than {NEAR} m to "
            f"an edge\n{table}\nreference: {reference['trajectories']} trajectories of {reference['method']}, standard error "
            f"{percent(reference['rms_near'])} near edges, {percent(reference['rms_elsewhere'])} elsewhere")
