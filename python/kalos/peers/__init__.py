# SPDX-License-Identifier: BSD-3-Clause
"""Other people's programs on the same scene: the peers of `kalos chart`. None is needed to build, use or test Kalos.

A peer is a class with NAME (as in --peers), LABEL, EFFORT (what its effort counts) and START (the least effort), made from
the arrays of kalos.peers.description and a number of threads; its solve(effort, seed) returns a Run. Where it is not
installed or cannot model the scene the constructor raises Absent, with the reason as a sentence.

They are looked for in the Python interpreter that the environment variable KALOS_PEERS_PYTHON names, else in the one that
runs: `python3 -m venv peers && peers/bin/pip install mitsuba pyradiance` makes such a one.
"""
import os
import sys
from dataclasses import dataclass

import numpy as np

NAMES = ("mitsuba", "radiance", "radiance-cached")


class Absent(Exception):
    """Raised when a peer cannot take part; the message says why."""


@dataclass
class Run:
    """One estimate of all receivers."""

    values: np.ndarray  # lx
    effort: int  # as spent: a program may round it
    cpu_seconds: float  # without set-up
    rays: int = None  # None if the program does not report it


def interpreter():
    return os.environ.get("KALOS_PEERS_PYTHON", sys.executable)


def clean_environment(**more):
    """This process's environment without the paths that lead to our own modules: the interpreter may be another one."""
    return {**{key: value for key, value in os.environ.items() if key != "PYTHONPATH"}, **more}
