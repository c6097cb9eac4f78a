# SPDX-License-Identifier: BSD-3-Clause
"""A small scene to spoil, and the command run in this process or as one of its own."""
import copy
import json
import os
import subprocess
from pathlib import Path

import pytest

from kalos.commands.main import main

ROOT = Path(__file__).resolve().parents[2]

SCENE = {
    "kalos": 1,
    "materials": {"grey": {"reflectance": 0.5}},
    "surfaces": [{"name": "floor", "quad": {"origin": [0, 0, 0], "u": [2, 0, 0], "v": [0, 2, 0]}, "material": "grey"},
                 {"name": "wall", "quad": {"origin": [0, 2, 0], "u": [2, 0, 0], "v": [0, 0, 2]}, "material": "grey"}],
    "luminaires": [{"name": "lamp", "position": [1, 1, 2], "aim": [0, 0, -1], "flux": 1000, "distribution": "lambertian"}],
    "receivers": [{"name": "desk", "plane": {"origin": [0, 0, 0.7], "u": [2, 0, 0], "v": [0, 1, 0], "resolution": [4, 2]}},
                  {"name": "wall", "surface": "wall", "edge_length": 1},
                  {"name": "probe", "points": "probe.csv"}],
    "cameras": [{"name": "front", "position": [1, -3, 1], "target": [1, 1, 1], "up": [0, 0, 1], "fov_deg": 40,
                 "resolution": [16, 12]}],
}
PROBE = "x,y,z,nx,ny,nz\n0.5,0.5,0,0,0,1\n1,0.5,0,0,0,1\n"


@pytest.fixture
def scene(tmp_path):
    """A scene to change at will, and save() that writes it with its probe and returns the path."""

    class Scene(dict):
        def save(self, probe=PROBE):
            (tmp_path / "probe.csv").write_text(probe)
            path = tmp_path / "scene.json"
            path.write_text(json.dumps(self))
            return path

    return Scene(copy.deepcopy(SCENE))


@pytest.fixture
def command(capfd):
    """Runs the command in this process: exit status, standard output, standard error."""

    def run(*arguments):
        try:
            status = main([str(a) for a in arguments])
        except SystemExit as stop:
            status = stop.code or 0
        captured = capfd.readouterr()
        return status, captured.out, captured.err

    return run


def launch(*arguments, **options):
    """Starts the command of the build tree as a process of its own."""
    return subprocess.Popen([os.environ["KALOS"], *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True, **options)


def one_line(error):
    """The message of an error, which is a single line and the only one."""
    assert error.startswith("kalos: error: ") and error.endswith("\n") and error.count("\n") == 1, error
    return error.removeprefix("kalos: error: ").rstrip("\n")
