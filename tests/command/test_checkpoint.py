# SPDX-License-Identifier: BSD-3-Clause
"""Solves that are killed, stopped or run out of disk, and go on: the numbers are those of one that was left alone.

KALOS_KILLS=50 kills so often, at random moments of a printed seed.
"""
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import launch, one_line

PROGRAM = Path(__file__).with_name("checkpointed.py")
KILLS = int(os.environ.get("KALOS_KILLS", "3"))


def start(scene, folder, *limit):
    return subprocess.Popen([sys.executable, PROGRAM, scene, folder / "state.kcp", folder / "out.npy", *map(str, limit)],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finish(process):
    out, error = process.communicate(timeout=240)
    assert process.returncode == 0, error
    return out, error


@pytest.fixture
def larger(scene):
    scene["receivers"][0]["plane"]["resolution"] = [16, 16]
    return scene.save()


def test_killed_at_random_moments(larger, tmp_path):
    started = time.monotonic()
    finish(start(larger, tmp_path))
    whole, took = np.load(tmp_path / "out.npy"), time.monotonic() - started
    state = tmp_path / "state.kcp"
    state.unlink()
    moments, kills, resumed = random.Random(9), 0, 0
    print(f"seed 9, {KILLS} kills, {took:.2f} s undisturbed")
    while kills < KILLS or resumed == 0:
        (tmp_path / "out.npy").unlink(missing_ok=True)
        before = written(state)
        process = start(larger, tmp_path)
        while process.poll() is None and written(state) == before:
            time.sleep(0.005)
        try:
            process.communicate(timeout=moments.uniform(0, took / 10))
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            kills += 1
            resumed += before is not None
            continue
        assert np.array_equal(np.load(tmp_path / "out.npy"), whole)
        state.unlink()  # it reached the end: from the start again
    finish(start(larger, tmp_path))
    assert np.array_equal(np.load(tmp_path / "out.npy"), whole)
    print(f"killed {kills} times, {resumed} of them in a run that had gone on from a checkpoint")
    assert resumed > 0


def written(state):
    """When the file was, or None."""
    try:
        return state.stat().st_mtime_ns
    except FileNotFoundError:
        return None


def test_a_full_disk_costs_the_new_checkpoint_only(larger, tmp_path):
    finish(start(larger, tmp_path))
    whole = np.load(tmp_path / "out.npy").tobytes().hex()
    state = tmp_path / "state.kcp"
    complete = state.read_bytes()
    state.unlink()
    process = start(larger, tmp_path)
    while not state.exists():
        time.sleep(0.01)
    process.kill()
    process.communicate()
    before = state.read_bytes()
    assert before != complete
    out, error = finish(start(larger, tmp_path, len(before) // 2))
    assert error.count("state.kcp: checkpoint: cannot be written (File too large); the solve goes on") == 1
    assert out == whole
    assert state.read_bytes() == before
    for part in tmp_path.glob("state.kcp.part*"):  # of the killed one, at most
        assert part.name == f"state.kcp.part{process.pid}"


LONG = ("--trajectories", 2000000)


def interrupted(arguments, state, number, progress):
    """Starts the command, and stops it when the first solve has come so far."""
    process, said = launch(*arguments), ""
    while progress not in said and process.poll() is None:
        said += process.stderr.read(1)
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    assert process.returncode == 1, error
    assert error.splitlines()[-1].removesuffix(".front") == (
        f"kalos: error: stopped before the end; the same command goes on from {state}")
    return [file.read_bytes() for file in sorted(state.parent.glob("state.kcp*"))]


def test_the_command_goes_on(scene, tmp_path, command):
    path, state = scene.save(), tmp_path / "state.kcp"
    arguments = ["solve", path, "--out", tmp_path / "out", "--checkpoint", state, *LONG]
    first = interrupted(arguments, state, signal.SIGTERM, "20%")
    assert interrupted(arguments, state, signal.SIGINT, "50%") != first
    assert command(*arguments)[0] == 0
    assert sorted(file.name for file in tmp_path.iterdir()) == ["out", "probe.csv", "scene.json"]
    assert command("solve", path, "--out", tmp_path / "whole", *LONG)[0] == 0
    for file in (tmp_path / "whole").iterdir():
        if file.suffix in (".csv", ".exr"):
            assert (tmp_path / "out" / file.name).read_bytes() == file.read_bytes()


def test_others_are_refused_and_left_alone(scene, command, tmp_path):
    path, state = scene.save(), tmp_path / "state.kcp"
    state.write_text("precious")
    status, _, error = command("solve", path, "--out", tmp_path / "out", "--checkpoint", state)
    assert status == 2
    assert one_line(error) == f"{state}: checkpoint: is no checkpoint of Kalos; expected one, or no file"
    assert state.read_text() == "precious" and not (tmp_path / "out").exists()
    state.write_text("")
    assert command("solve", path, "--out", tmp_path / "out", "--checkpoint", state)[0] == 2
    assert state.exists()


@pytest.mark.parametrize("name, reason", [("none/state.kcp", "No such file or directory"), ("scene.json/x", "Not a directory")])
def test_a_place_that_can_not_be_written(scene, command, tmp_path, name, reason):
    path = scene.save()
    status, _, error = command("solve", path, "--out", tmp_path / "out", "--checkpoint", tmp_path / name)
    assert status == 2
    assert one_line(error) == (f"{tmp_path / name}: checkpoint: cannot be written ({reason}), expected a file in a folder that is "
                               "there and writable")
