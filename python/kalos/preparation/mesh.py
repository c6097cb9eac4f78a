# SPDX-License-Identifier: BSD-3-Clause
"""Mesh preparation: repair, remesh if a length is wanted, and say where estimates will be singular."""
import json
import math
import os
import tempfile
from pathlib import Path

from kalos.core.output import write_vtp
from kalos.core.progress import run
from kalos.errors import KalosError
from kalos.preparation.mesh_readers import read_mesh
from kalos.vtk import vtkKalosSingularEdges, vtkKalosSurfaceRemesh, vtkKalosSurfaceRepair

EDGE_CLASSES = {"concave": "CONCAVE", "contact": "CONTACT", "non-manifold": "NON_MANIFOLD"}


def prepare(path, out, edge_length=None, report=None, say=None, time_limit=None):
    """Reads a mesh file, writes the prepared surface to `out` (.vtp) and what was done to `report` (JSON).

    Each of repair, remeshing and the search for edges is given up after `time_limit` seconds, if not those of the filters.
    """
    if Path(out).suffix.lower() != ".vtp":
        raise KalosError(f"{out}: --out: not a .vtp file, expected a name that ends in .vtp")
    mesh = read_mesh(path)

    repair = vtkKalosSurfaceRepair()
    repair.SetInputData(mesh)
    if time_limit:
        repair.SetTimeLimit(time_limit)
    surface = of_file(path, repair, "repair")
    facts = {"input": str(path), "output": str(out), "repair": table(repair.GetReport()), "unrepaired": unrepaired(surface)}
    last = repair
    if edge_length:
        last = vtkKalosSurfaceRemesh()
        last.SetInputData(surface)
        last.SetEdgeLength(edge_length)
        last.SetTimeLimit(repair.GetTimeLimit())
        of_file(path, last, "remesh")
        facts["remesh"] = table(last.GetReport())
    edges = vtkKalosSingularEdges()
    edges.SetInputConnection(last.GetOutputPort())
    edges.SetTimeLimit(repair.GetTimeLimit())
    of_file(path, edges, "singular edges")
    facts["singular_edges"] = {name: lengths(edges.GetOutput(), getattr(edges, value)) for name, value in EDGE_CLASSES.items()}
    facts["edges"] = table(edges.GetReport())

    write(out, "--out", lambda name: write_vtp(name, last.GetOutputDataObject(0)))
    if report:
        text = json.dumps(facts, indent=2, ensure_ascii=False) + "\n"
        write(report, "--report", lambda name: Path(name).write_text(text, encoding="utf-8"))
    if say:
        for line in sentences(facts):
            say(line)
    return facts


def of_file(path, algorithm, label, patience=0):
    """The output of a filter; its errors name the file."""
    try:
        return run(algorithm, label, patience=patience)
    except KalosError as error:
        text = str(error)
        raise KalosError(text if text.startswith("stopped") else f"{path}: mesh: {text}", error.status) from None


def table(report):
    """A filter's report: quantity and value."""
    columns = [report.GetColumnByName(name) for name in ("Quantity", "Unit", "Value")]
    facts = {}
    for row in range(report.GetNumberOfRows()):
        quantity, unit, value = (column.GetValue(row) for column in columns)
        facts[f"{quantity}, {unit}" if unit else quantity] = int(value) if not unit and value == int(value) else value
    return facts


def unrepaired(surface):
    names = surface.GetFieldData().GetAbstractArray(vtkKalosSurfaceRepair.UnrepairedArrayName())
    return [{"cell": int(names.GetValue(2 * i)), "reason": names.GetValue(2 * i + 1)} for i in range(names.GetNumberOfTuples())]


def lengths(curves, edge_class):
    """Number and total length (m) of the curves of a class."""
    kinds = curves.GetCellData().GetArray(vtkKalosSingularEdges.EdgeClassArrayName())
    count, total = 0, 0.0
    for i in range(curves.GetNumberOfCells()):
        if kinds.GetValue(i) != edge_class:
            continue
        points = curves.GetCell(i).GetPoints()
        corners = [points.GetPoint(k) for k in range(points.GetNumberOfPoints())]
        total += sum(map(math.dist, corners, corners[1:]))
        count += 1
    return {"curves": count, "length_m": total}


def sentences(facts):
    done = facts["repair"]
    yield (f"repair: {done['triangles before']} triangles to {done['triangles after']}; {done['points merged']} points merged, "
           f"{done['degenerate triangles dropped']} degenerate and {done['duplicate triangles dropped']} duplicate triangles "
           f"dropped, {done['triangles cut to stitch']} cut, {done['triangles turned']} turned; "
           f"{done['border edges after']} border edges left")
    if facts["unrepaired"]:
        yield f"not repaired: {len(facts['unrepaired'])} cells; the first is cell {facts['unrepaired'][0]['cell']}: " \
              f"{facts['unrepaired'][0]['reason']}"
    if "remesh" in facts:
        done = facts["remesh"]
        yield (f"remesh: {done['triangles after']} triangles, smallest angle {done['smallest angle, degrees']:.0f} degrees, "
               f"mean edge {done['mean edge, m']:.4g} m")
    yield "singular edges: " + ", ".join(f"{found['curves']} {name} ({found['length_m']:.4g} m)"
                                         for name, found in facts["singular_edges"].items())


def write(path, option, save):
    """A file that is whole or not there."""
    path = Path(path)
    name = None
    try:
        handle, name = tempfile.mkstemp(prefix=".kalos-", suffix=path.suffix, dir=path.parent)
        os.close(handle)
        save(name)
        os.chmod(name, 0o644)
        os.replace(name, path)
    except OSError as error:
        raise KalosError(f"{path}: {option}: cannot be written ({error.strerror}), expected a file in a folder that is there") \
            from None
    finally:
        if name and os.path.exists(name):
            os.unlink(name)
