#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A furnished room, prepared: where the kernel turns singular, by severity, and where furniture only touches.

    PYTHONPATH=build/python examples/mesh_preparation.py OUT

writes OUT/mesh-preparation.png and prints what was found. The room is a soup: every polygon has corners of its own; a
desk and a cupboard stand on the floor, a case on the cupboard, and a board leans against the wall at 60 degrees. Concave edges
are solid blue lines, contacts dashed orange ones, the darker the severer;
what furniture hides is drawn thin, and so are the edges between walls that one looks through.
"""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Iterator, List, Sequence

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.pictures.axonometry import TO_VIEWER, paper
from kalos.preparation.mesh_readers import poly_data
from kalos.vtk import vtkKalosSingularEdges, vtkKalosSurfaceRepair

Polygons = List[List[NDArray[np.float64]]]  # corners of each, m
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]  # of a box, outwards
EDGES = LinearSegmentedColormap.from_list("edges", ["#9ec4e8", "#08386e"])
CONTACTS = LinearSegmentedColormap.from_list("contacts", ["#f6b98a", "#a33a05"])
MILDEST, SEVEREST = 0.05, 5.0
PIECE = 0.02  # m, of a line that is hidden or not as a whole
VIEWER = TO_VIEWER / np.linalg.norm(TO_VIEWER)


def box(base: ArrayLike, size: Sequence[float], degrees: float, inwards: bool = False) -> Polygons:
    """The six faces of a box whose bottom's centre is at `base`, turned about the vertical."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    u, v, w = np.array([c, s, 0]) * size[0], np.array([-s, c, 0]) * size[1], np.array([0, 0, size[2]])
    corner = np.asarray(base) - 0.5 * (u + v)
    points = [corner + (k & 1) * u + (k >> 1 & 1) * v + (k >> 2) * w for k in range(8)]
    return [[points[i] for i in (side[::-1] if inwards else side)] for side in SIDES]


def furnished_room() -> Polygons:
    """Room of 4 m x 4 m x 2.6 m with a desk, a cupboard, a case on it, and a leaning board."""
    polygons = box((2, 2, 0), (4, 4, 2.6), 0, inwards=True)
    polygons += box((1.25, 1.3, 0), (1.4, 0.7, 0.72), 12) + box((3.0, 2.6, 0), (0.9, 0.8, 1.0), -20)
    polygons += box((3.0, 2.62, 1.0), (0.5, 0.45, 0.4), 15)
    # The board stands on an edge and touches the wall with another.
    along, out = np.array([0, 0.5, 0.75**0.5]), np.array([0, -(0.75**0.5), 0.5])
    foot, wide, length, thick = np.array([0.4, 3.3, 0]), np.array([1.3, 0, 0]), 1.4, 0.05
    points = [foot + (k & 1) * wide + (k >> 1 & 1) * length * along + (k >> 2) * thick * out for k in range(8)]
    return polygons + [[points[i] for i in side] for side in SIDES]


def prepare(polygons: Polygons) -> tuple[vtkPolyData, vtkPolyData]:
    """The repaired surface and its singular edges."""
    corners = [point for polygon in polygons for point in polygon]
    numbers = iter(range(len(corners)))
    repair = vtkKalosSurfaceRepair()
    repair.SetInputData(poly_data(corners, [[next(numbers) for _ in polygon] for polygon in polygons]))
    edges = vtkKalosSingularEdges()
    edges.SetInputConnection(repair.GetOutputPort())
    edges.Update()
    return repair.GetOutput(), edges.GetOutput()


def curves_of(edges: vtkPolyData) -> Iterator[tuple[NDArray[np.float64], bool, float]]:
    """Corners, whether it is a contact, and severity of each curve."""
    data = edges.GetCellData()
    for i in range(edges.GetNumberOfCells()):
        line = np.array(vtk_to_numpy(edges.GetCell(i).GetPoints().GetData()))  # the cell is overwritten by the next
        contact = data.GetArray("EdgeClass").GetValue(i) == vtkKalosSingularEdges.CONTACT
        yield line, contact, data.GetArray("Severity").GetValue(i)


def seen_triangles(surface: vtkPolyData) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Triangles that show their front, far ones first, their normals, and whether they are of the room itself."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    seen = np.flatnonzero(normals @ VIEWER > 1e-9)
    # The room's own walls are the farthest, whatever their size.
    outside = np.array([np.isin(np.round(t, 9), (0, 4, 2.6)).all(axis=0).any() for t in triangles[seen]])
    order = np.lexsort((triangles[seen].mean(axis=1) @ VIEWER, ~outside))
    return triangles[seen][order], normals[seen][order], outside[order]


def hidden(points: NDArray[np.float64], triangles: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether a triangle stands between a point and the viewer (Moeller and Trumbore)."""
    a, u, v = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    p = np.cross(VIEWER, v)
    inverse = 1 / np.einsum("ij,ij->i", u, p)
    offset = points[:, None] - a
    s = np.einsum("kij,ij->ki", offset, p) * inverse
    q = np.cross(offset, u)
    t = (q @ VIEWER) * inverse
    far = np.einsum("kij,ij->ki", q, v) * inverse
    inside: NDArray[np.bool_] = (s > 1e-9) & (t > 1e-9) & (s + t < 1 - 1e-9) & (far > 1e-3)
    return np.asarray(inside.any(axis=1))


def facing_away(line: NDArray[np.float64]) -> bool:
    """Whether the line joins two walls that one looks through: those at x = 4, y = 0 and the ceiling."""
    return sum(bool(np.all(np.abs(line[:, axis] - place) < 1e-9)) for axis, place in ((0, 4), (1, 0), (2, 2.6))) == 2


def pieces(line: NDArray[np.float64], triangles: NDArray[np.float64]) -> Iterator[tuple[NDArray[np.float64], bool]]:
    """The curve on paper, as pieces that are seen and pieces that are not."""
    count = max(1, int(np.linalg.norm(line[-1] - line[0]) / PIECE))
    steps = line[0] + np.linspace(0, 1, count + 1)[:, None] * (line[-1] - line[0])
    covered = hidden(0.5 * (steps[1:] + steps[:-1]) + 1e-3 * VIEWER, triangles)
    bounds = np.flatnonzero(np.diff(covered)) + 1
    for first, last in zip([0, *bounds], [*bounds, count]):
        yield paper(steps[[first, last]], VIEWER), bool(covered[first])


def draw(surface: vtkPolyData, edges: vtkPolyData, path: Path) -> dict[bool, list[float]]:
    triangles, normals, walls = seen_triangles(surface)
    figure = Figure(figsize=(8.4, 6.2), dpi=150)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.01, 0.02, 0.80, 0.86))
    light = np.where(walls, 0.90, 0.74) + np.where(walls, 0.08, 0.14) * (normals @ np.array([0.2, -0.35, 0.9]))
    axes.add_collection(PolyCollection([paper(t, VIEWER) for t in triangles], facecolors=np.clip(light, 0, 0.985)[:, None].repeat(3, 1),
                                       edgecolors="face", linewidth=0.4))
    norm = LogNorm(MILDEST, SEVEREST)
    found = {False: [0, 0.0], True: [0, 0.0]}
    for line, contact, severity in sorted(curves_of(edges), key=lambda curve: curve[2]):
        found[contact][0] += 1
        found[contact][1] += float(np.linalg.norm(line[-1] - line[0]))
        colour = (CONTACTS if contact else EDGES)(norm(severity))
        near = facing_away(line)
        for ends, covered in pieces(line, triangles):
            thin = covered or near
            axes.plot(*ends.T, color=colour, linewidth=0.7 if thin else 2.2, alpha=0.6 if thin else 1,
                      linestyle=(0, (3.2, 1.4)) if contact else "-", solid_capstyle="round", dash_capstyle="butt")
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()
    figure.text(0.03, 0.955, "Where local estimates turn singular", fontsize=14)
    figure.text(0.03, 0.915, "; ".join(f"{found[c][0]} {'contacts' if c else 'concave edges'}, {found[c][1]:.1f} m" for c in (False, True)),
                fontsize=10, color="0.35")
    for left, colours, label, style in ((0.845, EDGES, "concave edges", "-"), (0.915, CONTACTS, "contacts", (0, (3.2, 1.4)))):
        bar = figure.colorbar(ScalarMappable(norm, colours), cax=figure.add_axes((left, 0.2, 0.018, 0.55)))
        bar.outline.set_visible(False)
        bar.ax.tick_params(labelsize=8, color="0.5", labelcolor="0.25")
        bar.ax.minorticks_off()
        bar.set_ticks([0.05, 0.25, 1, 5], labels=["0.05", "0.25", "1", "5"] if colours is CONTACTS else ["", "", "", ""])
        figure.add_artist(Line2D([left, left + 0.018], [0.165, 0.165], color=colours(0.75), linewidth=2.2, linestyle=style))
        figure.text(left + 0.009, 0.145, label, fontsize=8.5, ha="center", va="top", rotation=90, color="0.25")
    figure.text(0.83, 0.775, "severity cot²(α/2)/4;\n0.25 is a right angle", fontsize=8.5, color="0.25")
    figure.savefig(path, metadata={"Software": None})
    return found


def main(folder: str | Path) -> None:
    Path(folder).mkdir(parents=True, exist_ok=True)
    found = draw(*prepare(furnished_room()), Path(folder) / "mesh-preparation.png")
    for contact, (count, length) in found.items():
        print(f"{count} {'contacts' if contact else 'concave edges'}, {length:.3f} m")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: mesh_preparation.py OUT")
    main(sys.argv[1])
