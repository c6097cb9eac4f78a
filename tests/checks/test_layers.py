# SPDX-License-Identifier: BSD-3-Clause
"""Includes point downwards only, so that command, plugin and scripts cannot disagree about numbers.

The kernels and the meshing know no VTK and no Qt; the VTK classes show neither third-party types nor kernels in their
headers; applications and Python use VTK classes, never kernels. Inside a module, the folders ("rooms") have an order too.
"""
import posixpath
import re

import pytest
from sources import ROOT, name, sources

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
VTK_OR_QT = re.compile(r"(^|/)(vtk|pqCore|Q[A-Z])|^Qt")
THIRD_PARTY = re.compile(r"^(embree\d*|CGAL|OpenMesh|OpenEXR|Imath|tbb|oneapi|nlohmann)/|^(Imf|Imath|Iex)[A-Z]\w*\.h$|^boost/")

# Rooms of a module, lowest first. A file includes from its own room and from lower ones.
ROOMS = {
    "modules/Kernels": ["geometry", "photometry", "sampling", "statistics", "material", "luminaire", "sky", "scene", "estimator"],
    "modules/Kernels/estimator": ["control", "tracing", "kernel", "tally", "direct", "gathering", "methods", "solve",
                                  "quantities"],
    "modules/IOPhotometry": ["base", "material", "mesh", "gltf", "model", "image", "scene"],
}


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


def room_of(module, path):
    """The room of a path relative to the module, None for one that has no place in the order."""
    room = path.split("/")[0]
    return room if room in ROOMS[module] else None


def upward_includes(module, path, text):
    """Includes of a file, its path relative to the module, that lead to a higher room."""
    order = ROOMS[module]
    own = room_of(module, path)
    for header in includes(text) if own else []:
        candidates = (posixpath.normpath(posixpath.join(posixpath.dirname(path), header)), header)
        found = next((there for there in candidates if (ROOT / module / there).is_file()), "")
        room = room_of(module, found)
        if room and order.index(room) > order.index(own):
            yield header


@pytest.mark.parametrize("module", ROOMS)
def test_rooms_include_downwards_only(module):
    files = sources(".h", ".cxx", below=(module,))
    assert {room_of(module, path.relative_to(ROOT / module).as_posix()) for path in files} >= set(ROOMS[module])
    assert not [f"{name(path)} includes {header}" for path in files
                for header in upward_includes(module, path.relative_to(ROOT / module).as_posix(), path.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("path, line, caught", [
    ("base/Notes.h", '#include "../scene/SceneCameras.h"', True), ("mesh/Mesh.h", '#include "model/Model.h"', True),
    ("scene/SceneCameras.h", '#include "../base/Notes.h"', False), ("mesh/Mesh.h", '#include "ObjFile.h"', False),
    ("mesh/Mesh.h", "#include <vector>", False)])
def test_the_order_of_rooms_catches(path, line, caught):
    assert bool(list(upward_includes("modules/IOPhotometry", path, line))) == caught


@pytest.mark.parametrize("line, rule", [
    ('#include "vtkPolyData.h"', VTK_OR_QT.search), ("#include <QWidget>", VTK_OR_QT.search),
    ("# include <embree3/rtcore.h>", THIRD_PARTY.search), ("#include <tbb/parallel_for.h>", THIRD_PARTY.search),
    ("#include <ImfHeader.h>", THIRD_PARTY.search), ('#include "estimator/control/Settings.h"', of_the_kernels)])
def test_the_rules_catch(line, rule):
    header, = includes(line)
    assert rule(header)


@pytest.mark.parametrize("header, rule", [
    ("vector", VTK_OR_QT.search), ("geometry/Vector.h", VTK_OR_QT.search), ("vtkPolyData.h", THIRD_PARTY.search),
    ("vtkPolyData.h", of_the_kernels)])
def test_the_rules_let_pass(header, rule):
    assert not rule(header)
