# SPDX-License-Identifier: BSD-3-Clause
"""What glTF files hold beside plain materials: it counts, or is told with how much it concerns. Sources of truth: the
texts of glTF 2.0 and its extensions, and closed forms."""
import json

import numpy as np
import pytest
from gltf import SQUARE, TRIANGLES, Gltf, floor
from models import cells, direct, error_of, names, notes, read, reasons


def changed(change, make=floor):
    gltf = make()
    change(gltf)
    return gltf


def colored(values, component=5126, kind="VEC4", **more):
    """A floor with COLOR_0, of a white material unless more is said."""
    gltf = Gltf()
    gltf.material((1, 1, 1))
    gltf.node(mesh=gltf.mesh(SQUARE, TRIANGLES, **({"material": 0} | more)))
    gltf["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = gltf.accessor(
        values, component, kind, **({"normalized": True} if component != 5126 else {}))
    return gltf


@pytest.mark.parametrize("make, reflectance", [
    (lambda: colored([(0.2, 0.2, 0.2, 1)] * 4), [0.2, 0.2]),
    (lambda: colored([(51, 51, 51)] * 4, 5121, "VEC3"), [0.2, 0.2]),
    (lambda: colored([(0.9, 0.9, 0.9, 1), (0, 0, 0, 1), (0, 0, 0, 1), (0.3, 0.3, 0.3, 1)]), [0.3, 0.4]),
    (lambda: colored([(0.2, 0.2, 0.2, 1)] * 4, material=None), [0.2, 0.2]),
])
def test_colours_of_points(tmp_path, make, reflectance):
    gltf = make()
    if gltf["meshes"][0]["primitives"][0].get("material", 0) is None:
        del gltf["meshes"][0]["primitives"][0]["material"]
    reader = read(gltf.save(tmp_path))
    np.testing.assert_allclose(cells(reader, "Reflectance"), reflectance, rtol=1e-6)
    assert reasons(reader)["colours of points"].endswith("(1: meshes[0])")


def test_too_few_colours(tmp_path):
    assert "fewer colours than points; expected as many" in error_of(tmp_path / "model.gltf", colored([(0.2, 0.2, 0.2, 1)] * 3).text())


@pytest.mark.parametrize("both, expected", [(True, (1000, 1000)), (False, (1000, 0))])
def test_emission_on_both_sides(tmp_path, both, expected):
    """Close to the middle of a wide Lambertian face the illuminance is pi L sin^2, on either side alike."""
    gltf = Gltf()
    gltf.material((0, 0, 0), doubleSided=both, emissiveFactor=[1, 1, 1],
                  extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 1000 / np.pi}})
    gltf.node(mesh=gltf.mesh(np.array(SQUARE) * 1000, TRIANGLES, material=0), translation=[0, 1, 0])
    path = gltf.save(tmp_path)
    place = np.array([(0, 0, 2.0), (0, 0, 0.0)])
    found = [direct(path, place[:1], (0, 0, -1))[0], direct(path, place[1:], (0, 0, 1))[0]]
    np.testing.assert_allclose(found, expected, rtol=1e-3, atol=1e-9)
    assert ("both sides" in reasons(read(path))["emissive materials"]) == both


@pytest.mark.parametrize("extension, expected", [
    ({"diffuseFactor": [0.3, 0.3, 0.3, 1], "specularFactor": [0, 0, 0], "glossinessFactor": 0}, {"Reflectance": 0.3, "Specular": 0}),
    ({"diffuseFactor": [0.5, 0.5, 0.5, 1], "specularFactor": [0.2, 0.2, 0.2], "glossinessFactor": 0.7},
     {"Reflectance": 0.4, "Specular": 0.2, "Roughness": 0.3}),
])
def test_specular_glossiness(tmp_path, extension, expected):
    gltf = floor()
    gltf["materials"][0] = {"extensions": {"KHR_materials_pbrSpecularGlossiness": extension}}
    reader = read(gltf.save(tmp_path))
    for name, value in expected.items():
        np.testing.assert_allclose(cells(reader, name), value, atol=1e-12, err_msg=name)


@pytest.mark.parametrize("place, subject", [
    (lambda g: g["nodes"][0], "EXT_lights_ies"), (lambda g: g["materials"][0], "KHR_materials_sheen"),
    (lambda g: g["meshes"][0]["primitives"][0], "VENDOR_new")])
def test_extensions_that_are_not_read_are_told(tmp_path, place, subject):
    gltf = floor()
    place(gltf).setdefault("extensions", {})[subject] = {}
    gltf["extensionsUsed"] = [subject]
    assert reasons(read(gltf.save(tmp_path)))[f"extension {subject}"] == "it is not read (1 uses)"


def test_hidden_nodes(tmp_path):
    gltf = floor()
    child = gltf.node(root=False, name="child", mesh=0)
    gltf.node(name="hidden", mesh=0, children=[child], extensions={"KHR_node_visibility": {"visible": False}})
    gltf.node(name="seen", mesh=0, extensions={"KHR_node_visibility": {"visible": True}})
    reader = read(gltf.save(tmp_path))
    assert names(reader) == ["floor", "seen"]
    assert reasons(reader)["hidden nodes"] == "with all that hangs on them (1: hidden)"


def test_compressed_points_are_an_error(tmp_path):
    gltf = json.loads(floor().text())
    gltf["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": {}}
    gltf["accessors"][0].pop("bufferView")
    assert error_of(tmp_path / "model.gltf", json.dumps(gltf)).startswith(
        "meshes[0].primitives[0]: its points are compressed (KHR_draco_mesh_compression); expected a file without compression")


@pytest.mark.parametrize("outer", [0.5, 0.02])
def test_a_spot_whose_cones_are_one(tmp_path, outer):
    """The extension's text: the difference of the cosines counts as 0.001 at least."""
    gltf = floor(10)
    gltf.light({"translation": [0, 2, 0], "rotation": [-np.sqrt(0.5), 0, 0, np.sqrt(0.5)]}, type="spot", intensity=100,
               spot={"innerConeAngle": outer, "outerConeAngle": outer})
    angles = np.array([0, 0.9 * outer, 0.999 * outer, 1.01 * outer])
    where = np.stack([2 * np.tan(angles), 0 * angles, 0 * angles], axis=1)
    share = np.clip((np.cos(angles) - np.cos(outer)) / 0.001, 0, 1) ** 2
    np.testing.assert_allclose(direct(gltf.save(tmp_path), where, (0, 0, 1)), 100 * share * np.cos(angles) ** 3 / 4, atol=0.01)


def test_a_texture_that_is_not_there(tmp_path):
    gltf = floor()
    gltf.add("images", uri="lost.png")
    gltf.add("textures", source=0)
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    reader = read(gltf.save(tmp_path))
    assert cells(reader, "Reflectance").tolist() == [0.5, 0.5]
    assert "lost.png" in reasons(reader)["textures that cannot be read"]


def test_a_last_row_that_is_a_little_off(tmp_path):
    gltf = floor()
    gltf.node(name="m", mesh=0, matrix=[1, 0, 0, 0, 0, 1, 0, 1e-7, 0, 0, 1, 0, 5, 6, 7, 0.99999994])
    assert names(read(gltf.save(tmp_path))) == ["floor", "m"]
    gltf.node(mesh=0, matrix=[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.1, 5, 6, 7, 1])
    assert "a projection; expected 0, 0, 0, 1 in the last row" in error_of(tmp_path / "bad.gltf", gltf.text())
