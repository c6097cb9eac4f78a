# SPDX-License-Identifier: BSD-3-Clause
"""What the package says twice agrees."""
import re
from pathlib import Path

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
