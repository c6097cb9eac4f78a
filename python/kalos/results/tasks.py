# SPDX-License-Identifier: BSD-3-Clause
"""Requirements on receiver sets, as EN 12464-1 makes them on task areas: a mean illuminance and a uniformity."""
from dataclasses import dataclass
from typing import Optional

from kalos.errors import KalosError

PASS, FAIL, UNDECIDED = "pass", "fail", "undecided"
ERRORS = 2  # standard errors that a value is away from the limit at least, if the verdict is to hold


@dataclass(frozen=True)
class Task:
    """What is required of a receiver set."""

    name: str
    mean: float  # lx, at least
    uniformity: Optional[float] = None  # U0, at least

    def judge(self, figures):
        """The entry of summary.json: what is required and found, and the verdict on each."""
        found = {"receivers": self.name, "required_mean": self.mean, "mean": verdict(figures, "mean", self.mean)}
        if self.uniformity is not None:
            found.update(required_U0=self.uniformity, U0=verdict(figures, "U0", self.uniformity))
        verdicts = [found["mean"], found.get("U0", PASS)]
        found["result"] = FAIL if FAIL in verdicts else UNDECIDED if UNDECIDED in verdicts else PASS
        return found


def verdict(figures, key, least):
    """Whether a figure is at least so large; undecided where its standard error does not tell."""
    value, error = figures[key], figures[f"{key}_standard_error"] or 0.0
    if value is None:
        return FAIL
    if abs(value - least) < ERRORS * error:
        return UNDECIDED
    return PASS if value >= least else FAIL


def judged(tasks, sets):
    """The verdicts on tasks from the statistics of the receiver sets by name."""
    return [task.judge(sets[task.name]) for task in tasks]


def check_names(tasks, names):
    """A task of a set that is not there is a mistake."""
    for task in tasks:
        if task.name not in names:
            raise KalosError(f"--require: {task.name!r} is no receiver set, expected one of {', '.join(names) or 'a scene with receivers'}")
