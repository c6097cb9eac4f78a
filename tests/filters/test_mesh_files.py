# SPDX-License-Identifier: BSD-3-Clause
"""OBJ, PLY, STL and VTP surfaces: round trips, materials, damage."""
import struct

import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from helpers import minimal_scene, update_error, write_scene
from kalos.vtk import vtkKalosSceneReader

TRIANGLES = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1234567890123\n"


def scene_with(file, **keys):
    scene = minimal_scene()
    scene["materials"]["red"] = {"reflectance": 0.2}
    scene["surfaces"] = [dict({"name": "mesh", "file": file, "material": "white"}, **keys)]
    if keys.get("material", "") is None:
        del scene["surfaces"][0]["material"]
    return scene


def read(folder, file, **keys):
    reader = vtkKalosSceneReader()
    reader.SetFileName(write_scene(folder, scene_with(file, **keys)))
    assert update_error(reader) is None
    return reader.GetSurfaces()


def error_of(folder, file, **keys):
    reader = vtkKalosSceneReader()
    path = write_scene(folder, scene_with(file, **keys))
    reader.SetFileName(path)
    error = update_error(reader)
    assert error is not None, "no error"
    assert reader.GetSurfaces().GetNumberOfCells() == 0
    return error.replace(path + ": ", "", 1).replace(str(folder) + "/", "")


def polygons(data):
    return [[data.GetCell(i).GetPoints().GetPoint(k) for k in range(data.GetCell(i).GetNumberOfPoints())]
            for i in range(data.GetNumberOfCells())]


def reflectances(data):
    return vtk_to_numpy(data.GetCellData().GetArray("Reflectance")).tolist()


def make_triangles():
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for point in [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.5)]:
        points.InsertNextPoint(point)
    cells = vtkCellArray()
    for ids in [(0, 1, 2), (0, 2, 3)]:
        cells.InsertNextCell(3, ids)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


EXPECTED = [[(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 0, 0), (1, 1, 0), (0, 1, 0.5)]]


def write(folder, name, data, binary=True):
    writer = {"stl": vtkSTLWriter, "ply": vtkPLYWriter, "vtp": vtkXMLPolyDataWriter}[name[-3:]]()
    writer.SetFileName(str(folder / name))
    writer.SetInputData(data)
    if name[-3:] != "vtp":
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
    writer.Write()


def test_obj_keeps_doubles_and_polygons(tmp_path):
    (tmp_path / "a.obj").write_text("# c\nmtllib x.mtl\n" + TRIANGLES + "vn 0 0 1\nf 1/2/3 2//1 3 \\\n4 # quad\nf -4 -3 -1\n")
    data = read(tmp_path, "a.obj")
    assert [len(p) for p in polygons(data)] == [4, 3]
    assert polygons(data)[0][3] == (0, 1, 0.1234567890123)
    assert polygons(data)[1] == [(0, 0, 0), (1, 0, 0), (0, 1, 0.1234567890123)]
    assert reflectances(data) == [0.7, 0.7]


def test_obj_materials(tmp_path):
    (tmp_path / "a.obj").write_text(TRIANGLES + "f 1 2 3\nusemtl red\nf 1 3 4\nusemtl white\nf 1 2 4\n")
    assert reflectances(read(tmp_path, "a.obj")) == [0.7, 0.2, 0.7]
    assert error_of(tmp_path, "a.obj", material=None).startswith(
        'surfaces.mesh.file: the file has polygons without a material; expected the key "material"')


@pytest.mark.parametrize("name, binary", [("a.stl", True), ("a.stl", False), ("a.ply", True), ("a.ply", False), ("a.vtp", True)])
def test_round_trip(tmp_path, name, binary):
    write(tmp_path, name, make_triangles(), binary)
    assert polygons(read(tmp_path, name)) == EXPECTED


def test_ply_big_endian_doubles_and_other_properties(tmp_path):
    header = ("ply\nformat binary_big_endian 1.0\ncomment c\nelement vertex 3\nproperty uchar red\nproperty double x\n"
              "property double y\nproperty double z\nelement face 1\nproperty list uchar uint vertex_index\n"
              "property list uchar float texcoord\nelement edge 1\nproperty int v\nend_header\n")
    vertices = b"".join(struct.pack(">Bddd", 7, *p) for p in [(0, 0, 0), (1 / 3, 0, 0), (0, 1, 0)])
    body = vertices + struct.pack(">BIIIBff", 3, 0, 1, 2, 2, 0.5, 0.5) + struct.pack(">i", 4)
    (tmp_path / "a.ply").write_bytes(header.encode() + body)
    assert polygons(read(tmp_path, "a.ply")) == [[(0, 0, 0), (1 / 3, 0, 0), (0, 1, 0)]]


def own_arrays(**arrays):
    data = make_triangles()
    for name, values in arrays.items():
        array = vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        data.GetCellData().AddArray(array)
    return data


def test_vtp_brings_its_own_arrays_unless_a_material_is_given(tmp_path):
    write(tmp_path, "a.vtp", own_arrays(Reflectance=[0.1, 0.3], Exitance=[5, 0], Mirror=[0, 0.5]))
    data = read(tmp_path, "a.vtp", material=None)
    assert reflectances(data) == [0.1, 0.3]
    assert vtk_to_numpy(data.GetCellData().GetArray("Exitance")).tolist() == [5, 0]
    assert vtk_to_numpy(data.GetCellData().GetArray("Mirror")).tolist() == [0, 0.5]
    assert reflectances(read(tmp_path, "a.vtp")) == [0.7, 0.7]


@pytest.mark.parametrize("arrays, message", [
    ({"Reflectance": [0.1, float("nan")]}, "a.vtp: face 2: the reflectance is out of range; expected at least 0 and below 1"),
    ({"Reflectance": [1, 0]}, "a.vtp: face 1: the reflectance is out of range"),
    ({"Reflectance": [0.5, 0], "Specular": [-1, 0]}, "a.vtp: face 1: the specular or mirror reflectance is out of range"),
    ({"Reflectance": [0.5, 0], "Roughness": [0, 1]}, "a.vtp: face 1: the roughness is out of range"),
    ({"Reflectance": [0.5, 0], "Exitance": [0, -1]}, "a.vtp: face 2: the exitance is negative or not finite"),
    ({"Reflectance": [0.5, 0], "Mirror": [0.5, 0]}, "a.vtp: face 1: reflectance + specular + mirror reach 1"),
])
def test_vtp_arrays_out_of_range(tmp_path, arrays, message):
    write(tmp_path, "a.vtp", own_arrays(**arrays))
    assert error_of(tmp_path, "a.vtp", material=None).startswith(message)


def test_vtp_with_lines(tmp_path):
    data = make_triangles()
    lines = vtkCellArray()
    lines.InsertNextCell(2, (0, 1))
    data.SetLines(lines)
    write(tmp_path, "a.vtp", data)
    assert error_of(tmp_path, "a.vtp") == "a.vtp: cells: vertices, lines or strips; expected polygons only"


@pytest.mark.parametrize("text, message", [
    ("", "a.obj: file: no polygons; expected at least one"),
    ("v 0 0\n", "a.obj: line 1: a vertex without three numbers; expected v X Y Z"),
    (TRIANGLES + "f 1 2 5\n", "a.obj: line 5: a face corner '5'; expected a vertex number from 1 to 4"),
    (TRIANGLES + "f 1 2 0\n", "a.obj: line 5: a face corner '0'; expected a vertex number from 1 to 4"),
    (TRIANGLES + "f 1 2 -5\n", "a.obj: line 5: a face corner '-5'; expected a vertex number from 1 to 4"),
    (TRIANGLES + "f 1 2 3x\n", "a.obj: line 5: a face corner '3x'; expected a vertex number from 1 to 4"),
    (TRIANGLES + "f 1 2\n", "a.obj: file: none of the polygons has an area; expected at least one"),
    (TRIANGLES + "surf 0 1 0 1 1 2 3 4\n", "a.obj: line 5: a curved surface ('surf'); expected polygons"),
    (TRIANGLES + "corner 1 2\n", "a.obj: line 5: unknown statement 'corner'; expected v, f, usemtl"),
    ("\x00\xff\x01", "a.obj: line 1: unknown statement '???"),
    ("v 0 0 0\nv 1 1 1\nv 3 3 3\nf 1 2 3\n", "a.obj: file: none of the polygons has an area; expected at least one"),
    ("v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n", "a.obj: line 3: a vertex without three numbers"),
])
def test_obj_mistakes(tmp_path, text, message):
    (tmp_path / "a.obj").write_text(text, encoding="latin-1")
    assert error_of(tmp_path, "a.obj").startswith(message)


PLY = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")


@pytest.mark.parametrize("old, new, message", [
    ("ply\n", "plx\n", "a.ply: header: does not start with 'ply'; expected a PLY file"),
    ("format ascii 1.0\n", "", "a.ply: header: no format; expected ascii"),
    ("ascii", "roman", "a.ply: header: an unknown format; expected ascii, binary_little_endian or binary_big_endian"),
    ("end_header\n", "", "a.ply: header: an unknown statement; expected format, element"),
    ("vertex 3", "vertex -3", "a.ply: header: a damaged element line; expected element NAME COUNT"),
    ("float x", "fleet x", "a.ply: header: a damaged property line; expected property TYPE NAME"),
    ("list uchar", "list float", "a.ply: header: a damaged property line; expected property TYPE NAME"),
    ("end_header", "element u 5\nend_header", "a.ply: header: the element u has no properties; expected at least one"),
    (PLY[3:], "\n", "a.ply: header: ends within the header; expected end_header"),
    ("float z", "float w", "a.ply: vertex 1: vertices without x, y and z; expected all three"),
    ("vertex_indices", "corners", "a.ply: face 1: faces without the list vertex_indices; expected it"),
    ("3 0 1 2", "3 0 1", "a.ply: face 1: the file ends here; expected more numbers"),
    ("3 0 1 2", "3 0 a 2", "a.ply: face 1: 'a'; expected a number"),
    ("3 0 1 2", "-3 0 1 2", "a.ply: face 1: a list with a negative count; expected at least 0"),
    ("3 0 1 2", "2 0 1", "a.ply: file: none of the polygons has an area; expected at least one"),
    ("3 0 1 2", "3 0 1 3", "a.ply: face 1: a corner is point 3; expected one of the 3 points of the file"),
    ("3 0 1 2", "3 0 1 1", "a.ply: file: none of the polygons has an area; expected at least one"),
    ("face 1\nproperty list uchar int vertex_indices", "tristrips 1\nproperty list uchar int corners",
     "a.ply: tristrips 1: strips without the list vertex_indices; expected it"),
    ("0 1 0\n", "0 nan 0\n", "a.ply: face 1: a corner has a coordinate that is not finite; expected metres"),
    ("face 1", "face 0", "a.ply: file: no polygons; expected at least one"),
])
def test_ply_mistakes(tmp_path, old, new, message):
    assert old in PLY
    (tmp_path / "a.ply").write_text(PLY.replace(old, new))
    assert error_of(tmp_path, "a.ply").startswith(message)


def test_truncated_binary_ply(tmp_path):
    write(tmp_path, "a.ply", make_triangles())
    content = (tmp_path / "a.ply").read_bytes()
    (tmp_path / "a.ply").write_bytes(content[:-1])
    assert error_of(tmp_path, "a.ply") == "a.ply: face 2: the file ends here; expected more bytes"


@pytest.mark.parametrize("content, message", [
    (b"\x07garbage" * 40, "a.stl: file: no STL file, or damaged: 320 bytes; expected "),
    (b"", "a.stl: file: no STL file, or damaged: 0 bytes; expected at least 84, or text from solid to endsolid"),
    (b"solid a\n", "a.stl: file: no STL file, or the end is missing; expected solid ... endsolid"),
    (b"solid a\nfacet\nvertex 1 2\n", "a.stl: line 3: a vertex without three numbers; expected vertex X Y Z"),
    (b"solid a\nfacet\nvertex 1 2 3\nendfacet\n", "a.stl: line 4: a facet with 1 corners; expected three"),
    (b"solid a\nfacet\n" + b"vertex 1 2 3\n" * 4, "a.stl: line 6: a facet with more than three corners"),
    (b"solid a\nfaces\n", "a.stl: line 2: unknown statement 'faces'; expected facet, vertex or another"),
    (b"solid a\nendsolid\n", "a.stl: file: no polygons; expected at least one"),
])
def test_stl_mistakes(tmp_path, content, message):
    (tmp_path / "a.stl").write_bytes(content)
    assert error_of(tmp_path, "a.stl").startswith(message)


def test_truncated_binary_stl(tmp_path):
    write(tmp_path, "a.stl", make_triangles())
    content = (tmp_path / "a.stl").read_bytes()
    (tmp_path / "a.stl").write_bytes(content[:-1])
    assert error_of(tmp_path, "a.stl").startswith("a.stl: file: no STL file, or damaged: 183 bytes; expected 184")


def test_damaged_vtp(tmp_path):
    write(tmp_path, "a.vtp", make_triangles())
    content = (tmp_path / "a.vtp").read_bytes()
    for damaged in (content[:len(content) // 2], b"\x07garbage" * 40, b""):
        (tmp_path / "a.vtp").write_bytes(damaged)
        assert error_of(tmp_path, "a.vtp").startswith("a.vtp: file: cannot be read: ")


def test_a_name_that_is_nowhere_needs_a_material(tmp_path):
    (tmp_path / "a.obj").write_text(TRIANGLES + "usemtl blue\nf 1 2 3\n")
    assert error_of(tmp_path, "a.obj", material=None).startswith(
        "a.obj: usemtl blue: no such material in the scene; expected a name from")


OFF = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"


def test_off(tmp_path):
    (tmp_path / "a.off").write_text("\ufeffCOFF # colours\n\n4 1 0\n0 0 0 9 9 9 1\n1 0 0\n1 1 0\n# corner\n0 1 0.1234567890123\n4 0 1 2 3 1 0 0\n")
    assert polygons(read(tmp_path, "a.off")) == [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.1234567890123)]]


@pytest.mark.parametrize("old, new, message", [
    ("OFF\n", "", "a.off: line 1: no OFF header; expected the word OFF"),
    ("OFF\n", "4OFF\n", "a.off: line 1: points of four coordinates; expected three"),
    (OFF, "OFF\n", "a.off: line 1: the file ends here; expected the numbers of points and polygons"),
    ("4 1 0", "4 -1 0", "a.off: line 2: no numbers of points and polygons; expected two whole numbers"),
    ("1 0 0", "1 0", "a.off: line 4: a point without three numbers; expected X Y Z"),
    ("4 0 1 2 3", "x 0 1 2 3", "a.off: line 7: no number of corners; expected a whole number"),
    ("4 0 1 2 3", "4 0 1 2 4", "a.off: line 7: a corner '4'; expected 4 point numbers from 0 to 3"),
    ("4 0 1 2 3", "4 0 1 2", "a.off: line 7: a corner ''; expected 4 point numbers from 0 to 3"),
    ("4 0 1 2 3\n", "", "a.off: line 6: the file ends here; expected 1 more polygons"),
    ("0 1 0\n4 0 1 2 3\n", "", "a.off: line 5: the file ends here; expected 1 more points"),
])
def test_off_mistakes(tmp_path, old, new, message):
    assert old in OFF
    (tmp_path / "a.off").write_text(OFF.replace(old, new))
    assert error_of(tmp_path, "a.off").startswith(message)


def test_missing_and_unknown_files(tmp_path):
    assert error_of(tmp_path, "a.obj") == (
        "surfaces.mesh.file: no file a.obj; expected a mesh file, its path relative to the scene file")
    (tmp_path / "a.dwg").write_text("x")
    assert error_of(tmp_path, "a.dwg") == (
        "surfaces.mesh.file: unknown mesh format '.dwg'; expected .obj, .ply, .stl, .off or .vtp")
