# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C and SIGTERM stop a long solve: exit status 1, one line, nothing left behind."""
import os
import signal
import time

import pytest
from conftest import launch


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_stops_cleanly(scene, tmp_path, number):
    process = launch("solve", scene.save(), "--out", tmp_path / "a" / "out", "--trajectories", 10**12)
    deadline = time.monotonic() + 30
    while not (tmp_path / "a" / "out").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    time.sleep(0.5)  # well within the solve
    assert process.poll() is None
    process.send_signal(number)
    _, error = process.communicate(timeout=30)
    assert process.returncode == 1
    assert error.splitlines()[-1] == "kalos: error: stopped before the end; nothing was written"
    assert "Traceback" not in error
    assert sorted(os.listdir(tmp_path)) == ["probe.csv", "scene.json"]
