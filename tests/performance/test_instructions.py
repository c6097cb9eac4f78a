# SPDX-License-Identifier: BSD-3-Clause
"""Instructions of a small solve, within TOLERANCE of the figure in instructions.json beside this file.

Valgrind counts them inside kalos::solve() alone (building the scene is left to a threaded library), so that the count is
the same at every run, whatever the load. It emulates AVX2 at most, on any processor that has it: the code that is chosen
at run time is the same everywhere. Another compiler may give another figure; these are of Debian 12's g++ 12.

After a change that is meant to change them:

    PYTHONPATH=build/python python3 tests/performance/test_instructions.py --update build/bin/SmallSolve
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from kalos.core.options import METHODS

FIGURES = Path(__file__).with_name("instructions.json")
TOLERANCE = 0.03
COUNTED = ("local", "compensated", "gathered")
NO_METHOD = 3  # exit status of SmallSolve


def program():
    return Path(os.environ["KALOS"]).with_name("SmallSolve")


def missing():
    """Why nothing can be counted here; None where it can."""
    if not shutil.which("valgrind"):
        return "valgrind is not installed"
    if " avx2" not in Path("/proc/cpuinfo").read_text(encoding="ascii"):
        return "the processor has no AVX2, for which the figures are"
    return None


def instructions(binary, method, folder):
    """What a solve takes; None where this build does not have the method."""
    number = str(METHODS[method])
    if subprocess.run([binary, number], check=False).returncode == NO_METHOD:
        return None
    done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/callgrind.out",
                           "--toggle-collect=kalos::solve(*", binary, number], capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


@pytest.mark.skipif(missing() is not None, reason=str(missing()))
@pytest.mark.parametrize("method, figure", json.loads(FIGURES.read_text()).items())
def test_instructions(method, figure, tmp_path):
    counted = instructions(program(), method, tmp_path)
    change = counted / figure - 1
    print(f"{method}: {counted} instructions, {100 * change:+.2f} % of {figure}")
    assert abs(change) <= TOLERANCE, "if it is meant to be so, update the figure: see the top of this file"


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] != "--update" or missing():
        sys.exit(missing() or "usage: test_instructions.py --update build/bin/SmallSolve")
    found = {name: instructions(sys.argv[2], name, tempfile.gettempdir()) for name in COUNTED}
    FIGURES.write_text(json.dumps({name: figure for name, figure in found.items() if figure}, indent=2) + "\n")
    print(FIGURES.read_text(), end="")
