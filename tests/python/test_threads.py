# SPDX-License-Identifier: BSD-3-Clause
"""Other threads of Python go on during a solve, and may solve as well."""
import threading
import time

import numpy as np
import pytest

import kalos

ROOM = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
LAMP = kalos.luminaire((2, 2, 2.9), 3000)
X, Y = np.meshgrid(np.linspace(0.1, 3.9, 16), np.linspace(0.1, 3.9, 16))
DESK = np.stack([X, Y, np.full_like(X, 0.75)], axis=-1)


def solve(seed=1, trajectories=20000, **more):
    return kalos.illuminance(ROOM, LAMP, DESK, (0, 0, 1), trajectories=trajectories, seed=seed, threads=1, **more)


def test_a_thread_goes_on():
    """It wakes every millisecond. With the lock held it would only between rounds, a dozen times."""
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    started = time.monotonic()
    solve(trajectories=200000)
    ended = time.monotonic()
    stop.set()
    thread.join()
    during = [moment for moment in ticks if started < moment < ended]
    print(f"{len(during)} ticks in {ended - started:.2f} s")
    assert ended - started > 0.2 and len(during) > 100 * (ended - started)


def test_solves_in_several_threads_agree_with_one_after_the_other():
    expected = [solve(seed).illuminance for seed in (1, 2, 3)]
    found = {}
    threads = [threading.Thread(target=lambda seed=seed: found.update({seed: solve(seed).illuminance})) for seed in (1, 2, 3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for seed, one in zip((1, 2, 3), expected):
        np.testing.assert_array_equal(found[seed], one)


def test_progress_and_failures_in_a_thread():
    told, raised = [], []

    def work():
        solve(progress=told.append)
        try:
            solve(progress=lambda fraction: 1 / 0)
        except ZeroDivisionError as error:
            raised.append(error)
        try:
            kalos.illuminance(ROOM, LAMP, DESK, (0, 0, 1), method="sphere-exact", delta=99)
        except kalos.InputError as error:
            raised.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert told and told == sorted(told) and told[-1] == 1
    assert [type(error) for error in raised] == [ZeroDivisionError, kalos.InputError]


def test_messages_that_are_not_utf8_are_told_as_such():
    from kalos.core.unblocked import decoded
    from kalos.errors import plain

    assert plain(decoded(b"\xff")) == "input: not UTF-8 text; expected UTF-8" and plain(decoded("ä".encode())) == "ä"
    with pytest.raises(kalos.KalosError):
        kalos.illuminance(ROOM, LAMP, DESK, (0, 0, 1), checkpoint="/dev/null/none")
