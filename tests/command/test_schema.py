# SPDX-License-Identifier: BSD-3-Clause
"""`kalos schema` says what the reader of scenes accepts and what a solve writes."""
import json
import re
from pathlib import Path

import pytest
from conftest import SCENE

jsonschema = pytest.importorskip("jsonschema", reason="no jsonschema")
ROOT = Path(__file__).resolve().parents[2]
POINT = {"name": "lamp", "position": [1, 1, 2], "aim": [0, 0, -1], "flux": 1000, "distribution": "lambertian"}
PLANE = {"origin": [0, 0, 0.7], "u": [2, 0, 0], "v": [0, 1, 0], "resolution": [4, 2]}


@pytest.fixture
def schema(command):
    def get(*kind):
        status, out, error = command("schema", *kind)
        assert status == 0 and error == ""
        found = json.loads(out)
        jsonschema.Draft202012Validator.check_schema(found)
        return jsonschema.Draft202012Validator(found)

    return get


def test_scenes_of_the_data_fit(schema):
    validator, paths = schema(), sorted((ROOT / "data").glob("*/*.json"))
    assert len(paths) > 20
    for path in paths:
        assert [error.message for error in validator.iter_errors(json.loads(path.read_text()))] == [], path


def keys_of_the_reader():
    """Every list of keys that the reader of scenes accepts."""
    folder = ROOT / "modules" / "IOPhotometry"
    for path in folder.rglob("*.cxx"):
        for found in re.findall(r"[cC]heckKeys\(\s*\{(\"[^}]*)\}\)", path.read_text()):
            yield frozenset(re.findall(r'"([^"]+)"', found))


def keys_of_the_schema(node):
    if isinstance(node, dict):
        if node.get("type") == "object" and node.get("additionalProperties") is False:
            yield frozenset(node["properties"])
        for one in node.values():
            yield from keys_of_the_schema(one)
    elif isinstance(node, list):
        for one in node:
            yield from keys_of_the_schema(one)


def test_reader_and_schema_know_the_same_keys(schema):
    """A list of the schema may be the union of some of the reader's: a surface of a quad and of a model."""
    reader, own = set(keys_of_the_reader()), {keys - {"$schema"} for keys in keys_of_the_schema(schema().schema)}
    assert len(reader) > 10
    for keys in own:
        parts = [one for one in reader if one - {"$schema"} <= keys]
        assert keys == frozenset().union(*parts) - {"$schema"}, sorted(keys)
    for keys in reader:
        assert any(keys - {"$schema"} <= one for one in own), sorted(keys)


def test_a_scene_may_name_its_schema(schema, scene, command, tmp_path):
    scene["$schema"] = "kalos.schema.json"
    assert schema().is_valid(scene)
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 64)
    assert status == 0, error


@pytest.mark.parametrize("section, entry", [
    ("surfaces", {"name": "a", "quad": {"origin": [0, 0, 0], "u": [1, 0, 0]}, "material": "grey"}),
    ("surfaces", {"name": "a", "box": {"center": [0, 0, 0], "size": [1, 0, 1]}, "material": "grey"}),
    ("surfaces", {"name": "a", "box": {"center": [0, 0, 0], "size": [1, 1, 1]}}),
    ("surfaces", {"name": "a", "material": "grey"}),
    ("surfaces", {"name": "a", "quad": {"origin": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0]}, "material": "grey", "scale": 2}),
    ("luminaires", {**POINT, "distribution": "magic"}), ("luminaires", {**POINT, "flux": -1}), ("luminaires", {**POINT, "colour": 1}),
    ("luminaires", {key: value for key, value in POINT.items() if key != "aim"}),
    ("luminaires", {**POINT, "rectangle": {"center": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 0]}}),
    ("luminaires", {**POINT, "position": [1, 1]}),
    ("receivers", {"name": "a"}), ("receivers", {"name": "a", "plane": {**PLANE, "spacing": "EN 12464-1"}}),
    ("receivers", {"name": "a", "plane": {**PLANE, "resolution": [0, 2]}}), ("receivers", {"name": "a", "surface": "wall"}),
    ("receivers", {"name": "a", "plane": PLANE, "points": "probe.csv"}),
    ("receivers", {"name": "a", "points": "probe.csv", "flip": True}),
    ("cameras", {**SCENE["cameras"][0], "fov_deg": 180}), ("cameras", {**SCENE["cameras"][0], "resolution": [4]})])
def test_what_the_reader_refuses_does_not_fit(schema, scene, command, tmp_path, section, entry):
    scene[section].append({**entry, "name": "another"})
    assert not schema().is_valid(dict(scene))
    assert command("solve", scene.save(), "--out", tmp_path / "out")[0] == 2


def test_a_summary_fits(schema, scene, command, tmp_path):
    scene["receivers"].append({"name": "seat", "observer": {"position": [1, 0.5, 1], "target": [1, 1, 1]}})
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 320, "--error", 0.5)
    assert status == 0, error
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert [error.message for error in schema("summary").iter_errors(summary)] == []
    summary["receivers"]["desk"]["mean"] = "much"
    assert not schema("summary").is_valid(summary)


def test_unknown_kind(command):
    status, _, error = command("schema", "mesh")
    assert status == 2 and error.startswith("kalos: error: scene|summary: invalid choice: 'mesh'")
