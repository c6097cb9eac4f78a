# SPDX-License-Identifier: BSD-3-Clause
"""Where files may lie: read from anywhere, and the audit names those elsewhere; written only into the output folder."""
import json
import os
import sys
from pathlib import Path

import pytest
from conftest import PROBE, one_line

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "filters"))
import gltf  # noqa: E402

OBJ = "mtllib {library}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl grey2\nf 1 2 3\n"
TINY = ("--trajectories", 32)


def elsewhere(out):
    """What the audit says of files that lie elsewhere; None without."""
    lines = [one for one in json.loads((out / "summary.json").read_text())["audit"] if one["subject"] == "files elsewhere"]
    assert len(lines) <= 1
    return lines[0] if lines else None


def everything(folder):
    return {path.relative_to(folder): path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}


@pytest.fixture
def project(scene, tmp_path):
    """project/scene.json, which names files by three roads; beside the project a library."""
    folder, library = tmp_path / "project", tmp_path / "library"
    folder.mkdir(), library.mkdir()
    (library / "points.csv").write_text(PROBE)
    (library / "grey.mtl").write_text("newmtl grey2\nKd 0.5 0.5 0.5\n")

    def save(points, mtl):
        (folder / "meshes").mkdir(exist_ok=True)
        (folder / "meshes" / "one.obj").write_text(OBJ.format(library=mtl))
        (folder / "meshes" / "grey.mtl").write_text("newmtl grey2\nKd 0.5 0.5 0.5\n")
        (folder / "points.csv").write_text(PROBE)
        scene["surfaces"].append({"name": "one", "file": "./x/../meshes/one.obj"})
        scene["receivers"][2]["points"] = points
        (folder / "scene.json").write_text(json.dumps(scene))
        (folder / "x").mkdir(exist_ok=True)
        return folder / "scene.json"

    return save


def test_files_below_are_not_named(project, command, tmp_path):
    status, _, error = command("solve", project("points.csv", "grey.mtl"), "--out", tmp_path / "out", *TINY)
    assert status == 0 and "warning" not in error and elsewhere(tmp_path / "out") is None


def test_files_elsewhere_are_read_and_named(project, command, tmp_path):
    path = project(str(tmp_path / "library" / "points.csv"), "../../library/grey.mtl")
    assert command("solve", path, "--out", tmp_path / "out", *TINY)[0] == 0
    said = elsewhere(tmp_path / "out")
    assert said["choice"] == "2 read"
    assert said["reason"].endswith(f": {tmp_path}/library/grey.mtl, {tmp_path}/library/points.csv")


def test_paths_that_lead_out_and_back_are_named(project, command, tmp_path):
    path = project("../project/points.csv", "../meshes/grey.mtl")
    assert command("solve", path, "--out", tmp_path / "out", *TINY)[0] == 0
    assert elsewhere(tmp_path / "out")["choice"] == "2 read"


@pytest.mark.parametrize("name", ["../desk", "a/b", "/tmp/desk", "..", ".desk", "a\\b", "x" * 201])
@pytest.mark.parametrize("section", ["receivers", "cameras"])
def test_names_can_not_lead_out(scene, command, tmp_path, section, name):
    scene[section][0]["name"] = name
    path, before = scene.save(), everything(tmp_path)
    status, _, error = command("solve", path, "--out", tmp_path / "out", *TINY)
    assert status == 2 and "expected a name that can be a file name" in one_line(error)
    assert {key for key in everything(tmp_path) if key not in before} <= {Path("scene.json"), Path("probe.csv")}


def test_names_of_a_model_can_not_lead_out(command, tmp_path):
    model = gltf.floor(3, emissiveFactor=[1, 1, 1])
    for name in ("../../evil", "/tmp/evil", "..\\evil", ".evil"):
        camera = model.add("cameras", type="perspective", perspective={"yfov": 1, "aspectRatio": 1})
        model.node(name=name, camera=camera, translation=[0, 2, 4])
    model.save(tmp_path)
    before = everything(tmp_path)
    scene = {"kalos": 1, "surfaces": [{"file": "model.gltf"}],
             "cameras": [{"name": "own", "position": [0, -4, 2], "target": [0, 0, 0], "fov_deg": 30, "resolution": [4, 4]}]}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    status, _, error = command("solve", tmp_path / "scene.json", "--out", tmp_path / "deep" / "er" / "out", *TINY, "--hdr")
    assert status == 0, error
    written = set(everything(tmp_path)) - set(before) - {Path("scene.json")}
    assert written and all(path.parent == Path("deep/er/out") for path in written)
    names = {path.stem for path in written}
    assert {"-.-..-evil", "-tmp-evil", "-.-evil", "-evil", "own"} <= names


def test_a_link_in_the_output_folder_is_replaced_not_followed(scene, command, tmp_path):
    precious = tmp_path / "precious.csv"
    precious.write_text("keep me")
    (tmp_path / "out").mkdir()
    os.symlink(precious, tmp_path / "out" / "desk.csv")
    assert command("solve", scene.save(), "--out", tmp_path / "out", *TINY)[0] == 0
    assert precious.read_text() == "keep me" and not (tmp_path / "out" / "desk.csv").is_symlink()
