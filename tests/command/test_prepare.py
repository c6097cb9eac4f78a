# SPDX-License-Identifier: BSD-3-Clause
"""kalos prepare: every format in, a surface and a report out, one line an error."""
import json

import pytest
from conftest import ROOT, one_line
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from kalos.preparation.mesh_readers import poly_data, read_mesh

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIDES = [(1, 3, 2, 0), (6, 7, 5, 4), (4, 5, 1, 0), (3, 7, 6, 2), (2, 6, 4, 0), (5, 7, 3, 1)]  # seen from inside


def triangles():
    return [(a, b, c) for a, b, c, d in SIDES] + [(a, c, d) for a, b, c, d in SIDES]


def write_obj(path):
    """Every side with corners of its own, half of them of another material."""
    lines = []
    for number, side in enumerate(SIDES):
        lines += [f"usemtl {'red' if number < 3 else 'white paint'}"] + ["v %g %g %g" % CUBE[i] for i in side] + ["f -4/1 -3 -2 -1"]
    path.write_text("\n".join(lines))


def write_off(path):
    lines = ["OFF # a comment", f"{len(CUBE)} {len(SIDES)} 0"] + ["%g %g %g" % p for p in CUBE]
    path.write_text("\n".join(lines + ["4 %d %d %d %d 255 0 0" % side for side in SIDES]))


def write_gltf(path):
    import base64
    import struct

    points = b"".join(struct.pack("<3f", *p) for p in CUBE)
    indices = b"".join(struct.pack("<3H", *t) for t in triangles())
    data = base64.b64encode(points + indices).decode()
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": "data:application/octet-stream;base64," + data, "byteLength": len(points + indices)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]}))


def write_glb(path):
    """The binary form: one chunk of JSON, one of numbers."""
    import base64
    import struct

    write_gltf(path)
    text = json.loads(path.read_text())
    data = base64.b64decode(text["buffers"][0].pop("uri").split(",")[1])
    head = json.dumps(text).encode()
    head += b" " * (-len(head) % 4)
    data += b"\0" * (-len(data) % 4)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(head) + len(data)) + struct.pack("<I4s", len(head), b"JSON")
                     + head + struct.pack("<I4s", len(data), b"BIN\0") + data)


def by(writer):
    def write(path):
        writer_ = writer()
        writer_.SetFileName(str(path))
        writer_.SetInputData(poly_data(CUBE, triangles()))
        writer_.Write()

    return write


LOST = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                   "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                   "buffers": [{"uri": "not-there.bin", "byteLength": 36}],
                   "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
                   "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                  "min": [0, 0, 0], "max": [1, 1, 1]}]})

WRITERS = {"obj": write_obj, "off": write_off, "gltf": write_gltf, "glb": write_glb, "ply": by(vtkPLYWriter), "stl": by(vtkSTLWriter),
           "vtp": by(vtkXMLPolyDataWriter)}


@pytest.mark.parametrize("suffix", WRITERS)
def test_every_format(suffix, command, tmp_path):
    path = tmp_path / f"cube.{suffix}"
    WRITERS[suffix](path)
    status, out, error = command("prepare", path, "--out", tmp_path / "out.vtp", "--report", tmp_path / "report.json")
    assert status == 0, error
    assert "12 concave (12 m), 0 contact" in out
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["repair"]["area after, m²"] == pytest.approx(6)
    assert report["repair"]["points after"] == 8
    assert report["singular_edges"]["concave"] == {"curves": 12, "length_m": pytest.approx(12)}


def test_materials_of_an_obj_survive_remeshing(command, tmp_path):
    write_obj(tmp_path / "cube.obj")
    assert command("prepare", tmp_path / "cube.obj", "--out", tmp_path / "out.vtp", "--edge-length", 0.2)[0] == 0
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "out.vtp"))
    reader.Update()
    surface = reader.GetOutput()
    names = surface.GetFieldData().GetAbstractArray("MaterialNames")
    assert [names.GetValue(i) for i in range(2)] == ["red", "white paint"]
    ids = surface.GetCellData().GetArray("MaterialIds")
    red = [i for i in range(surface.GetNumberOfCells()) if ids.GetValue(i) == 0]
    assert sum(surface.GetCell(i).ComputeArea() for i in red) == pytest.approx(3)


def test_the_cornell_room(command, tmp_path):
    status, out, _ = command("prepare", ROOT / "data/cornell/room.obj", "--out", tmp_path / "out.vtp", "--edge-length", 0.5)
    assert status == 0 and "8 concave (40 m)" in out
    assert read_mesh(tmp_path / "out.vtp").GetNumberOfCells() > 1000


@pytest.mark.parametrize("name, text, message", [
    ("none.obj", None, "is not there"), ("mesh.xyz", "", "unknown format"), ("empty.obj", "", "no polygons"),
    ("bad.obj", "v 0 0 zero\n", "line 1: a vertex without three numbers"), ("far.obj", "v 0 0 0\nf 1 2 3\n", "line 2"),
    ("short.off", "OFF\n3 1 0\n0 0 0\n", "line 3: the file ends here"), ("no.off", "3 1 0\n", "no OFF header"), ("bad.stl", "solid nothing", "bad.stl"),
    ("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: a vertex without three numbers"), ("bad.vtp", "<nothing", "bad.vtp"),
    ("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "degenerate"), ("bad.gltf", "{", "bad.gltf"), ("lost.gltf", LOST, "buffers[0].uri: no file"), ("bad.ply", "ply\n", "ends within the header"),
    ("list.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int vertex_indices\nend_header\n", "vertex 1: the file ends here"),
    ("points.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "no polygons"), ("many.ply", "ply\nformat ascii 1.0\nelement vertex 900000000\nend_header\n", "has no properties"), ("not.ply", "obj\n", "does not start with 'ply'")])
def test_bad_files(name, text, message, command, tmp_path):
    if text is not None:
        (tmp_path / name).write_text(text)
    status, _, error = command("prepare", tmp_path / name, "--out", tmp_path / "out.vtp")
    assert status == 2
    assert message in one_line(error.splitlines()[-1] + "\n")
    assert not (tmp_path / "out.vtp").exists()


@pytest.mark.parametrize("options, message", [
    (["--edge-length", "0"], "--edge-length"), (["--edge-length", "1e-6"], "triangles"), (["--time", "1e-9"], "time limit"), (["--time", "0"], "--time"), (["--out", "nowhere/out.vtp"], "--out"),
    (["--out", "out.txt"], ".vtp")])
def test_bad_options(options, message, command, tmp_path):
    write_off(tmp_path / "cube.off")
    status, _, error = command("prepare", tmp_path / "cube.off", "--out", tmp_path / "out.vtp", *options)
    assert status == 2
    assert message in error.splitlines()[-1]
    assert not (tmp_path / "out.vtp").exists()
