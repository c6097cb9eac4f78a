# SPDX-License-Identifier: BSD-3-Clause
"""Every test is in a CMake list: others would never run."""
import re

from sources import ROOT, name, sources

TEST = re.compile(r"^(Test|Benchmark)\w*\.cxx$|^test_\w+\.py$")


def unregistered(path):
    listing = path.parent / "CMakeLists.txt"
    name_or_subject = rf"\b({path.stem}|{path.stem.removeprefix('test_')})\b"
    return not listing.is_file() or not re.search(name_or_subject, listing.read_text())


def test_every_test_is_registered():
    files = [path for path in sources(".py", ".cxx", below=("tests",)) if TEST.match(path.name)]
    assert files
    assert not [name(path) for path in files if unregistered(path)]


def test_every_folder_of_tests_is_entered():
    top = (ROOT / "tests" / "CMakeLists.txt").read_text()
    folders = {path.parent.name for path in sources(".txt", below=("tests",)) if path.parent.parent.name == "tests"}
    assert not [folder for folder in folders if not re.search(rf"\b{folder}\b", top)]
