# SPDX-License-Identifier: BSD-3-Clause
"""A pvserver of several ranks solves for a client, which gets the numbers of one process."""
import os
import shutil
import socket
import subprocess
from pathlib import Path

import numpy as np
import pytest

SCRIPT = Path(__file__).with_name("pvbatch_room.py")
MPIEXEC = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]

pytestmark = pytest.mark.skipif(not shutil.which("mpiexec"), reason="no mpiexec here")


def arguments(path):
    return [str(part) for part in (SCRIPT, os.environ["KALOS_PLUGIN"], SCRIPT.parents[2], path)]


def free_port():
    with socket.socket() as one:
        one.bind(("", 0))
        return str(one.getsockname()[1])


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_client_of_two_ranks(tmp_path):
    run("pvpython", *arguments(tmp_path / "alone.npz"))
    port = free_port()
    with subprocess.Popen([*MPIEXEC, "-n", "2", "pvserver", f"--server-port={port}"], stdout=subprocess.PIPE, text=True) as server:
        try:
            for line in server.stdout:  # it listens when it has said so
                if "Accepting connection" in line:
                    break
            run("pvpython", *arguments(tmp_path / "served.npz"), port)
            assert server.wait(60) == 0  # the client's end is the server's
        finally:
            server.kill()
    alone, served = np.load(tmp_path / "alone.npz"), np.load(tmp_path / "served.npz")
    assert served["ranks"].tolist() == ["2 processes"] and not len(alone["ranks"])
    np.testing.assert_array_equal(served["lux"], alone["lux"])
    np.testing.assert_array_equal(served["luminance"], alone["luminance"])
