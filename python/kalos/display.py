# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results in memory, as a notebook shows them."""
from __future__ import annotations

import io

import numpy as np

from kalos import pictures, summary
from kalos.projection import flat_frame
from kalos.receivers import Receivers
from kalos.results import Illuminance
from kalos.scale import colour_bar, colour_scale


def png(result) -> bytes:
    """The picture of a result: a map of a flat grid, a chart of other points, an image of a luminance."""
    file = io.BytesIO()
    if not isinstance(result, Illuminance):
        pictures.draw_image(file, "view", result.vtk)
        return file.getvalue()
    points, normals = result.points.reshape(-1, 3), result.normals.reshape(-1, 3)
    frame = flat_frame(points, normals) if grid(result) else None
    if frame:
        draw_grid(file, result, frame)
    else:
        pictures.draw_receivers(file, Receivers("points", result.vtk, points, normals, result.illuminance.ravel(),
                                                result.standard_error.ravel(), result.direct.ravel(),
                                                result.trusted.ravel(), np.ones(len(points))))
    return file.getvalue()


def grid(result):
    return result.points.ndim == 3 and min(result.points.shape[:2]) > 1


def draw_grid(file, result, frame):
    """Every point in the middle of its cell."""
    figures = summary.statistics(result.illuminance.ravel(), result.standard_error.ravel())
    figure, axes = pictures.sheet("illuminance", pictures.facts(figures, "lx"))
    across, up = np.moveaxis(frame.project(result.points.reshape(-1, 3)).reshape(*result.points.shape[:2], 2), -1, 0)
    scale = colour_scale(result.illuminance)
    axes.pcolormesh(across, up, result.illuminance, shading="nearest", cmap=scale.colours, norm=scale.norm)
    axes.set_aspect("equal")
    axes.set_xlabel(frame.right_label)
    axes.set_ylabel(frame.up_label)
    if frame.right_inverted:
        axes.invert_xaxis()
    colour_bar(axes, scale, "illuminance, lx")
    pictures.save(figure, file, result.vtk)
