# SPDX-License-Identifier: BSD-3-Clause
"""The source files that the checks look at."""
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("modules", "apps", "python", "tests", "examples")


def sources(*suffixes, below=FOLDERS):
    """Files with these suffixes below some folders of the tree, sorted."""
    return sorted(path for folder in below for path in (ROOT / folder).rglob("*") if path.suffix in suffixes)


def name(path):
    return str(path.relative_to(ROOT))
