# SPDX-License-Identifier: BSD-3-Clause
"""Mesh files in whatever state, as vtkPolyData to repair. Scene files read their meshes elsewhere and refuse bad ones."""
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from kalos.core import arrays
from kalos.errors import KalosError, update
from kalos.vtk import vtkKalosSceneReader


def read_mesh(path):
    """The surface in a mesh file, by the suffix of its name."""
    path = Path(path)
    read = READERS.get(path.suffix.lower())
    if not read:
        raise KalosError(f"{path}: name: unknown format {path.suffix!r}, expected {', '.join(sorted(READERS))}")
    if not path.is_file():
        raise KalosError(f"{path}: file: is not there, expected a mesh file")
    try:
        mesh = read(path)
    except UnicodeDecodeError:
        raise KalosError(f"{path}: file: not text, expected a text file of its format") from None
    except OSError as error:
        raise KalosError(f"{path}: file: cannot be read ({error.strerror}), expected a mesh file") from None
    if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        raise KalosError(f"{path}: file: no polygons, expected at least one")
    return mesh


def poly_data(points, polygons):
    """Polygons as lists of point numbers."""
    mesh = vtkPolyData()
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(np.asarray(points, float).reshape(-1, 3), deep=True))
    offsets = np.cumsum([0] + [len(polygon) for polygon in polygons])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.array([i for polygon in polygons for i in polygon], np.int64), deep=True))
    mesh.SetPoints(corners)
    mesh.SetPolys(cells)
    return mesh


def add_names(mesh, ids, names, id_array, name_array):
    """A number per cell, and what the numbers stand for."""
    numbers = numpy_to_vtk(np.asarray(ids, np.int32), deep=True)
    numbers.SetName(id_array)
    mesh.GetCellData().AddArray(numbers)
    strings = vtkStringArray()
    strings.SetName(name_array)
    for name in names:
        strings.InsertNextValue(name)
    mesh.GetFieldData().AddArray(strings)


def numbers_of(words, kind, path, line, expected):
    try:
        return [kind(word) for word in words]
    except ValueError:
        raise KalosError(f"{path}: line {line}: {' '.join(words)[:60]!r} is not allowed, expected {expected}") from None


def read_obj(path):
    """Points, polygons and usemtl; VTK's reader gives materials to the wrong faces and keeps single precision only."""
    points, polygons, material, names = [], [], [], {}
    current = ""
    with open(path, encoding="utf-8", errors="replace") as file:  # comments come in any encoding
        for line, text in enumerate(file, 1):
            words = text.split("#", 1)[0].split()
            if not words:
                continue
            if words[0] == "v":
                points.append(numbers_of(words[1:4], float, path, line, "three coordinates"))
                if len(points[-1]) != 3:
                    raise KalosError(f"{path}: line {line}: {len(points[-1])} coordinates, expected three")
            elif words[0] == "f":
                corners = numbers_of([word.split("/")[0] for word in words[1:]], int, path, line, "point numbers")
                corners = [i - 1 if i > 0 else len(points) + i for i in corners]
                if not all(0 <= i < len(points) for i in corners):
                    raise KalosError(f"{path}: line {line}: a point that is not there, expected 1 to {len(points)}")
                polygons.append(corners)
                material.append(names.setdefault(current, len(names)))
            elif words[0] == "usemtl":
                current = " ".join(words[1:])
    mesh = poly_data(points, polygons)
    add_names(mesh, material, names, "MaterialIds", "MaterialNames")
    return mesh


def read_off(path):
    """Object File Format: points and polygons; colours are passed over."""
    with open(path, encoding="utf-8") as file:
        lines = [(number, words) for number, text in enumerate(file, 1) if (words := text.split("#", 1)[0].split())]
    if not lines or not lines[0][1][0].endswith("OFF"):
        raise KalosError(f"{path}: line 1: no OFF header, expected the word OFF")
    if len(lines[0][1]) > 1:
        lines[0][1].pop(0)
    else:
        lines.pop(0)
    counts = numbers_of(lines[0][1][:2], int, path, lines[0][0], "the counts of points and polygons") if lines else []
    if len(counts) != 2 or min(counts) < 0 or len(lines) < 1 + sum(counts):
        raise KalosError(f"{path}: line {lines[0][0] if lines else 1}: the counts do not fit the file, expected the "
                         f"numbers of points and polygons that follow")
    points, polygons = [], []
    for line, words in lines[1:1 + counts[0]]:
        points.append(numbers_of(words[:3], float, path, line, "three coordinates"))
        if len(points[-1]) != 3:
            raise KalosError(f"{path}: line {line}: {len(points[-1])} coordinates, expected three")
    for line, words in lines[1 + counts[0]:1 + sum(counts)]:
        size, = numbers_of(words[:1], int, path, line, "a number of corners")
        corners = numbers_of(words[1:1 + size], int, path, line, "point numbers")
        if len(corners) != size or not all(0 <= i < len(points) for i in corners):
            raise KalosError(f"{path}: line {line}: expected {size} point numbers from 0 to {len(points) - 1}")
        polygons.append(corners)
    return poly_data(points, polygons)


def by_vtk(module, name):
    """A reader of VTK, imported when it is needed."""

    def read(path):
        import importlib

        try:
            reader = getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
        except (ImportError, AttributeError):
            raise KalosError(f"{path}: name: this VTK has no {name}, expected another format") from None
        reader.SetFileName(str(path))
        try:
            update(reader)
        except KalosError as error:
            raise KalosError(f"{path}: file: {str(error).splitlines()[0]}; expected an undamaged file") from None
        return joined(reader.GetOutputDataObject(0))

    return read


def read_gltf(path):
    """By the reader of scenes, which checks what VTK's crashes on; its parts are in SurfaceId."""
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(path))
    update(reader)
    return reader.GetSurfaces()


def read_ply(path):
    """By VTK, after a look at the header: VTK's reader crashes on lists among the points' properties."""
    elements = []
    with open(path, "rb") as file:
        for line, raw in enumerate(file, 1):
            words = raw.decode("latin-1").split()
            if line == 1 and words != ["ply"]:
                raise KalosError(f"{path}: line 1: no PLY header, expected the word ply")
            if words[:1] == ["end_header"]:
                break
            if words[:1] == ["element"]:
                elements.append(words[1] if len(words) > 1 else "")
                count, = numbers_of(words[2:3] or ["nothing"], int, path, line, "the number of them")
                if not 0 <= count <= path.stat().st_size:  # VTK's reader allocates what it is told
                    raise KalosError(f"{path}: line {line}: {count} do not fit into the file, expected the number that follow")
            elif words[:2] == ["property", "list"] and elements[-1:] == ["vertex"]:
                raise KalosError(f"{path}: line {line}: a list among the properties of points, expected it after element face")
        else:
            raise KalosError(f"{path}: header: not closed, expected the word end_header")
    if "vertex" not in elements or "face" not in elements:
        raise KalosError(f"{path}: header: no points or no polygons, expected element vertex and element face")
    return by_vtk("vtkIOPLY", "vtkPLYReader")(path)


def joined(data):
    """The surfaces of a composite as one, each with its number in SurfaceId."""
    if data.IsA("vtkPolyData"):
        return data
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData

    append = vtkAppendPolyData()
    items = data.NewIterator()
    items.InitTraversal()
    count = 0
    while not items.IsDoneWithTraversal():
        leaf = items.GetCurrentDataObject()
        if leaf.IsA("vtkPolyData") and leaf.GetNumberOfCells():
            part = vtkPolyData()
            part.CopyStructure(leaf)
            ids = numpy_to_vtk(np.full(leaf.GetNumberOfCells(), count, np.int32), deep=True)
            ids.SetName(arrays.SURFACE_ID)
            part.GetCellData().AddArray(ids)
            append.AddInputData(part)
            count += 1
        items.GoToNextItem()
    if not count:
        return vtkPolyData()
    update(append)
    mesh = append.GetOutput()
    names = vtkStringArray()
    names.SetName(arrays.SURFACE_NAMES)
    for i in range(count):
        names.InsertNextValue(f"part {i + 1}")
    mesh.GetFieldData().AddArray(names)
    return mesh


READERS = {".obj": read_obj, ".off": read_off, ".ply": read_ply,
           ".stl": by_vtk("vtkIOGeometry", "vtkSTLReader"), ".vtp": by_vtk("vtkIOXML", "vtkXMLPolyDataReader"),
           ".gltf": read_gltf, ".glb": read_gltf}
