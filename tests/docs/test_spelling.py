# SPDX-License-Identifier: BSD-3-Clause
"""codespell finds no common misspelling, and words of the field are spelled in one way."""
import re
import shutil
import subprocess

import pytest
from pages import PAGES, ROOT, name

WORDS = ROOT / "docs" / "words.txt"
FOLDERS = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs", "python", "modules", "apps", "examples", "tests")
ONE_WAY = {"colour": r"\bcolors?\b", "metre": r"\b(?:centi|milli|kilo)?meters?\b(?! head| reads)", "grey": r"\bgray\b", "normalised": r"\bnormalized\b"}


@pytest.mark.skipif(not shutil.which("codespell"), reason="no codespell")
def test_spelling():
    found = subprocess.run(["codespell", "--ignore-words", WORDS, "--skip", "*.ipynb,*.png,*.exr,*.hdr,*.csv,*.vtp,*/corpus/*,*.dict,*mutations.txt", *FOLDERS],
                           cwd=ROOT, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stdout + found.stderr


def test_one_spelling_in_the_manual():
    """British, as in the sources; code keeps the words of its libraries."""
    for page in PAGES:
        prose = re.sub(r"```.*?```|`[^`]*`|\$[^$]*\$|<!--.*?-->", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        for word, other in ONE_WAY.items():
            assert not re.findall(other, prose), (name(page), word)
