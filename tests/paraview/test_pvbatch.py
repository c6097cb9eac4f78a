# SPDX-License-Identifier: BSD-3-Clause
"""pvbatch with several ranks, symmetric or not, fetches the numbers of one process, and ends when a rank fails."""
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

SCRIPT = Path(__file__).with_name("pvbatch_room.py")
MPIEXEC = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]

pytestmark = pytest.mark.skipif(not shutil.which("mpiexec"), reason="no mpiexec here")


def arguments(path):
    return [SCRIPT, os.environ["KALOS_PLUGIN"], SCRIPT.parents[2], path]


def run(*command):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    path = tmp_path_factory.mktemp("alone") / "room.npz"
    run("pvbatch", *arguments(path))
    found = np.load(path)
    assert len(found["lux"]) == 30 and len(found["luminance"]) == 72 and not len(found["ranks"])
    return found


@pytest.mark.parametrize("options", [["--symmetric"], []])
def test_ranks_of_pvbatch(alone, tmp_path, options):
    run(*MPIEXEC, "-n", 3, "pvbatch", *options, *arguments(tmp_path / "room.npz"))
    found = np.load(tmp_path / "room.npz")
    assert found["ranks"].tolist() == ["3 processes"]
    np.testing.assert_array_equal(found["lux"], alone["lux"])
    np.testing.assert_array_equal(found["luminance"], alone["luminance"])


@pytest.mark.parametrize("what, message", [("script", "ZeroDivisionError: by hand"), ("reader", "/nowhere/cornell-empty.json: file: no such")])
def test_a_rank_that_fails_ends_the_run(what, message):
    """Both ways the other ranks would wait in the solve for the one that does not come."""
    script = SCRIPT.with_name("pvbatch_failing.py")
    done = subprocess.run([*MPIEXEC, "-x", "KALOS_RANK_PATIENCE=3", "-n", "3", "pvbatch", "--symmetric", script,
                           os.environ["KALOS_PLUGIN"], SCRIPT.parents[2], what],
                          capture_output=True, text=True, timeout=100, check=False)
    said = done.stdout + done.stderr
    assert message in said
    assert "rank 1 of 3: did not come to the solve within 3 s" in said
    assert done.returncode == (1 if what == "script" else 0)  # an update that fails is no exception in ParaView
