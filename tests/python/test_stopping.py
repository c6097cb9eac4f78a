# SPDX-License-Identifier: BSD-3-Clause
"""Progress of a solve from Python, and how it ends before its time: callbacks that raise, Ctrl-C with what was reached."""
import io
import os
import signal
import time

import numpy as np
import pytest

import kalos
from kalos.core.progress import ProgressBar, clock

ROOM = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
LAMP = kalos.luminaire((2, 2, 2.9), 3000)
POINTS = np.random.default_rng(1).uniform(0.5, 3.5, (500, 3)) * [1, 1, 0.5]


def solve(**options):
    return kalos.illuminance(ROOM, LAMP, POINTS, (0, 0, 1), **options)


def test_callback_sees_fractions_and_the_end():
    seen = []
    solve(trajectories=100000, progress=seen.append)
    assert seen[-1] == 1 and len(seen) > 3 and all(0 < fraction <= 1 for fraction in seen)


def test_what_a_callback_raises_ends_the_solve():
    def refuse(fraction):
        raise LookupError("enough")

    started = time.monotonic()
    with pytest.raises(LookupError, match="enough"):
        solve(trajectories=10**12, progress=refuse)
    assert time.monotonic() - started < 2


def test_bar(capfd):
    solve(trajectories=20000, progress=True)
    error = capfd.readouterr().err
    assert error.startswith("illuminance ") and error.endswith("100% \n")


def test_bar_of_a_terminal_tells_the_time_to_go(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    now = [100.0]
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    bar = ProgressBar("solve", Terminal())
    now[0] += 30
    bar.show(0.25)
    assert bar.stream.getvalue().endswith(" 25 %  0:30 < 1:30 ")
    assert clock(3723) == "1:02:03"


@pytest.mark.parametrize("method", ["compensated", "disc"])
def test_interrupt_leaves_what_was_reached(method):
    """The error is that of the trajectories that are told: a solve of as many agrees. Seeds 1 and 2."""
    sent = []

    def interrupt(fraction):  # with a goal, progress starts with the second round
        if not sent:
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt) as stop:
        solve(error=1e-5, method=method, progress=interrupt)
    assert time.monotonic() - sent[0] < 1
    assert isinstance(stop.value, kalos.Interrupted)
    partial = stop.value.partial
    assert partial.trajectories > 0 and str(partial.trajectories) in str(stop.value)
    assert partial.audit[-1]["subject"] == "stopped" and str(partial.trajectories) in partial.audit[-1]["choice"]
    again = solve(trajectories=partial.trajectories, method=method, seed=2)
    deviations = abs(partial.illuminance - again.illuminance) / np.hypot(partial.standard_error, again.standard_error)
    assert deviations.max() < 14  # of 500 with 7 degrees of freedom: 1e-3 of false alarms
    assert partial.standard_error.max() < 0.2 * partial.illuminance.max()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_interrupt_before_the_first_round_leaves_nothing():
    with pytest.raises(kalos.Interrupted) as stop:
        kalos.illuminance(ROOM, LAMP, np.tile(POINTS, (200, 1)), (0, 0, 1), trajectories=10**12,
                          progress=lambda fraction: os.kill(os.getpid(), signal.SIGINT))
    assert stop.value.partial is None and "no round was complete" in str(stop.value)


def test_interrupted_image_is_usable():
    with pytest.raises(kalos.Interrupted) as stop:
        kalos.luminance(ROOM, LAMP, (2, 0.1, 1), (2, 4, 1), resolution=(16, 12), error=1e-5,
                        progress=lambda fraction: os.kill(os.getpid(), signal.SIGINT))
    assert (stop.value.partial.luminance > 0).all()
