# SPDX-License-Identifier: BSD-3-Clause
"""The figures that stand for a run: per receiver set and camera, with the audit of what was modelled."""
import json
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos import arrays


def relative_error(values, standard_error):
    """Standard errors over their values; where it is dark 0, or infinite if something fluctuates there."""
    rounding = 1e-12 * values.max(initial=0)  # what arithmetic leaves inside a solid
    dark = np.where(standard_error > rounding, np.inf, 0.0)
    return np.divide(standard_error, values, out=dark, where=values > rounding)


def statistics(values, standard_error, weights=None, replicates=None):
    """Mean, extremes, uniformities U0 = min/mean and Ud = min/max, each with its standard error, and the largest relative
    standard error of a single value that is not dark.

    A ratio to nothing is None. The mean weighs by `weights` (areas); the smallest value is not corrected for noise. Values
    share trajectories, so that the errors of mean and ratios come from the `replicates` (n, P): the spread of the means, and
    to first order that of the ratios, at the places of the extremes. Without replicates the mean's is an upper bound, and
    those of the ratios are None.
    """
    mean = float(np.average(values, weights=weights))
    low, high = float(values.min()), float(values.max())
    worst = float(relative_error(values, standard_error).max())
    least, most = int(values.argmin()), int(values.argmax())
    if replicates is None:
        mean_error, ratio_errors = float(np.average(standard_error, weights=weights)), (None, None)
    else:
        means = np.average(replicates, axis=0, weights=weights)
        mean_error = error_of(means)
        ratio_errors = [ratio_error(replicates[least], whole, value) if value else None
                        for whole, value in ((means, mean), (replicates[most], high))]
    return {"mean": mean, "mean_standard_error": mean_error, "min": low, "min_standard_error": float(standard_error[least]),
            "max": high, "max_standard_error": float(standard_error[most]),
            "U0": low / mean if mean else None, "U0_standard_error": ratio_errors[0],
            "Ud": low / high if high else None, "Ud_standard_error": ratio_errors[1],
            "largest_relative_standard_error": worst if math.isfinite(worst) else None}


def error_of(replicates):
    """Standard error of the mean of independent estimates."""
    return float(replicates.std(ddof=1) / math.sqrt(len(replicates)))


def ratio_error(part, whole, value):
    """Standard error, to first order, of mean(part)/value, where `value` is mean(whole)."""
    return error_of((part - part.mean() / value * whole) / value)


MISSED, WITHIN_ERROR, BELOW_FLOOR = range(3)  # as kalos::GoalStatus
NAMED = 100  # receivers that missed the goal and are named


def goal(status):
    """How many receivers reached the goal of the error, and which, in the table's order from 0, did not."""
    missed = np.flatnonzero(status == MISSED)
    return {"within_error": int((status == WITHIN_ERROR).sum()), "below_floor": int((status == BELOW_FLOOR).sum()),
            "missed": len(missed), "missed_receivers": missed[:NAMED].tolist()}


def field_value(output, name):
    """The number in a field data array of a data object."""
    array = output.GetFieldData().GetArray(name)
    return array.GetTuple1(0) if array else None


def provenance(output):
    """Version and seed of what made a data object; None where it does not tell."""
    version, seed = output.GetFieldData().GetAbstractArray(arrays.VERSION), field_value(output, arrays.SEED)
    return version and version.GetValue(0), None if seed is None else int(seed)


def trajectories(output):
    value = field_value(output, arrays.TRAJECTORIES)
    return None if value is None else int(value)


def audit(output, name=arrays.AUDIT):
    """What the solve chose to model and why, or what the reader of a scene did: a list of {subject, choice, reason}."""
    table = output.GetFieldData().GetAbstractArray(name)
    if table is None:
        return []
    cells = [table.GetValue(i) for i in range(table.GetNumberOfValues())]
    return [dict(zip(("subject", "choice", "reason"), cells[i:i + 3])) for i in range(0, len(cells), 3)]


def image_statistics(image):
    values = vtk_to_numpy(image.GetPointData().GetArray(arrays.LUMINANCE)).astype(float)
    error = vtk_to_numpy(image.GetPointData().GetArray(arrays.LUMINANCE_STANDARD_ERROR)).astype(float)
    return {key: value for key, value in statistics(values, error).items() if not key.startswith(("U0", "Ud"))}


def write_json(path, summary):
    path.write_text(json.dumps(summary, indent=2, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")


def joined_audit(audits):
    """The audits of several solves (label: lines) as one: what they agree on once, the rest with the label of each."""
    every = {entry["subject"]: None for lines in audits.values() for entry in lines}
    joined = []
    for subject in every:
        found = {label: [entry for entry in lines if entry["subject"] == subject] for label, lines in audits.items()}
        agreed = all(lines == next(iter(found.values())) for lines in found.values())
        for label, lines in list(found.items())[:1] if agreed else found.items():
            joined += lines if agreed else [{**entry, "subject": f"{subject}, {label}"} for entry in lines]
    return joined


def audit_text(entries):
    """The audit for a person: subjects in a column, each with its choice and the reason."""
    width = max((len(entry["subject"]) for entry in entries), default=0)
    return "\n".join(f"  {entry['subject']:<{width}}  {entry['choice']}: {entry['reason']}" for entry in entries)


def result_text(summary):
    """The result table for a person."""
    lines = []
    for title, unit, sets in (("receivers", "lx", summary["receivers"]), ("camera", "cd/m²", summary["cameras"])):
        if not sets:
            continue
        uniform = unit == "lx"
        head = [title, f"mean {unit}", "min", "max", *(["U0", "Ud"] if uniform else []), "largest error",
                *(["untrusted"] if uniform else []), "trajectories"]
        rows = [head]
        for name, figures in sets.items():
            keys = ["mean", "min", "max", *(["U0", "Ud"] if uniform else [])]
            worst = figures["largest_relative_standard_error"]
            rows.append([name, *(with_error(figures, key) for key in keys),
                         "-" if worst is None else f"{100 * worst:.3g} %",
                         *([str(figures["untrusted"])] if uniform else []), str(figures["trajectories"])])
        lines += aligned(rows)
    if summary.get("observers"):
        lines += aligned([["observer", "UGR", "background cd/m²", "sources"],
                          *([name, with_error(figures, "UGR"), with_error(figures, "background_luminance"),
                             str(figures["sources"])] for name, figures in summary["observers"].items())])
    if any(figures["untrusted"] for figures in summary["receivers"].values()):
        lines.append("  untrusted: receivers whose standard error can not be believed, as single scores carry the estimate")
    for name, figures in summary["receivers"].items():
        if figures.get("goal", {}).get("missed"):
            lines.append(f"  {figures['goal']['missed']} receivers of {name} missed the error asked for; the audit says why")
    return "\n".join(lines)


def aligned(rows):
    """Rows of cells as lines: the first column to the left, the others to the right."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return ["  " + row[0].ljust(widths[0]) + "".join("  " + c.rjust(w) for c, w in zip(row[1:], widths[1:])) for row in rows]


def with_error(figures, key):
    """A figure with its standard error, to two digits, where there is one."""
    error = figures.get(f"{key}_standard_error")
    return number(figures[key]) if figures[key] is None or error is None else f"{number(figures[key])} ± {error:.2g}"


def number(value):
    """Four significant digits, never in powers of ten between 0.001 and a million."""
    if value is None:
        return "-"
    if value and not 1e-3 <= abs(value) < 1e6:
        return f"{value:.3e}"
    digits = max(0, 3 - math.floor(math.log10(abs(value)))) if value else 0
    return f"{value:.{digits}f}"
