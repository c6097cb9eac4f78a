# SPDX-License-Identifier: BSD-3-Clause
"""Includes point downwards only, so that command, plugin and scripts cannot disagree about numbers.

The kernels and the meshing know no VTK and no Qt; the VTK classes show neither third-party types nor kernels in their
headers; applications and Python use VTK classes, never kernels.
"""
import re

import pytest
from sources import ROOT, name, sources

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
VTK_OR_QT = re.compile(r"(^|/)(vtk|pqCore|Q[A-Z])|^Qt")
THIRD_PARTY = re.compile(r"^(embree\d*|CGAL|OpenMesh|OpenEXR|Imath|tbb|oneapi|nlohmann)/|^(Imf|Imath|Iex)[A-Z]\w*\.h$|^boost/")


def includes(text):
    return INCLUDE.findall(text)


def of_the_kernels(header):
    return any((ROOT / "modules" / library / header).is_file() for library in ("Kernels", "Meshing"))


def breaches(files, forbidden):
    return [f"{name(path)} includes {header}" for path in files for header in includes(path.read_text(encoding="utf-8"))
            if forbidden(header)]


def test_kernels_and_meshing_know_no_vtk():
    files = sources(".h", ".cxx", below=("modules/Kernels", "modules/Meshing"))
    assert files
    assert not breaches(files, VTK_OR_QT.search)


def test_vtk_headers_show_only_vtk():
    files = [path for path in sources(".h", below=("modules",)) if path.name.startswith("vtkKalos")]
    assert files
    assert not breaches(files, lambda header: THIRD_PARTY.search(header) or of_the_kernels(header))


def test_applications_and_python_use_no_kernels():
    assert not breaches(sources(".h", ".cxx", below=("apps", "python")), of_the_kernels)


@pytest.mark.parametrize("line, rule", [
    ('#include "vtkPolyData.h"', VTK_OR_QT.search), ("#include <QWidget>", VTK_OR_QT.search),
    ("# include <embree3/rtcore.h>", THIRD_PARTY.search), ("#include <tbb/parallel_for.h>", THIRD_PARTY.search),
    ("#include <ImfHeader.h>", THIRD_PARTY.search), ('#include "estimator/Settings.h"', of_the_kernels)])
def test_the_rules_catch(line, rule):
    header, = includes(line)
    assert rule(header)


@pytest.mark.parametrize("header, rule", [
    ("vector", VTK_OR_QT.search), ("geometry/Vector.h", VTK_OR_QT.search), ("vtkPolyData.h", THIRD_PARTY.search),
    ("vtkPolyData.h", of_the_kernels)])
def test_the_rules_let_pass(header, rule):
    assert not rule(header)
