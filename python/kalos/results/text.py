# SPDX-License-Identifier: BSD-3-Clause
"""Results as text for a person: the table of a solve, the audit, numbers with their standard errors."""
import math


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
    """The audit as the terminal shows it: subjects in a column, each with its choice and the reason."""
    width = max((len(entry["subject"]) for entry in entries), default=0)
    return "\n".join(f"  {entry['subject']:<{width}}  {entry['choice']}: {entry['reason']}" for entry in entries)


def result_text(summary):
    """The result table that the terminal shows."""
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
    for task in summary.get("tasks", ()):
        limits = f"mean {task['required_mean']:g} lx" + (f", U0 {task['required_U0']:g}" if "required_U0" in task else "")
        lines.append(f"  {task['receivers']}: {limits} required: {task['result']}")
    lines.append("  ± is one standard error: the true value is within two of them in about 95 of 100 cases")
    if any(figures["untrusted"] for figures in summary["receivers"].values()):
        lines.append("  untrusted: receivers whose standard error cannot be believed, as a few single scores dominate the estimate")
    for name, figures in summary["receivers"].items():
        if figures["left_out"]:
            lines.append(f"  {figures['left_out']} of {figures['points']} points of {name} are left out: inside a solid, below a surface or outside")
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
