# SPDX-License-Identifier: BSD-3-Clause
"""OBJ models and their libraries of materials."""
import numpy as np
import pytest
from helpers import minimal_scene, write_scene
from models import blocks, cells, error_of, names, normal, notes, read, reasons


OBJ = "mtllib room.mtl\no floor\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nusemtl wood\nf 1 2 3 4\n"
MTL = "newmtl wood\nKd 0.4 0.4 0.4\nKs 0.5 0.5 0.5\nNs 30\n"


def test_obj_with_its_library(tmp_path):
    (tmp_path / "room.mtl").write_text(MTL + "newmtl glow\nKd 0.8 0.8 0.8\nKe 100 100 100\n# mirror\nnewmtl steel\r\nKd 0 0 0\r\n"
                                       "Ks 0.6\r\nNs 198\r\nillum 3\r\nnewmtl pbr\nKd 0.5 0.5 0.5\nPr 0.3\nPm 1\n")
    (tmp_path / "room.obj").write_text(OBJ + "o lamp\nv 1 1 2.9\nv 2 1 2.9\nv 2 2 2.9\nusemtl glow\nf 7 6 5\nusemtl steel\nf 1 2 7\n"
                                       "usemtl pbr\nf 1 2 6\nf 1 2 1\n")
    reader = read(tmp_path / "room.obj")
    assert names(reader) == ["floor", "lamp"] and blocks(reader) == ["workplane"]
    np.testing.assert_allclose(cells(reader, "Reflectance"), (0.4, 0.8, 0, 0))
    np.testing.assert_allclose(cells(reader, "Exitance"), (0, 100 * np.pi, 0, 0))
    np.testing.assert_allclose(cells(reader, "Specular"), (0, 0, 0.6, 0.5))
    np.testing.assert_allclose(cells(reader, "Roughness")[2:], (0.01 ** 0.25, 0.3))
    np.testing.assert_allclose(normal(reader, 1), (0, 0, -1))
    found = notes(reader)
    assert found["axes"] == "as in the file, z up" and found["highlights"] == "left out"
    assert found["degenerate faces"] == "left out" and found["emissive materials"] == "exitance pi Ke"


def test_an_obj_in_a_scene_finds_names_in_the_scene_first(tmp_path):
    (tmp_path / "room.mtl").write_text(MTL)
    (tmp_path / "room.obj").write_text(OBJ)
    scene = minimal_scene()
    scene["surfaces"].append({"name": "room", "file": "room.obj"})
    assert cells(read(write_scene(tmp_path, scene)), "Reflectance").tolist() == [0.7, 0.4]
    scene["materials"]["wood"] = {"reflectance": 0.25}
    assert cells(read(write_scene(tmp_path, scene)), "Reflectance").tolist() == [0.7, 0.25]


@pytest.mark.parametrize("mtl, message", [
    ("newmtl\n", "room.mtl: line 1: newmtl without a name; expected the name of a material"),
    ("newmtl a\nKd 2 0 0\n", "room.mtl: line 2: no number, or one that is out of range; expected at least 0 and at most 1"),
    ("newmtl a\nKd x\n", "room.mtl: line 2: no number"), ("newmtl a\nillum 3\nNs -1\n", "room.mtl: line 3: no number"),
    ("newmtl a\nillum 3\nKs 2\n", "room.mtl: line 3: no number, or one that is out of range; expected at least 0 and at most 1")])
def test_broken_libraries(tmp_path, mtl, message):
    (tmp_path / "room.mtl").write_text(mtl)
    assert error_of(tmp_path / "room.obj", OBJ).replace(str(tmp_path) + "/", "").startswith(message)


def test_a_library_that_is_missing_or_named_twice_is_told_once(tmp_path):
    (tmp_path / "room.obj").write_text("mtllib room.mtl\n" + OBJ)
    reader = read(tmp_path / "room.obj")
    assert cells(reader, "Reflectance").tolist() == [0.5]
    assert reasons(reader)["materials that are defined nowhere"] == (
        "neither the scene nor a library of the file has them (there is no room.mtl) (1: wood)")
