# SPDX-License-Identifier: BSD-3-Clause
"""Files that other programs read are read: each row is a way to write a square of 1 m2, and what is told about it.

The square and its reflectance are the truth; reading nothing, half of it or another material is what used to happen.
"""
import struct

import numpy as np
import pytest
from helpers import minimal_scene, update_error, write_scene
from kalos.vtk import vtkKalosMeshReader
from models import cells, read, reasons
from vtkmodules.util.numpy_support import vtk_to_numpy

POINTS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
OBJ = "mtllib a.mtl\n" + POINTS + "usemtl wood\nf 1 2 3 4\n"
MTL = "newmtl wood\nKd 0.4 0.4 0.4\n"
FACETS = (" facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1 0\n  endloop\n endfacet\n"
          " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 1 0\n   vertex 0 1 0\n  endloop\n endfacet\n")
STL = "solid x\n" + FACETS + "endsolid x\n"
BINARY = b"\0" * 80 + struct.pack("<I", 2) + b"".join(
    struct.pack("<12fH", 0, 0, 1, *a, *b, *c, 0)
    for a, b, c in [((0, 0, 0), (1, 0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1, 0), (0, 1, 0))])
PLY = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")


def area(reader):
    """Of all that looks up, less what looks down."""
    total = 0
    for i in range(reader.GetSurfaces().GetNumberOfCells()):
        p = vtk_to_numpy(reader.GetSurfaces().GetCell(i).GetPoints().GetData())
        total += np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum(axis=0)[2] / 2
    return total


def loose_area(path):
    """By the reader for repair, which has the same eyes."""
    reader = vtkKalosMeshReader()
    reader.SetFileName(str(path))
    assert update_error(reader) is None
    mesh, total = reader.GetOutput(), 0
    for i in range(mesh.GetNumberOfCells()):
        p = vtk_to_numpy(mesh.GetCell(i).GetPoints().GetData())
        total += np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum(axis=0)[2] / 2
    return total


def check(reader, reflectance, told):
    """The whole square, of this reflectance, and these notes on it with the number of what they concern."""
    assert area(reader) == pytest.approx(1)
    np.testing.assert_allclose(cells(reader, "Reflectance"), reflectance, rtol=1e-6)
    found = reasons(reader)
    for subject, reason in told.items():
        assert reason in found.get(subject, ""), found
    if not told:
        assert not set(found) - {"axes", "warning", "receivers", "surfaces without a material"}, found


@pytest.mark.parametrize("obj, mtl, reflectance, told", [
    (OBJ, MTL, 0.4, {}),
    (OBJ + "lod 3\nbevel off\nusemap x\nmg 0\nc_interp on\ncurv 0 1 1 2\nl 1 2\ntrace_obj x\n", MTL, 0.4, {}),
    (OBJ.replace("f 1", "fo 1"), MTL, 0.4, {}),
    ("\ufeff" + OBJ, "\ufeff" + MTL, 0.4, {}),
    (OBJ.replace("\n", "\r\n"), MTL.replace("\n", "\r\n"), 0.4, {}),
    (OBJ.replace("f 1 2 3 4", "f 1 2 \\\n3 4"), MTL, 0.4, {}),
    (OBJ.replace("a.mtl", "b.mtl a.mtl"), MTL, 0.4, {}),
    (OBJ.replace("a.mtl", "sub\\..\\a.mtl"), MTL, 0.4, {}),
    (OBJ.replace("wood", "Material #1"), "newmtl Material #2\nKd 0.1 0.1 0.1\nnewmtl Material #1\nKd 0.4 0.4 0.4\n", 0.4, {}),
    (OBJ.replace("wood", "wood # of the floor"), MTL, 0.4, {}),
    (OBJ, MTL.replace("wood", "wood # of the floor"), 0.4, {}),
    (OBJ, "newmtl wood\nkd 0.4 0.4 0.4\n", 0.4, {}),
    (OBJ, MTL + "Ks 1.031544 1.031544 1.031544\nillum 2\n", 0.4, {"highlights": "(1: wood)"}),
    (OBJ, MTL + "d -halo 0.5\n", 0.4, {"transparent materials": "(1: wood)"}),
    (OBJ, MTL + "Ns -1\nTf spectral x.rfl\nillum 2\n", 0.4, {}),
    (OBJ, MTL + "map_Kd -s 2 2 -o 0.5 -clamp on lost file.png\n", 0.4,
     {"textures that cannot be read": "there is no file lost file.png (1: wood)"}),
    (OBJ, MTL + "map_d holes.png\n", 0.4, {"transparent materials": "(1: wood)"}),
    (OBJ, MTL + "Pc 0.5\n", 0.4, {"statement pc": "no such property is modelled (1: wood)"}),
    (OBJ + "f 1 2\nf 3\n", MTL, 0.4, {"degenerate faces": "(2)"}),
    (OBJ + "f 1 2 1\n", MTL, 0.4, {"degenerate faces": "(1)"}),
    (OBJ.replace("wood", "pine"), MTL, 0.5, {"materials that are defined nowhere": "(1: pine)"}),
    (OBJ.replace("usemtl wood", "usemtl"), MTL, 0.5, {"surfaces without a material": "(1: a.obj)"}),
])
def test_obj(tmp_path, obj, mtl, reflectance, told):
    (tmp_path / "sub").mkdir()
    (tmp_path / "a.obj").write_bytes(obj.encode())
    (tmp_path / "a.mtl").write_bytes(mtl.encode())
    check(read(tmp_path / "a.obj"), reflectance, told)
    assert loose_area(tmp_path / "a.obj") == pytest.approx(1)


@pytest.mark.parametrize("name, content, told", [
    ("a.stl", STL, {}),
    ("a.stl", " " + STL, {}),
    ("a.stl", "\n\t" + STL, {}),
    ("a.stl", "\ufeff" + STL, {}),
    ("a.stl", STL.upper(), {}),
    ("a.stl", STL.replace("endloop", "end loop").replace("endfacet", "end facet"), {}),
    ("a.stl", "solid x\n" + FACETS, {"STL": "the word endsolid is missing"}),
    ("a.stl", STL.replace("endsolid", FACETS.replace("1 1 0", "0 0 0") + "endsolid"),
     {"degenerate faces": "(2)"}),
    ("a.stl", BINARY, {}),
    ("a.stl", BINARY + b"\r\n", {"STL": "2 bytes follow those that its count tells"}),
    ("a.stl", b"solid" + BINARY[5:] + b"\r\n", {"STL": "2 bytes follow"}),
    ("a.ply", PLY, {}),
    ("a.ply", PLY.replace("face 1", "face 2") + "3 0 1 1\n", {"degenerate faces": "(1)"}),
    ("a.ply", PLY.replace("element face", "element tristrips").replace("4 0 1 2 3", "4 0 1 3 2"), {}),
    ("a.ply", PLY.replace("element face", "element tristrips").replace("4 0 1 2 3", "7 0 1 2 -1 0 2 3"), {}),
    ("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", {}),
    ("a.off", "OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n", {"degenerate faces": "(1)"}),
])
def test_other_meshes(tmp_path, name, content, told):
    (tmp_path / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    scene = minimal_scene()
    scene["surfaces"] = [{"name": "mesh", "file": name, "material": "white"}]
    check(read(write_scene(tmp_path, scene)), 0.7, told)
    assert loose_area(tmp_path / name) == pytest.approx(1)


def test_a_table_of_receivers_with_a_mark(tmp_path):
    (tmp_path / "p.csv").write_bytes(b"\xef\xbb\xbfx,y,z,nx,ny,nz\n1,2,3,0,0,1\n")
    scene = minimal_scene()
    scene["receivers"] = [{"name": "p", "points": "p.csv"}]
    assert read(write_scene(tmp_path, scene)).GetReceivers().GetBlock(0).GetPoint(0) == (1, 2, 3)


def test_an_emissive_texture(tmp_path):
    """Ke times the mean of the texture; Ke is 1 where only the texture is given."""
    from test_model_materials import png

    (tmp_path / "a.png").write_bytes(png([[(255, 255, 255), (0, 0, 0)]]))
    (tmp_path / "a.obj").write_text(OBJ)
    for lines, luminance in (("Ke 100 100 100\nmap_Ke a.png\n", 50), ("map_Ke a.png\n", 0.5)):
        (tmp_path / "a.mtl").write_text(MTL + lines)
        np.testing.assert_allclose(cells(read(tmp_path / "a.obj"), "Exitance"), np.pi * luminance)


def test_the_reader_for_repair_passes_over_more(tmp_path):
    (tmp_path / "a.obj").write_text(OBJ + "surf 0 1 0 1 1 2 3 4\nmystery 1\n")
    reader = vtkKalosMeshReader()
    reader.SetFileName(str(tmp_path / "a.obj"))
    assert update_error(reader) is None
    notes = reader.GetOutput().GetFieldData().GetAbstractArray("SceneNotes")
    assert [notes.GetValue(i) for i in range(0, notes.GetNumberOfValues(), 3)] == ["curved surfaces", "unknown statements"]


@pytest.mark.parametrize("name, content, message", [
    (None, None, "mesh: FileName: not set; expected the path of a mesh file"),
    ("a.dwg", "x", "a.dwg: name: unknown format '.dwg'; expected .obj, .ply, .stl, .off, .vtp, .gltf or .glb"),
    ("a.obj", None, "a.obj: file: is not there; expected a mesh file"),
    ("a.obj", "v 0 0 0\n", "a.obj: file: no polygons; expected at least one"),
    ("a.obj", "v 0 0 0\nf 1 2 3\n", "a.obj: line 2: a face corner '2'; expected a vertex number from 1 to 1"),
    ("a.ply", PLY.replace("4 0 1 2 3", "4 0 1 2 9"), "a.ply: face 1: a corner is point 9; expected one of the 4 points"),
])
def test_what_the_reader_for_repair_refuses(tmp_path, name, content, message):
    if content is not None:
        (tmp_path / name).write_text(content)
    reader = vtkKalosMeshReader()
    if name:
        reader.SetFileName(str(tmp_path / name))
    assert update_error(reader).replace(f"{tmp_path}/", "").startswith(message)
    assert reader.GetOutput().GetNumberOfCells() == 0


def test_backslashes_in_a_scene_file(tmp_path):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "a.ply").write_text(PLY)
    (tmp_path / "sub" / "p.csv").write_text("x,y,z,nx,ny,nz\n1,2,3,0,0,1\n")
    scene = minimal_scene()
    scene["surfaces"] = [{"name": "mesh", "file": "sub\\a.ply", "material": "white"}]
    scene["receivers"] = [{"name": "p", "points": "sub\\p.csv"}]
    check(read(write_scene(tmp_path, scene)), 0.7, {})
