# SPDX-License-Identifier: BSD-3-Clause
"""What the package says twice agrees."""
import importlib.util
import pydoc
import re
import subprocess
import sys
from pathlib import Path

import pytest

import kalos
from kalos.core import arrays
from kalos.core.options import METHODS

ROOT = Path(__file__).resolve().parents[2]


def test_array_names_are_those_of_the_header():
    header = (ROOT / "modules" / "CommonPhotometry" / "vtkKalosArrayNames.h").read_text()
    names = set(re.findall(r'constexpr const char\* (\w+) =\s+"\1";', header))
    ours = {value for key, value in vars(arrays).items() if key.isupper()}
    assert ours and ours <= names


def test_version_is_that_of_the_build():
    version, = re.findall(r"project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())
    assert kalos.__version__ == version


def test_methods_are_numbered_as_the_filter_numbers_them():
    for name, number in METHODS.items():
        assert getattr(kalos.vtkKalosIlluminance, name.upper().replace("-", "_")) == number


def test_every_class_is_there():
    for stem in ("SceneReader", "LuminaireSource", "CalculationPlane", "Illuminance", "LuminanceImage", "FalseColor",
                 "EXRReader", "EXRWriter", "SurfaceRepair", "SurfaceRemesh", "SingularEdges"):
        assert getattr(kalos, f"vtkKalos{stem}")().IsA(f"vtkKalos{stem}")


def test_help_shows_the_functions():
    text = pydoc.plain(pydoc.render_doc(kalos))
    assert all(f"    {name}(" in text for name in ("illuminance", "luminance", "surface", "luminaire", "solve", "study", "chart", "validate"))
    contents = re.search(r"PACKAGE CONTENTS\n(.*?)\n\n", text, re.DOTALL)[1].split("\n")
    assert len(contents) <= 25  # packages, not every module of them


def test_everything_that_is_promised_is_there_and_documented():
    for name in kalos.__all__:
        assert name == "__version__" or getattr(kalos, name).__doc__


@pytest.mark.skipif(not importlib.util.find_spec("mypy"), reason="no mypy")
def test_types_of_the_examples():
    """mypy --strict knows everything that an example takes from kalos itself."""
    examples = sorted((ROOT / "examples").glob("*.py"))
    assert len(examples) > 8
    found = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--follow-imports=silent",
                            "--cache-dir=/dev/null", *examples], capture_output=True, text=True, check=False,
                           env={"MYPYPATH": str(Path(kalos.__file__).absolute().parents[1])})
    assert found.returncode == 0, found.stdout
