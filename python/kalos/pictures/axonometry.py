# SPDX-License-Identifier: BSD-3-Clause
"""A surface in space drawn on paper: parallel projection, far cells first, cells seen from behind left out.

The normals of a room point inwards, so one looks into it through the walls nearest to the viewer.
"""
from typing import Any

import numpy as np
from matplotlib.collections import PolyCollection

TO_VIEWER = np.array([0.42, -0.76, 0.50])  # from the right, the front and above


def paper(points: Any, to_viewer: Any) -> Any:
    """Coordinates on paper, z up."""
    right = np.cross([0, 0, 1], to_viewer)
    right = right / np.linalg.norm(right)
    up = np.cross(to_viewer, right)
    return np.column_stack([points @ right, points @ up])


def seen_cells(polygons, normals):
    """Indices of the cells that show their front to the viewer, far ones first."""
    depth = np.array([polygon.mean(axis=0) @ TO_VIEWER for polygon in polygons])
    seen = np.flatnonzero(normals @ TO_VIEWER > 1e-9)
    return seen[np.argsort(depth[seen])]


def draw_axonometry(axes, polygons, values, seen, scale):
    """The cells `seen` in colour, and the edges of the box around all polygons."""
    to_viewer = TO_VIEWER / np.linalg.norm(TO_VIEWER)
    axes.add_collection(PolyCollection([paper(polygons[i], to_viewer) for i in seen], array=values[seen],
                                       cmap=scale.colours, norm=scale.norm, antialiased=False, linewidth=0))
    corners = np.concatenate(polygons)
    draw_box(axes, corners.min(axis=0), corners.max(axis=0), to_viewer)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.margins(0.06)
    axes.set_axis_off()


def draw_box(axes, low, high, to_viewer):
    """The three outer edges of the bounding box, with their lengths."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    edges = ((0, "x", (x0, y0, z0), (x1, y0, z0), (0, -1), "top"), (1, "y", (x1, y0, z0), (x1, y1, z0), (1, -1), "top"),
             (2, "z", (x0, y0, z0), (x0, y0, z1), (-1, 0), "center"))
    for axis, letter, start, end, away, vertical in edges:
        length = high[axis] - low[axis]
        if length <= 0:
            continue
        line = paper(np.array([start, end], float), to_viewer)
        axes.plot(*line.T, color="0.3", linewidth=1)
        horizontal = {1: "left", 0: "center", -1: "right"}[away[0]]
        axes.annotate(f"{letter}: {low[axis]:.4g} to {high[axis]:.4g} m", line.mean(axis=0), xytext=(6 * away[0], 6 * away[1]),
                      textcoords="offset points", ha=horizontal, va=vertical, fontsize=9, color="0.3",
                      rotation=90 if axis == 2 else np.degrees(np.arctan2(*(line[1] - line[0])[::-1])),
                      rotation_mode="anchor")
