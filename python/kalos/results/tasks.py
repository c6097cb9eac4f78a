# SPDX-License-Identifier: BSD-3-Clause
"""Requirements on receiver sets, as EN 12464-1 makes them on task areas: mean illuminance, uniformity, glare."""
from dataclasses import dataclass
from typing import Optional

from kalos.errors import KalosError

PASS, FAIL, UNDECIDED = "pass", "fail", "undecided"
ERRORS = 2  # standard errors that a value is away from the limit at least, if the verdict is to hold


@dataclass(frozen=True)
class Task:
    """What is required of a receiver set, or of an observer."""

    name: str
    mean: Optional[float] = None  # lx, at least
    uniformity: Optional[float] = None  # U0, at least
    glare: Optional[float] = None  # UGR, at most; of an observer, who has none where no source is seen

    def judge(self, figures):
        """The entry of summary.json: what is required and found, and the verdict on each."""
        found = {"receivers": self.name}
        for key, least in (("mean", self.mean), ("U0", self.uniformity)):
            if least is not None:
                found.update({f"required_{key}": least, key: verdict(figures, key, least)})
        if self.glare is not None:
            found.update(required_UGR=self.glare, UGR=PASS if figures["UGR"] is None else verdict(figures, "UGR", self.glare, most=True))
        verdicts = [found[key] for key in ("mean", "U0", "UGR") if key in found]
        found["result"] = FAIL if FAIL in verdicts else UNDECIDED if UNDECIDED in verdicts else PASS
        return found


def verdict(figures, key, limit, most=False):
    """Whether a figure is at least the limit, or at most; undecided where its standard error does not tell."""
    value, error = figures[key], figures[f"{key}_standard_error"] or 0.0
    if value is None:
        return FAIL
    if abs(value - limit) < ERRORS * error:
        return UNDECIDED
    return PASS if (value <= limit if most else value >= limit) else FAIL


def of_scene(described):
    """The tasks that a scene file asks for, from its receivers by name."""
    return [Task(name, one["task"].get("mean"), one["task"].get("U0"), one["task"].get("UGR"))
            for name, one in described.items() if "task" in one]


def joined(own, asked):
    """The tasks of the scene, and those of the command, which have precedence."""
    return [task for task in own if task.name not in {one.name for one in asked}] + list(asked)


def judged(tasks, sets, observers):
    """The verdicts on tasks from the statistics of the receiver sets and of the observers by name."""
    return [task.judge({**sets[task.name], **observers.get(task.name, {})}) for task in tasks]


def limits(task):
    """The required values of an entry of summary.json, in words."""
    words = (("required_mean", "mean {:g} lx"), ("required_U0", "U0 {:g}"), ("required_UGR", "UGR at most {:g}"))
    return ", ".join(text.format(task[key]) for key, text in words if key in task)


def check_names(tasks, names):
    """A task of a set that is not there is a mistake."""
    for task in tasks:
        if task.name not in names:
            raise KalosError(f"--require: {task.name!r} is no receiver set, expected one of {', '.join(names) or 'a scene with receivers'}")
