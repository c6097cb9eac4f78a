# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results in memory, as a notebook shows them."""
from __future__ import annotations

import io

import numpy as np

from kalos.pictures import drawing
from kalos.pictures.projection import flat_frame
from kalos.pictures.scale import colour_bar, colour_scale
from kalos.results.receivers import Receivers
from kalos.results.statistics import statistics


def luminance_png(result) -> bytes:
    """The image of a kalos.Luminance."""
    file = io.BytesIO()
    drawing.draw_image(file, "view", result.vtk)
    return file.getvalue()


def illuminance_png(result) -> bytes:
    """A kalos.Illuminance: a map of a flat grid, a chart of other points."""
    file = io.BytesIO()
    points, normals = result.points.reshape(-1, 3), result.normals.reshape(-1, 3)
    frame = flat_frame(points, normals) if is_grid(result) else None
    if frame:
        draw_grid(file, result, frame)
    else:
        drawing.draw_receivers(file, Receivers("points", result.vtk, points, normals, result.illuminance.ravel(),
                                               result.standard_error.ravel(), result.direct.ravel(),
                                               result.trusted.ravel(), result.valid.ravel(), np.ones(len(points))))
    return file.getvalue()


def is_grid(result):
    return result.points.ndim == 3 and min(result.points.shape[:2]) > 1


def draw_grid(file, result, frame):
    """Every point in the middle of its cell."""
    figures = statistics(result.illuminance[result.valid], result.standard_error[result.valid])
    values = drawing.shown(result.illuminance, result.valid)
    figure, axes = drawing.sheet("illuminance", drawing.facts(figures, "lx"))
    across, up = np.moveaxis(frame.project(result.points.reshape(-1, 3)).reshape(*result.points.shape[:2], 2), -1, 0)
    scale = colour_scale(values)
    axes.pcolormesh(across, up, values, shading="nearest", cmap=scale.colours, norm=scale.norm)
    axes.set_aspect("equal")
    axes.set_xlabel(frame.right_label)
    axes.set_ylabel(frame.up_label)
    if frame.right_inverted:
        axes.invert_xaxis()
    colour_bar(axes, scale, "illuminance, lx")
    drawing.save(figure, file, result.vtk)
