# SPDX-License-Identifier: BSD-3-Clause
"""The Python example of the README runs as it stands, and what it shows exists."""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_example_runs():
    example, = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    assert len([line for line in example.splitlines() if line.strip()]) <= 12
    process = subprocess.run([sys.executable, "-c", example], cwd=ROOT, capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    assert process.stderr == ""
    assert re.fullmatch(r"\d+ lx ± \d+\.\d\n", process.stdout), process.stdout


def test_commands_and_files_exist():
    for path in re.findall(r"\]\(([^)#]+)\)", README):
        if "://" not in path:
            assert (ROOT / path).exists(), path
    for command in ("apps/demo", "tests/run", "build/bin/kalos solve"):
        assert command in README
