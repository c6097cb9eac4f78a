#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seeds of the fuzz targets: seeds.py FOLDER makes FOLDER/FuzzScene and so on."""
import json
import shutil
import struct
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
for folder in ("photometry", "filters"):
    sys.path.insert(0, str(TESTS / folder))

import gltf  # noqa: E402
import mutations  # noqa: E402

SCENE = {"kalos": 1, "materials": {"white": {"reflectance": 0.5}, "satin": {"reflectance": [0.4, 0.3, 0.2], "specular": 0.04,
         "roughness": 0.2, "exitance": 9}, "mirror": {"reflectance": 0, "mirror": 0.9}},
         "surfaces": [{"name": "q", "quad": {"origin": [0, 0, 0], "u": [5, 0, 0], "v": [0, 5, 0]}, "material": "white"},
                      {"name": "b", "box": {"center": [3, 1, 1], "size": [1, 1, 2], "rotation_z_deg": 9}, "material": "satin"},
                      {"name": "r", "file": "room.obj", "material": "mirror", "scale": 2, "up": "y"}],
         "luminaires": [{"name": "l", "position": [2, 2, 5], "aim": [0, 0, -1], "flux": 100, "distribution": "lambertian"},
                        {"name": "p", "rectangle": {"center": [6, 4, 3], "u": [1, 0, 0], "v": [0, 1, 0]}, "aim": [0, 0, -1], "flux": 9},
                        {"name": "s", "position": [1, 1, 4], "aim": [0, 0, -1], "rotation_deg": 5, "file": "spot.ies"}],
         "receivers": [{"name": "d", "plane": {"origin": [0, 0, 1], "u": [5, 0, 0], "v": [0, 5, 0], "resolution": [4, 4]}},
                       {"name": "e", "plane": {"origin": [0, 0, 1], "u": [5, 0, 0], "v": [0, 5, 0], "spacing": "EN 12464-1"}},
                       {"name": "t", "points": "probe.csv"}, {"name": "w", "surface": "q", "edge_length": 1, "flip": True},
                       {"name": "o", "observer": {"position": [0, 0, 1], "target": [1, 0, 1]}}],
         "cameras": [{"name": "c", "position": [2, -4, 2], "target": [2, 2, 2], "up": [0, 0, 1], "fov_deg": 45, "resolution": [8, 8]}]}


def scenes():
    yield json.dumps(SCENE)
    yield json.dumps({"kalos": 1, "surfaces": [{"file": "room.obj", "lights": True, "cameras": False}]})


def models():
    model = gltf.floor(3, emissiveFactor=[1, 1, 1], extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 10}})
    model.light({"translation": [0, 2, 0], "rotation": [0.7, 0, 0, 0.7]}, type="spot", intensity=9, spot={"outerConeAngle": 1})
    model.light({"scale": [1, 2, 1]}, type="directional", intensity=9, color=[1, 0.5, 0])
    model.node(camera=model.add("cameras", type="perspective", perspective={"yfov": 1, "aspectRatio": 2}), matrix=[
        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1])
    places = model.accessor([(0, 1, 0), (2, 1, 0)])
    model.node(mesh=0, extensions={"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}})
    model.accessor([1], 5121, "SCALAR")
    model["accessors"][0]["sparse"] = {"count": 1, "indices": {"bufferView": 3, "componentType": 5121}, "values": {"bufferView": 2}}
    yield model.text()
    yield model.binary()
    model["materials"][0]["doubleSided"] = True
    model["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = model.accessor([(51, 51, 51)] * 4, 5121, "VEC3", normalized=True)
    model["materials"].append({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"specularFactor": [0.2, 0.2, 0.2]}}})
    model.node(mesh=0, extensions={"KHR_node_visibility": {"visible": False}})
    model.light(type="spot", intensity=9, spot={"innerConeAngle": 0.5, "outerConeAngle": 0.5})
    yield model.text()
    yield ("\ufeffmtllib a.mtl model.obj\nnewmtl a #1\nkd 0.5\nmap_Ke -s 1 1 1 a.png\nd -halo 0.5\nPc 1\nlod 1\nusemtl a #1\n"
           "v 0 0 0 1 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 3 2 0\nv 3 1 0\nfo 1 2 3 4 1 5 6 \\\n7 8 5\nf 1 2\nusemtl\nf 1 2 1\n")
    yield "mtllib model.obj\nnewmtl a\nKd 0.5 0.5 0.5\nKs 1\nNs 9\nillum 3\no b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nf -1 -2 -3\n"


def meshes():
    head = "ply\nformat {} 1.0\ncomment c\nelement vertex 3\nproperty {} x\nproperty {} y\nproperty {} z\nelement face 1\n" \
           "property list uchar int vertex_indices\nend_header\n"
    yield head.format("ascii", *3 * ["float"]) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    corners = (0, 0, 0, 1, 0, 0, 0, 1, 0)
    yield head.format("binary_big_endian", *3 * ["double"]).encode() + struct.pack(">9dB3i", *corners, 3, 0, 1, 2)
    yield "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
    yield bytes(80) + struct.pack("<I12fH", 1, 0, 0, 1, *corners, 0)
    yield bytes(80) + struct.pack("<I12fH", 1, 0, 0, 1, *corners, 0) + b"more"
    yield "\ufeff SOLID a\nFACET\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nEND LOOP\nENDFACET\n"
    yield head.format("ascii", *3 * ["float"]).replace("face", "tristrips") + "0 0 0\n1 0 0\n0 1 0\n7 0 1 2 -1 2 1 0\n"
    yield "OFF # c\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 0\n2 0 1\n"


def probes():
    yield "x,y,z,nx,ny,nz\n0.5,0.5,0,0,0,1\n\n1e-3,-2.5E+2,0,0,1e-300,-1e300\r\n"
    yield "x, y, z, nx, ny, nz\n 1 , 2 , 3 , 0 , 0 , .5\n"
    yield "\ufeffx,y,z,nx,ny,nz\n1,2,3,0,0,1\n"


def checkpoints():
    yield b"\0KALOSCP2" + bytes(24)
    for kind in (1, 2, 3):  # nothing changed, a byte changed, cut short
        yield bytes([kind])
        yield bytes([kind, 40, 0, 7])
        yield bytes([kind, 0, 255, 0])


def main(folder):
    for target, seeds in (("FuzzScene", scenes()), ("FuzzModel", models()), ("FuzzMesh", meshes()), ("FuzzProbe", probes()),
                          ("FuzzCheckpoint", checkpoints())):
        (folder / target).mkdir(parents=True, exist_ok=True)
        for i, seed in enumerate(seeds):
            (folder / target / f"seed-{i}").write_bytes(seed if isinstance(seed, bytes) else seed.encode())
    (folder / "FuzzPhotometry").mkdir(exist_ok=True)
    for name, content, _ in mutations.corpus():
        (folder / "FuzzPhotometry" / name).write_bytes(content)
    for kept in sorted((TESTS / "fuzz" / "corpus").iterdir()):
        (folder / kept.name).mkdir(exist_ok=True)
        for file in kept.iterdir():
            shutil.copy(file, folder / kept.name)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
