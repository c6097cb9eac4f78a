# SPDX-License-Identifier: BSD-3-Clause
"""The Python package imports itself in one direction: no circle between its packages, nor between modules of one."""
import ast
from graphlib import CycleError, TopologicalSorter

import pytest
from sources import ROOT

PACKAGE = ROOT / "python" / "kalos"


def modules():
    """Files of the package by dotted name; a package is the name of its folder."""
    found = {}
    for path in PACKAGE.rglob("*.py"):
        parts = ["kalos", *path.relative_to(PACKAGE).with_suffix("").parts]
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imported(text, known):
    """Modules of the package that a source imports anywhere in it; `from kalos import x` is kalos.x where there is one."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names if name.name in known)
        elif isinstance(node, ast.ImportFrom) and node.module in known:
            for name in node.names:
                inner = f"{node.module}.{name.name}"
                yield inner if inner in known else node.module


def room(name):
    """The package below kalos that a module is in, or the module itself where it is in none."""
    return ".".join(name.split(".")[:2])


def graphs():
    known = modules()
    of_modules = {name: set(imported(path.read_text(encoding="utf-8"), known)) - {name} for name, path in known.items()}
    of_rooms = {}
    for name, others in of_modules.items():
        of_rooms.setdefault(room(name), set()).update(room(other) for other in others if room(other) != room(name))
    return of_modules, of_rooms


def circle(graph):
    """The names along a circle, if there is one."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return error.args[1]
    return None


def test_modules_import_in_one_direction():
    of_modules, _ = graphs()
    assert sum(map(len, of_modules.values())) > 100
    assert circle(of_modules) is None


def test_packages_import_in_one_direction():
    _, of_rooms = graphs()
    assert "kalos.estimation" in of_rooms["kalos"]
    assert circle(of_rooms) is None


@pytest.mark.parametrize("text, expected", [
    ("import kalos.a", ["kalos.a"]), ("from kalos import a, b", ["kalos.a", "kalos"]), ("from kalos.a import b", ["kalos.a"]),
    ("def f():\n    from kalos.c.d import e", ["kalos.c.d"]), ("from kalos.vtk import x\nimport numpy", [])])
def test_what_counts_as_an_import(text, expected):
    assert list(imported(text, {"kalos", "kalos.a", "kalos.c", "kalos.c.d"})) == expected


def test_a_circle_is_seen():
    assert set(circle({"a": {"b"}, "b": {"c"}, "c": {"a"}})) == {"a", "b", "c"}
