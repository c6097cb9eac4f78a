# SPDX-License-Identifier: BSD-3-Clause
"""Errors of glTF files, in one line each."""
import json

import pytest
from gltf import floor
from models import error_of


def zeros(gltf, count):
    """Gives the floor points that stand nowhere in the file."""
    gltf["accessors"][0].pop("bufferView")
    gltf["accessors"][0].update(count=count)


def many_primitives(gltf):
    zeros(gltf, 4000000)
    gltf["meshes"][0]["primitives"] *= 9


def many_instances(gltf):
    zeros(gltf, 4000000)
    gltf["accessors"].append({"componentType": 5126, "count": 8, "type": "VEC3"})
    gltf["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}


def spoiled(change, make=floor):
    gltf = make()
    text = json.loads(gltf.text())
    change(text)
    return json.dumps(text)


@pytest.mark.parametrize("change, message", [
    (lambda g: g.pop("asset"), 'scene: the key "asset" is missing'),
    (lambda g: g["asset"].update(version="1.0"), 'asset.version: found "1.0"; expected "2.0"'),
    (lambda g: g.update(extensionsRequired=["KHR_draco_mesh_compression"]),
     'extensionsRequired[0]: found "KHR_draco_mesh_compression"; expected a file without compression'),
    (lambda g: g.pop("scenes") and g.pop("scene"), "scene: no scenes; expected one"),
    (lambda g: g.update(scene=3), "scene: found 3; expected the number of one of 1 scenes, counted from 0"),
    (lambda g: g["scenes"][0].update(nodes=[7]), "scenes[0].nodes[0]: found 7; expected the number of one of 1 nodes"),
    (lambda g: g["nodes"][0].update(children=[0]), "nodes.floor.children[0]: node 0 is met twice; expected a tree"),
    (lambda g: g["nodes"][0].update(mesh=1), "nodes.floor.mesh: found 1; expected the number of one of 1 meshes"),
    (lambda g: g["nodes"][0].update(mesh=-1), "nodes.floor.mesh: found -1; expected a number of at least 0"),
    (lambda g: g["nodes"][0].update(mesh=0.5), "nodes.floor.mesh: found 0.5; expected a whole number"),
    (lambda g: g["nodes"][0].update(matrix=[1] * 16), "nodes.floor.matrix: a projection; expected 0, 0, 0, 1 in the last row"),
    (lambda g: g["nodes"][0].update(matrix=[1]), "nodes.floor.matrix: found [1]; expected 16 numbers"),
    (lambda g: g["nodes"][0].update(scale=[1, "2", 1]), "nodes.floor.scale: found [1,\"2\",1]; expected three numbers"),
    (lambda g: g["meshes"][0].pop("primitives"), 'meshes[0]: the key "primitives" is missing'),
    (lambda g: g["meshes"][0]["primitives"][0].update(mode=9), "meshes[0].primitives[0].mode: found 9"),
    (lambda g: g["meshes"][0]["primitives"][0].update(material=2),
     "meshes[0].primitives[0].material: found 2; expected the number of one of 1 materials"),
    (lambda g: g["accessors"][1].update(count=5), "meshes[0].primitives[0]: 5 corners; expected three for each triangle"),
    (lambda g: g["accessors"][1].update(componentType=5126), "accessors[1].componentType: found 5126; expected an unsigned"),
    (lambda g: g["accessors"][0].update(componentType=1), "accessors[0].componentType: found 1; expected 5120"),
    (lambda g: g["accessors"][0].update(type="VEC2"), 'accessors[0].type: found "VEC2"; expected "VEC3"'),
    (lambda g: g["accessors"][0].update(count=2), "meshes[0].primitives[0].indices: point 2 is named; expected one of the 2"),
    (lambda g: g["accessors"][0].update(count=4000000000), "accessors[0].count: found 4000000000; expected a whole number from 1"),
    (lambda g: g["accessors"][0].update(count=6), "accessors[0]: 6 elements do not fit into the 48 bytes of the view"),
    (lambda g: g["accessors"][0].update(byteOffset=1 << 50), "accessors[0]: 4 elements do not fit"),
    (lambda g: g["accessors"][0].pop("bufferView"), "file: no polygons and no lights"),
    (lambda g: zeros(g, 4000001), 'accessors[0]: 4000001 elements without a "bufferView"; expected at most 4000000'),
    (many_primitives, "meshes[0].primitives[7]: too many triangles or points in one mesh; expected at most 10000000"),
    (many_instances, "nodes.floor: too many triangles over all instances; expected at most 10000000"),
    (lambda g: g["bufferViews"][0].update(byteStride=4), "bufferViews[0]: a stride of 4 bytes; expected 12 to 252"),
    (lambda g: g["bufferViews"][0].update(byteLength=1000), "bufferViews[0]: ends at byte 1000 of a buffer of 60; expected"),
    (lambda g: g["bufferViews"][0].update(buffer=4), "bufferViews[0].buffer: found 4; expected the number of one of 1 buffers"),
    (lambda g: g["buffers"][0].update(byteLength=100), "buffers[0]: 60 bytes; expected 100"),
    (lambda g: g["buffers"][0].pop("uri"), 'buffers[0]: neither a "uri" nor the binary chunk of a .glb'),
    (lambda g: g["buffers"][0].update(uri="lost.bin"), "buffers[0].uri: no file "),
    (lambda g: g["buffers"][0].update(uri="data:text/plain,abc"), "buffers[0].uri: a data URI that is not base64"),
    (lambda g: g["buffers"][0].update(uri="data:;base64,!!!!"), "buffers[0].uri: a character that is not of base64"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(baseColorFactor=[2, 0, 0, 1]),
     "materials[0].pbrMetallicRoughness.baseColorFactor: found [2,0,0,1]; expected numbers from 0 to 1"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(metallicFactor=-1), "materials[0].pbrMetallicRoughness.metallic"),
    (lambda g: g["materials"][0]["pbrMetallicRoughness"].update(baseColorTexture={"index": 0}),
     "materials[0].pbrMetallicRoughness.baseColorTexture.index: found 0; expected the number of one of 0 textures"),
    (lambda g: g.update(nodes=[7]), "nodes[0]: found 7; expected an object"),
])
def test_broken_gltf(tmp_path, change, message):
    error = error_of(tmp_path / "model.gltf", spoiled(change))
    assert error.startswith(message), error


@pytest.mark.parametrize("change, message", [
    (lambda b: b[:10], "header: no glTF binary of version 2"), (lambda b: b[:4] + b"\1" + b[5:], "header: no glTF binary of"),
    (lambda b: b[:-1], "header: a file of "), (lambda b: b[:16] + b"ABCD" + b[20:], "header: the first chunk is no JSON"),
    (lambda b: b[:12] + b"\xff\xff\xff\x7f" + b[16:], "header: the first chunk is no JSON, or not complete"),
    (lambda b: b.replace(b"BIN\0", b"BAN\0"), "buffers[0]: neither"), (lambda b: b"", "line 1"), (lambda b: b"{", "line 1")])
def test_broken_glb(tmp_path, change, message):
    assert error_of(tmp_path / "model.glb", change(floor().binary())).startswith(message)


def test_every_prefix_of_a_file_is_an_error_of_one_line(tmp_path):
    whole = floor().binary()
    for length in range(0, len(whole), 7):
        error_of(tmp_path / "model.glb", whole[:length])
