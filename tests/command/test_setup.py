# SPDX-License-Identifier: BSD-3-Clause
"""apps/setup installs what is missing and nothing else; stand-ins for dpkg-query and apt-get record what it asks for."""
import os
import shutil
import subprocess
import time

import pytest
from conftest import ROOT


@pytest.fixture
def setup(tmp_path):
    """Runs a copy of apps/setup with a list of its own, where only the packages `installed` are there."""
    (tmp_path / "apps").mkdir()
    (tmp_path / "bin").mkdir()
    shutil.copy(ROOT / "apps" / "setup", tmp_path / "apps" / "setup")
    (tmp_path / "apps" / "packages.txt").write_text("# packages\none   # why\ntwo\n\none-more # dots.and+signs\n")

    def run(*installed):
        stand_in(tmp_path / "bin" / "dpkg-query", "".join(f"echo installed {name};" for name in installed))
        stand_in(tmp_path / "bin" / "apt-get", f'echo "$DEBIAN_FRONTEND $*" >> {tmp_path}/asked')
        stand_in(tmp_path / "bin" / "id", "echo 0")
        (tmp_path / "asked").write_text("")
        path = f"{tmp_path}/bin:{os.environ['PATH']}"
        process = subprocess.run([tmp_path / "apps" / "setup"], env={"PATH": path}, capture_output=True, text=True)
        return process.returncode, process.stdout, (tmp_path / "asked").read_text()

    return run


def stand_in(path, script):
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)


def test_does_nothing_when_all_is_there(setup):
    assert setup("one", "two", "one-more") == (0, "", "")


def test_installs_what_is_missing(setup):
    status, out, asked = setup("one-more")
    assert status == 0
    assert out == "setup: installing one two\n"
    assert asked == ("noninteractive -q update\nnoninteractive -q install -y --no-install-recommends one two\n")


def test_is_quick_on_this_machine():
    started = time.monotonic()
    process = subprocess.run([ROOT / "apps" / "setup"], capture_output=True, text=True)
    assert (process.returncode, process.stdout) == (0, "")
    assert time.monotonic() - started < 1
