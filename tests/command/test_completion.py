# SPDX-License-Identifier: BSD-3-Clause
"""Completion in a shell, by argcomplete."""
import os
import shutil
import subprocess
from pathlib import Path

import pytest

COMPLETION = Path(__file__).resolve().parents[2] / "apps" / "kalos" / "completion.bash"


@pytest.mark.skipif(not shutil.which("register-python-argcomplete"), reason="no argcomplete; apt-get install python3-argcomplete")
@pytest.mark.parametrize("line, expected", [
    ("kalos s", {"solve", "study", "schema"}), ("kalos schema ", {"scene", "summary", "-h", "--help"}),
    ("kalos solve --lumi", {"--luminance-range"}), ("kalos solve a.json --method ga", {"gathered"}),
    ("kalos chart a.json --relative-to ", {"value", "mean"})])
def test_words_that_may_follow(tmp_path, line, expected):
    script = f"""
        source {COMPLETION}
        COMP_LINE={line!r} COMP_POINT={len(line)} COMP_TYPE=9 COMP_CWORD=0
        COMP_WORDBREAKS=$' \\t\\n"><=;|&(:'
        _python_argcomplete kalos
        printf '%s\\n' "${{COMPREPLY[@]}}"
    """
    path = f"{Path(os.environ['KALOS']).resolve().parent}:{os.environ['PATH']}"
    ran = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True, cwd=tmp_path, env={**os.environ, "PATH": path})
    assert {word.strip() for word in ran.stdout.split()} == expected
