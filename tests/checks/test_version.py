# SPDX-License-Identifier: BSD-3-Clause
"""The version is that of CMakeLists.txt everywhere."""
import re

import pytest
from sources import ROOT

VERSION, = re.findall(r"^project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)


@pytest.mark.parametrize("file, pattern", [("CHANGELOG.md", r"^## (\d\S*?),? "), ("CITATION.cff", r"^version: (\S+)$")])
def test_files_tell_the_version(file, pattern):
    found = re.findall(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
    assert found and found[0] == VERSION


def test_it_stands_nowhere_else():
    """Sources of programs, the package and its tests take it from the build."""
    quoted = re.compile(rf"(?<![\d.]){re.escape(VERSION)}(?![\d.])")
    others = [path for folder in ("apps", "cmake", "modules", "python", "tests") for path in (ROOT / folder).rglob("*")
              if path.suffix in (".py", ".cxx", ".h", ".in", ".cmake", ".txt", ".sh", ".xml") and quoted.search(path.read_text(encoding="utf-8"))]
    assert [str(path.relative_to(ROOT)) for path in others] == []
