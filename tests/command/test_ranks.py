# SPDX-License-Identifier: BSD-3-Clause
"""kalos solve under mpiexec: the numbers of one process, messages and files only once, and an end when a rank fails."""
import json
import os
import shutil
import subprocess
import sys
import time

import pytest

MPIEXEC = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]

pytestmark = pytest.mark.skipif(not shutil.which("mpiexec"), reason="no mpiexec here")


def mpiexec(count, *arguments, **options):
    return subprocess.run([*MPIEXEC, "-n", str(count), *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False,
                          **options)


def solved(count, scene, out, threads=1):
    run = mpiexec(count, os.environ["KALOS"], "solve", scene, "--out", out, "--trajectories", 1600, "--threads", threads)
    assert run.returncode == 0, run.stderr
    return run


def assert_same_values(one, folder):
    """Tables and images of a folder are those of another, byte by byte."""
    assert [file.name for file in sorted(folder.iterdir())] == [file.name for file in sorted(one.iterdir())]
    for file in one.iterdir():
        if file.suffix in (".csv", ".exr"):
            assert (folder / file.name).read_bytes() == file.read_bytes(), (folder.name, file.name)


def test_ranks_and_threads_do_not_change_a_bit(scene, tmp_path):
    path = scene.save()
    runs = {count: solved(count, path, tmp_path / str(count)) for count in (1, 2, 4)}
    for threads in (2, 4):
        solved(1, path, tmp_path / "threads", threads)
        assert_same_values(tmp_path / "1", tmp_path / "threads")
    for count in (2, 4):
        assert_same_values(tmp_path / "1", tmp_path / str(count))
        assert runs[count].stdout.count("audit\n") == 1  # the words of the first rank only
        audit = json.loads((tmp_path / str(count) / "summary.json").read_text())["audit"]
        assert [line["choice"] for line in audit if line["subject"] == "ranks"] == [f"{count} processes"]


def test_bad_input_is_said_once(tmp_path):
    run = mpiexec(3, os.environ["KALOS"], "solve", tmp_path / "none.json", "--out", tmp_path / "out")
    assert run.returncode == 2
    assert run.stderr.count("kalos: error: ") == 1 and "none.json" in run.stderr


def test_other_commands_run_in_one_process(tmp_path):
    run = mpiexec(2, os.environ["KALOS"], "validate")
    assert run.returncode == 2
    assert "kalos: error: validate: runs in one process; expected no mpiexec, or kalos solve" in run.stderr


FAILING = """
import sys
from kalos import ranks
from kalos.commands import main
from kalos.solving import solve
estimate = solve.estimate
def broken(*arguments):
    if ranks.current.rank == 1:
        raise {error}
    return estimate(*arguments)
solve.estimate = broken
sys.exit(main.main({arguments}))
"""


@pytest.mark.parametrize("error, message", [
    ("MemoryError", "kalos: error: rank 1 of 3: out of memory; nothing was written"),
    ("ZeroDivisionError('by hand')", "ZeroDivisionError: by hand")])
def test_a_rank_that_fails_ends_the_run(scene, tmp_path, error, message):
    arguments = ["solve", str(scene.save()), "--out", str(tmp_path / "out"), "--trajectories", "100000000", "--threads", "1"]
    started = time.monotonic()
    run = mpiexec(3, sys.executable, "-c", FAILING.format(error=error, arguments=arguments))
    assert time.monotonic() - started < 30
    assert run.returncode == 1
    assert message in run.stderr
    assert not (tmp_path / "out" / "summary.json").exists()
