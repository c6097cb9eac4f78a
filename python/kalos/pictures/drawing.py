# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results in false colour, each with a legend in lx or cd/m2, drawn without a screen or OpenGL.

A flat receiver set becomes a map in metres, single points a chart with error bars, any other surface an axonometric
drawing, a camera an image.
"""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.pictures.axonometry import draw_axonometry, seen_cells
from kalos.pictures.isolux import draw_isolux, isolux, levels
from kalos.pictures.look import LOOK
from kalos.pictures.projection import flat_frame
from kalos.pictures.scale import colour_bar, colour_scale
from kalos.results.fields import provenance
from kalos.results.statistics import image_statistics
from kalos.results.text import number

WIDTH, HEIGHT, DPI = 7.2, 6.0, 150  # inches, inches, pixels an inch
GREY = "0.35"
SERIES = "#0b5d8f"
DIRECT = "#c2571a"


def draw_receivers(path, receivers, look=LOOK):
    """The picture that suits the receiver set, as PNG."""
    title = f"{receivers.name}: illuminance"
    values, figures = shown(receivers.illuminance, receivers.valid), receivers.statistics()
    if not receivers.cells:
        draw_chart(path, title, receivers)
        return
    polygons = [cell_points(receivers.dataset, i) for i in range(receivers.dataset.GetNumberOfCells())]
    figure, axes = sheet(title, facts(figures, "lx"))
    frame = flat_frame(receivers.points, receivers.normals)
    if frame:
        scale = colour_scale(values, look.illuminance, look)
        draw_map(axes, polygons, values, scale, frame)
        if look.isolines:
            draw_isolux(axes, isolux(receivers), frame)
    else:
        seen = seen_cells(polygons, receivers.normals)
        scale = colour_scale(values[seen] if len(seen) else values, look.illuminance, look)
        draw_axonometry(axes, polygons, values, seen, scale)
    colour_bar(axes, scale, "illuminance, lx")
    save(figure, path, receivers.dataset)


def shown(values, valid):
    """Values without those that statistics leave out, which pictures show in grey."""
    return np.ma.masked_array(values, ~valid)


def draw_image(path, name, image, look=LOOK):
    """What a camera sees, as PNG."""
    columns, rows, _ = image.GetDimensions()
    luminance = vtk_to_numpy(image.GetPointData().GetArray(arrays.LUMINANCE)).reshape(rows, columns)
    figure, axes = sheet(f"{name}: luminance", facts(image_statistics(image), "cd/m²"))
    scale = colour_scale(luminance, look.luminance, look)
    axes.imshow(luminance, origin="lower", cmap=scale.colours, norm=scale.norm, interpolation="nearest")
    if look.isolines and levels(luminance):
        lines = axes.contour(luminance, levels=levels(luminance), colors="white", linewidths=0.9)
        axes.clabel(lines, fmt="%g", fontsize=7)
    axes.set_axis_off()
    colour_bar(axes, scale, "luminance, cd/m²")
    save(figure, path, image)


def draw_map(axes, polygons, values, scale, frame):
    """Cells seen at right angles, axes in metres."""
    cells = PolyCollection([frame.project(p) for p in polygons], array=values, cmap=scale.colours, norm=scale.norm,
                           antialiased=False, linewidth=0)
    axes.add_collection(cells)
    axes.autoscale_view()
    axes.margins(0)
    axes.set_aspect("equal")
    axes.set_xlabel(frame.right_label)
    axes.set_ylabel(frame.up_label)
    if frame.right_inverted:
        axes.invert_xaxis()


def draw_chart(path, title, receivers):
    """Values at single points with bars of two standard errors; along a straight line, over the distance."""
    figure, axes = sheet(title, facts(receivers.statistics(), "lx"))
    along, label = abscissa(receivers.points)
    axes.errorbar(along, receivers.illuminance, yerr=2 * receivers.standard_error, fmt="o", markersize=4, capsize=3,
                  linewidth=1, color=SERIES, label="illuminance, ± 2 standard errors")
    axes.plot(along, receivers.direct, "x", markersize=5, color=DIRECT, label="direct part")
    axes.set_xlabel(label)
    axes.set_ylabel("illuminance, lx")
    axes.set_ylim(bottom=0, top=1.15 * max(float(np.max(receivers.illuminance + 2 * receivers.standard_error)), 1e-300))
    axes.grid(True, color="0.9")
    axes.set_axisbelow(True)
    axes.legend(loc="upper right", frameon=False, ncol=2, fontsize=9)
    save(figure, path, receivers.dataset)


def abscissa(points):
    """Positions of points on the axis of a chart, and the label of that axis."""
    offset = points - points[0]
    farthest = offset[np.argmax(np.linalg.norm(offset, axis=1))]
    length = np.linalg.norm(farthest)
    if length > 0:
        along = offset @ (farthest / length)
        if np.linalg.norm(offset - np.outer(along, farthest / length), axis=1).max() < 1e-9 * length:
            return along, "distance from the first point, m"
    return np.arange(len(points)), "number of the receiver in the table, from 0"


def cell_points(dataset, index):
    points = dataset.GetCell(index).GetPoints()
    return vtk_to_numpy(points.GetData()).astype(float)


def facts(figures, unit):
    """The line under the title."""
    mean, low, high = (number(figures[key]) for key in ("mean", "min", "max"))
    line = f"mean {mean} {unit}, min {low}, max {high}"
    if figures.get("U0") is not None:
        line += f", U0 {figures['U0']:.2f}"
    if figures.get("left_out"):
        line += f"; {figures['left_out']} of {figures['points']} points left out"
    worst = figures["largest_relative_standard_error"]
    return line if worst is None else line + f"; largest standard error {100 * worst:.2g} %"


def sheet(title, subtitle):
    """An empty figure with title and subtitle, and its axes."""
    figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DPI)
    FigureCanvasAgg(figure)
    axes = figure.add_axes((0.1, 0.1, 0.75, 0.78))
    axes.set_title(title, loc="left", fontsize=13, pad=24)
    axes.annotate(subtitle, (0, 1), xytext=(0, 9), xycoords="axes fraction", textcoords="offset points", fontsize=9, color=GREY)
    return figure, axes


def save(figure, path, dataset):
    """Writes the picture; its text chunks say what made the result that it shows."""
    version, seed = provenance(dataset)
    stamp = {"Software": version and f"kalos {version}", **({} if seed is None else {"Comment": f"seed {seed}"})}
    figure.savefig(path, format="png", bbox_inches="tight", pad_inches=0.15, metadata=stamp)
