# SPDX-License-Identifier: BSD-3-Clause
"""Provenance: version and seed in every output, the replay of a replicate, warnings about the light."""
import csv
import json
import re

import numpy as np
import pytest
from conftest import one_line
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import kalos
from kalos.results.fields import provenance


def test_version_and_seed_in_every_output(scene, command, tmp_path):
    out = tmp_path / "out"
    assert command("solve", scene.save(), "--out", out, "--trajectories", 640, "--seed", 4711)[0] == 0
    summary = json.loads((out / "summary.json").read_text())
    assert (summary["kalos"], summary["seed"]) == (kalos.__version__, 4711)
    for name in ("desk", "wall", "probe"):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(out / f"{name}.vtp"))
        reader.Update()
        assert provenance(reader.GetOutput()) == (kalos.__version__, 4711)
    for name in ("desk", "wall", "probe", "front"):
        picture = (out / f"{name}.png").read_bytes()
        assert f"Software\0kalos {kalos.__version__}".encode() in picture and b"Comment\0seed 4711" in picture
    image = (out / "front.exr").read_bytes()
    assert f"kalos {kalos.__version__}".encode() in image and b"kalosSeed" in image and b"4711" in image


def estimates(text):
    return float(re.search(r"estimate of \d+ trajectories: (\S+) lx", text)[1])


@pytest.mark.parametrize("method", ["compensated", "gathered"])
def test_replay(scene, command, tmp_path, method):
    options = ("--trajectories", 640, "--seed", 5, "--method", method)
    path, out = scene.save(), tmp_path / "out"
    assert command("solve", path, "--out", out, *options)[0] == 0
    with (out / "desk.csv").open() as file:
        value = float([row["illuminance_lx"] for row in csv.DictReader(file)][3])
    played, count = [], 1
    while len(played) < count:
        status, text, error = command("solve", path, "--out", tmp_path / "none", *options, "--replay", f"3:{len(played)}")
        assert status == 0, error
        count = int(re.search(r"replicate \d+ of (\d+)", text)[1])
        played.append(estimates(text))
    assert np.mean(played) == pytest.approx(value, rel=1e-12)
    assert np.std(played) > 0
    assert not (tmp_path / "none").exists()


@pytest.mark.parametrize("value, message", [
    ("12", "--replay: '12' is not allowed, expected RECEIVER:REPLICATE, such as 12:3; kalos solve --help tells more"),
    ("99:0", "replay: receiver 99 is not there; expected 0 to 25"), ("0:77", "replay: replicate 77 is not there; expected 0 to 7")])
def test_replay_of_what_is_not_there(scene, command, tmp_path, value, message):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "none", "--trajectories", 640, "--replay", value)
    assert status == 2
    assert one_line(error) == message


def test_light_that_is_no_number_ends_the_solve(scene, command, tmp_path):
    scene["materials"]["sun"] = {"reflectance": 0.5, "exitance": 1e39}
    scene["surfaces"][0]["material"] = "sun"
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640)
    assert status == 1
    message = error.strip().splitlines()[-1]
    assert re.search(r"receiver \d+ at \(.*\): a score of replicate \d+ is infinite, negative or not a number: trajectory \d+, "
                     r"vertex \d+ at \(.*\) carries inf lm", message), message
    assert not (tmp_path / "out").exists()


def test_turned_normals_are_a_warning(scene, command, tmp_path):
    scene["materials"]["panel"] = {"reflectance": 0.5, "exitance": 900}
    scene["surfaces"].append({"name": "ceiling", "quad": {"origin": [0, 0, 2.5], "u": [2, 0, 0], "v": [0, 2, 0]},
                              "material": "panel"})
    path = scene.save()
    status, text, error = command("solve", path, "--out", tmp_path / "out", "--trajectories", 6400)
    assert status == 0
    warnings = [line for line in error.splitlines() if line.startswith("kalos: warning: ")]
    assert warnings == [f"kalos: warning: {path}: surface ceiling shines out of the scene: its normals may be turned; "
                        "it emits on their side"]
    assert "  energy" in text and "absorbed, " in text
