# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of photometric files: the polar curves that lighting people read, and the photometric solid."""
import math
import os
from typing import Any, Union

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.errors import update
from kalos.pictures.colours import false_colours
from kalos.pictures.scale import round_up
from kalos.results.text import number
from kalos.vtk import vtkKalosPhotometryReader

LINES = (("C 0 - 180", "#0b5d8f", "-"), ("C 90 - 270", "#c2571a", "--"))
GREY = "0.35"


def read_photometry(path: Union[str, "os.PathLike[str]"], lamp_set: int = 1) -> Any:
    """A vtkKalosPhotometryReader that has read the file; raises KalosError."""
    reader = vtkKalosPhotometryReader()
    reader.SetFileName(os.fspath(path))
    reader.SetLampSet(lamp_set)
    update(reader)
    return reader


def facts(reader: Any) -> str:
    """One line: flux, largest intensity, opening."""
    sizes = [size for size in (reader.GetOpeningAlongC0(), reader.GetOpeningAlongC90()) if size > 0]
    if not sizes:
        opening = "a point"
    elif reader.GetOpeningIsRound():
        opening = f"round opening of {1000 * sizes[0]:.0f} mm"
    else:
        opening = f"opening {' x '.join(f'{1000 * size:.0f}' for size in sizes)} mm"
    return f"{number(reader.GetTableFlux())} lm, at most {number(reader.GetLargestIntensity())} cd, {opening}"


def draw_photometry(path: Any, reader: Any) -> None:
    """Both pictures side by side, as PNG."""
    figure = Figure(figsize=(10.5, 5.2), dpi=150)
    FigureCanvasAgg(figure)
    figure.text(0.03, 0.95, reader.GetLuminaireName() or os.path.basename(reader.GetFileName()), fontsize=13)
    figure.text(0.03, 0.905, f"{reader.GetFormat()}: {facts(reader)}", fontsize=9, color=GREY)
    draw_polar(figure.add_axes((0.03, 0.03, 0.46, 0.77)), reader)
    draw_solid(figure.add_axes((0.5, 0.0, 0.48, 0.9), projection="3d"), reader)
    figure.savefig(path, format="png", metadata={"Software": None})


def draw_polar(axes: Any, reader: Any) -> None:
    """The polar curves: 0 deg is down, angles to both sides, circles in cd."""
    top = round_up(reader.GetLargestIntensity())
    curves = reader.GetOutputDataObject(2)
    cd = vtk_to_numpy(curves.GetPointData().GetArray(arrays.INTENSITY)).reshape(2, -1)
    angles = np.radians(np.linspace(-180, 180, cd.shape[1]))
    upward = cd[:, np.abs(angles) > math.pi / 2 + 1e-9].max(initial=0) > 0
    last = 180 if upward else 90
    draw_polar_grid(axes, top, last)
    for (label, colour, style), values in zip(LINES, cd):
        x, y = values * np.sin(angles), -values * np.cos(angles)
        axes.fill(x, y, color=colour, alpha=0.08, linewidth=0)
        axes.plot(x, y, style, color=colour, label=label, linewidth=1.6)
    axes.set_xlim(-1.12 * top, 1.12 * top)
    axes.set_ylim(-1.12 * top, (1.12 if upward else 0.12) * top)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2, frameon=False, fontsize=9)


def draw_polar_grid(axes, top, last):
    """Quarter circles of intensity up to `top`, rays every 30 deg up to `last` on both sides, with their numbers."""
    arc = np.radians(np.linspace(-last, last, 181))
    for radius in np.linspace(0, top, 5)[1:]:
        axes.plot(radius * np.sin(arc), -radius * np.cos(arc), color="0.6" if radius == top else "0.85", linewidth=0.8)
        label = f"{radius:g} cd" if radius == top else f"{radius:g}"
        axes.annotate(label, (radius * math.sin(math.radians(15)), -radius * math.cos(math.radians(15))), fontsize=8,
                      color=GREY, ha="center", va="center", bbox={"color": "white", "alpha": 0.75, "pad": 0.5}, zorder=3)
    for degrees in range(-last, last + 1, 30):
        x, y = math.sin(math.radians(degrees)), -math.cos(math.radians(degrees))
        axes.plot([0, top * x], [0, top * y], color="0.85", linewidth=0.8)
        axes.text(1.07 * top * x, 1.07 * top * y, f"{abs(degrees)}°", fontsize=9, ha="center", va="center")


def draw_solid(axes, reader):
    """The photometric solid, hanging below its luminaire, shaded by intensity."""
    solid = reader.GetOutputDataObject(0)
    points = vtk_to_numpy(solid.GetPoints().GetData()).astype(float)
    cd = vtk_to_numpy(solid.GetPointData().GetArray(arrays.INTENSITY))
    quads = vtk_to_numpy(solid.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    light = cd[quads].mean(axis=1)
    kept = light > 1e-6 * cd.max()
    faces = points[quads[kept]]
    normals = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    shade = 0.72 + 0.28 * np.abs((normals / np.where(length > 0, length, 1)) @ (0.5, -0.7, 0.5))
    colours = false_colours()(light[kept] / cd.max())
    colours[:, :3] *= np.clip(shade, 0, 1)[:, None]
    axes.add_collection3d(Poly3DCollection(faces, facecolors=colours, edgecolors=colours, linewidths=0.3))
    reach = np.abs(points[:, :2]).max()
    low, high = points[:, 2].min(), max(points[:, 2].max(), 0)
    half = max(reach, (high - low) / 2)
    middle = (high + low) / 2
    axes.set_xlim(-half, half)
    axes.set_ylim(-half, half)
    axes.set_zlim(middle - half, middle + half)
    axes.set_box_aspect((1, 1, 1), zoom=1.35)
    axes.view_init(elev=18, azim=-60)
    axes.set_axis_off()
    for (x, y), name in (((1.25, 0), "C 0"), ((0, 1.25), "C 90")):
        axes.plot([0, x * half], [0, y * half], [0, 0], color=GREY, linewidth=0.8)
        axes.text(1.08 * x * half, 1.08 * y * half, 0, name, fontsize=8, color=GREY, ha="center", va="center")
