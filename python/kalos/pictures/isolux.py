# SPDX-License-Identifier: BSD-3-Clause
"""Isolux lines of a flat receiver set: lines of equal illuminance as vtkPolyData, each with its level and label."""
import numpy as np
from matplotlib import patheffects
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkContourFilter, vtkDelaunay2D, vtkStripper

from kalos.core import arrays
from kalos.pictures.projection import flat_frame

LEVEL, LABEL = "IsoluxLevel", "IsoluxLabel"


def levels(values):
    """Multiples of a round step between the extremes, five to ten of them or so."""
    low, high = float(np.min(values, initial=np.inf)), float(np.max(values, initial=-np.inf))
    if not high > low:
        return []
    power = 10.0 ** np.floor(np.log10((high - low) / 5))
    step = max(s * power for s in (1, 2, 2.5, 5) if s * power <= (high - low) / 5)
    return [level for k in range(int(low / step), int(high / step) + 1) if low < (level := k * step) < high]


def isolux(receivers, at=None):
    """Lines through the receivers' places, linear between them; None when the set is not flat.

    Point arrays: Illuminance and IlluminanceStandardError, lx, the error interpolated like the value. Cell arrays: IsoluxLevel,
    lx, and IsoluxLabel. `at`: the levels, lx; round ones if None.
    """
    frame = flat_frame(receivers.points, receivers.normals) if len(receivers.points) > 2 else None
    if frame is None:
        return None
    surface = without_points(triangulated(receivers, frame), ~receivers.valid)
    append = vtkAppendPolyData()
    append.AddInputData(vtkPolyData())
    found = []
    for level in levels(receivers.illuminance[receivers.valid]) if at is None else at:
        contour = vtkContourFilter()
        contour.SetInputData(surface)
        contour.SetValue(0, level)
        contour.ComputeScalarsOn()
        strips = vtkStripper()
        strips.SetInputConnection(contour.GetOutputPort())
        strips.JoinContiguousSegmentsOn()
        strips.SetMaximumLength(1 << 20)
        strips.Update()
        count = strips.GetOutput().GetNumberOfLines()
        if count:
            append.AddInputData(strips.GetOutput())
            found += [level] * count
    append.Update()
    lines = vtkPolyData()
    lines.ShallowCopy(append.GetOutput())
    numbers = numpy_to_vtk(np.array(found, float), deep=True)
    numbers.SetName(LEVEL)
    labels = vtkStringArray()
    labels.SetName(LABEL)
    for level in found:
        labels.InsertNextValue(f"{level:g} lx")
    lines.GetCellData().AddArray(numbers)
    lines.GetCellData().AddArray(labels)
    return lines


def triangulated(receivers, frame):
    """The receivers' places as a triangle mesh with their values; Delaunay's, in the receivers' plane."""
    flat = np.column_stack([frame.project(receivers.points), np.zeros(len(receivers.points))])
    places, cloud = vtkPoints(), vtkPolyData()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(flat), deep=True))
    cloud.SetPoints(places)
    for name, values in ((arrays.ILLUMINANCE, receivers.illuminance), (arrays.ILLUMINANCE_STANDARD_ERROR, receivers.standard_error)):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    cloud.GetPointData().SetActiveScalars(arrays.ILLUMINANCE)
    delaunay = vtkDelaunay2D()
    delaunay.SetInputData(cloud)
    delaunay.Update()
    mesh = vtkPolyData()
    mesh.ShallowCopy(delaunay.GetOutput())
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(np.ascontiguousarray(receivers.points), deep=True))
    mesh.SetPoints(corners)
    return mesh


def without_points(mesh, gone):
    """A triangle mesh without the triangles that have a corner among the points `gone`."""
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    kept = np.ascontiguousarray(corners[~gone[corners].any(axis=1)])
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtk(kept.ravel(), deep=True))
    mesh.SetPolys(cells)
    return mesh


def polylines(lines):
    """(level, label, points (n, 3)) of every line."""
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float) if lines.GetNumberOfPoints() else np.empty((0, 3))
    cells = lines.GetLines()
    if cells.GetNumberOfCells() == 0:
        return []
    ends, corners = vtk_to_numpy(cells.GetOffsetsArray()), vtk_to_numpy(cells.GetConnectivityArray())
    level, label = lines.GetCellData().GetArray(LEVEL), lines.GetCellData().GetAbstractArray(LABEL)
    return [(level.GetValue(i), label.GetValue(i), points[corners[ends[i]:ends[i + 1]]]) for i in range(len(ends) - 1)]


def draw_isolux(axes, lines, frame):
    """White lines with dark rims, so that they show on every colour; labels where a long line leaves room for one."""
    rim = [patheffects.withStroke(linewidth=2.4, foreground="0.15")]
    found = [(label, frame.project(points)) for _, label, points in polylines(lines)]
    lengths = [np.linalg.norm(np.diff(points, axis=0), axis=1).sum() for _, points in found]
    low, high = axes.dataLim.get_points()
    size, placed = max(high - low), []
    for k in np.argsort(lengths)[::-1]:
        label, points = found[k]
        axes.plot(points[:, 0], points[:, 1], color="white", linewidth=0.9, path_effects=rim)
        if lengths[k] < 0.1 * size:
            continue
        for share in (0.5, 0.25, 0.75, 0.1, 0.9):
            at = points[int(share * (len(points) - 1))]
            if all(np.linalg.norm((at - other) / (high - low)) > 0.06 for other in placed):
                placed.append(at)
                axes.text(*at, label.removesuffix(" lx"), fontsize=7, color="white", ha="center", va="center",
                          path_effects=rim, clip_on=True)
                break
