# SPDX-License-Identifier: BSD-3-Clause
"""kalos.Scene: built, read, changed, solved and written back; and the commands as functions."""
import json
import os
from pathlib import Path

import numpy as np
import pytest

import kalos
from kalos.validation.cases import DATA

PENDANT = DATA / "photometry" / "pendant.ldt"


@pytest.fixture
def scene():
    """A room with three luminaires of files and a mesh from arrays, two planes, points and a camera."""
    one = kalos.Scene()
    one.add_material("wall", reflectance=np.float64(0.5))
    one.add("surfaces", "room", box={"center": np.array([2, 2, 1.5]), "size": [4, 4, 3]}, material="wall")
    one.add_surface("desktop", kalos.quad((1, 1, 0.72), (1.6, 0, 0), (0, 0.8, 0), 0.3))
    for i, x in enumerate((1, 2, 3)):
        one.add_luminaire(f"lamp {i}", (x, 2, 2.5), file=os.path.relpath(PENDANT))
    one.add_plane("desk", (1, 1, 0.75), (1.6, 0, 0), (0, 0.8, 0), np.array([4, 2]))
    one.add_plane("floor", (0, 0, 0), (4, 0, 0), (0, 4, 0), (4, 4))
    one.add_points("probe", [[2, 2, 1]], (0, 0, 1))
    one.add_camera("eye", (0.5, 0.5, 1.2), (3, 3, 1), resolution=(8, 6))
    return one


def solve(scene, out, **more):
    return kalos.solve(scene, out, trajectories=320, threads=1, **more)


def test_built_and_solved(scene, tmp_path):
    result = solve(scene, tmp_path / "out")
    assert set(result["receivers"]) == {"desk", "floor", "probe"} and set(result["cameras"]) == {"eye"}
    assert (tmp_path / "out" / "desk.csv").exists() and result["receivers"]["desk"]["mean"] > 10


def test_written_read_and_solved_alike(scene, tmp_path):
    first = solve(scene, tmp_path / "first")
    scene.write(tmp_path / "scene.json")
    text = json.loads((tmp_path / "scene.json").read_text())
    assert text["surfaces"][1] == {"name": "desktop", "file": "desktop.vtp"} and text["luminaires"][0]["file"] == str(PENDANT)
    again = kalos.Scene.read(tmp_path / "scene.json")
    assert solve(again, tmp_path / "second")["receivers"] == first["receivers"] == solve(tmp_path / "scene.json",
                                                                                        tmp_path / "third")["receivers"]
    (tmp_path / "elsewhere").mkdir()
    again.write(tmp_path / "elsewhere" / "scene.json")
    assert solve(tmp_path / "elsewhere" / "scene.json", tmp_path / "fourth")["receivers"] == first["receivers"]


def test_changes_have_their_effect(scene, tmp_path):
    before = solve(scene, tmp_path / "before")["receivers"]["floor"]["mean"]
    scene.materials["wall"]["reflectance"] = 0.8
    brighter = solve(scene, tmp_path / "brighter")["receivers"]["floor"]
    for i in range(3):
        scene[f"lamp {i}"]["position"][2] = 1.0
    lower = solve(scene, tmp_path / "lower")["receivers"]["floor"]
    assert before < 0.8 * brighter["mean"] and lower["max"] > 1.2 * brighter["max"]
    scene["desk"]["plane"]["resolution"] = [2, 2]
    assert solve(scene, tmp_path / "coarser")["receivers"]["desk"]["points"] == 4
    with pytest.raises(KeyError, match="'lamp 9' is no surface, luminaire, receiver set or camera of this scene"):
        scene["lamp 9"]


def test_every_scene_of_the_data_reads_and_writes_back(tmp_path):
    paths = sorted(DATA.glob("*/*.json"))
    assert len(paths) > 20
    for path in paths:
        scene = kalos.Scene.read(path)
        scene.write(tmp_path / "again.json")
        one, other = (json.loads(file.read_text()) for file in (path, tmp_path / "again.json"))
        assert {key: value for key, value in one.items() if value} .keys() == other.keys()
        assert one.get("materials", {}) == other.get("materials", {}) and one.get("cameras", []) == other.get("cameras", [])


@pytest.mark.parametrize("text, message", [
    ("{", r"scene\.json: file: .*, expected JSON"), ("[]", r"scene\.json: kalos: not 1, expected"),
    ('{"kalos": 2}', r"scene\.json: kalos: not 1, expected")])
def test_files_that_are_none(tmp_path, text, message):
    (tmp_path / "scene.json").write_text(text)
    with pytest.raises(kalos.KalosError, match=message):
        kalos.Scene.read(tmp_path / "scene.json")
    with pytest.raises(kalos.KalosError, match=r"none\.json: file: cannot be read \(No such file or directory\)"):
        kalos.Scene.read(tmp_path / "none.json")


@pytest.mark.parametrize("call, message", [
    (lambda one: one.add("lamps", "a"), "section: is 'lamps', expected one of surfaces, luminaires, receivers, cameras"),
    (lambda one: one.add_surface("a", "b"), "mesh: is of str, expected vtkPolyData"),
    (lambda one: one.add_points("a", [[1, 2]], (0, 0, 1)), r"points: has shape \(1, 2\), expected \(n, 3\)"),
    (lambda one: solve(one, "/dev/null/out"), "/dev/null/out: --out: cannot be written"),
    (lambda one: solve(one, "out", disable=["walls"]), "disable: 'walls' is not allowed, expected some of stratified"),
    (lambda one: kalos.solve(one, "out", trajectories=0), "trajectories: '0' is not allowed"),
    (lambda one: kalos.study(one, "out", {"size": [1]}), "sweep: 'size' is not allowed, expected trajectories")])
def test_message(scene, call, message):
    with pytest.raises(kalos.KalosError, match=message):
        call(scene)


def test_errors_name_the_scene(scene, tmp_path):
    scene["lamp 1"]["position"] = [1, 2]
    with pytest.raises(kalos.KalosError, match=r"^scene: luminaires\.lamp 1\.position: "):
        solve(scene, tmp_path / "out")


def test_study_and_chart(scene, tmp_path):
    scene.cameras.clear()
    told = kalos.study(scene, tmp_path / "study", {"trajectories": [64, 128]}, reference_trajectories=320, threads=1)
    assert len(told["cells"]) == 2 and (tmp_path / "study" / "study.png").exists()
    lines = []
    told = kalos.chart(scene, tmp_path / "chart", receivers="desk", methods=["compensated"], budget=0.05, reference_trajectories=640,
                       say=lines.append)
    assert told["receivers"] == "desk" and lines and (tmp_path / "chart" / "chart.png").exists()


def test_validate():
    lines = []
    assert kalos.validate(methods=["direct"], trajectories=64, say=lines.append) in (True, False)
    assert any("white furnace" in line for line in lines)
    assert kalos.validate(methods=["direct"], data=Path(DATA), say=lines.append)
