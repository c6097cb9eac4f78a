# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a prepared room: the example finds every edge and contact of its construction and draws them."""
import math
import re
import subprocess
import sys
from pathlib import Path

from matplotlib.image import imread

ROOT = Path(__file__).resolve().parents[2]


def test_picture(tmp_path):
    process = subprocess.run([sys.executable, ROOT / "examples" / "mesh_preparation.py", tmp_path], capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    edges, contacts = re.findall(r"^(\d+) .*, ([\d.]+) m$", process.stdout, re.MULTILINE)
    assert edges == ("12", "42.400")
    # Three boxes with four sides each, and the board's lower and upper edge.
    outlines = 2 * (1.4 + 0.7) + 2 * (0.9 + 0.8) + 2 * (0.5 + 0.45) + 2 * 1.3
    assert contacts[0] == "14" and math.isclose(float(contacts[1]), outlines, abs_tol=2e-3)
    picture = imread(tmp_path / "mesh-preparation.png")[..., :3]
    blue = (picture[..., 2] - picture[..., 0] > 0.2).mean()
    orange = (picture[..., 0] - picture[..., 2] > 0.2).mean()
    assert blue > 0.01 and orange > 0.004
