# SPDX-License-Identifier: BSD-3-Clause
"""The values of a calculation plane as a table, laid out as the points lie."""
import numpy as np

from kalos.report.html import table
from kalos.results.text import number

MOST_COLUMNS, MOST_ROWS = 16, 40


def grid_shape(points):
    """Rows and columns of points (n, 3) that are a regular grid, row by row; None where they are none."""
    count = len(points)
    if count < 2:
        return None
    step, size = points[1] - points[0], np.ptp(points, axis=0).max()
    along = np.linalg.norm(points - points[0] - np.arange(count)[:, None] * step, axis=1) < 1e-6 * size
    columns = count if along.all() else int(np.argmin(along))
    if count % columns:
        return None
    rows = count // columns
    across = points[columns] - points[0] if rows > 1 else np.zeros(3)
    i, j = np.divmod(np.arange(count), columns)
    expected = points[0] + j[:, None] * step + i[:, None] * across
    return (rows, columns) if np.linalg.norm(points - expected, axis=1).max() < 1e-6 * size else None


def grid_section(one):
    """The illuminance at the points of a plane, every one or so many that the table fits a page; nothing for other sets."""
    shape = grid_shape(one.points) if one.cells else None
    if shape is None or min(shape) < 2:
        return ""
    every = [max(1, -(-count // most)) for count, most in zip(shape, (MOST_ROWS, MOST_COLUMNS))]
    values = one.illuminance.reshape(shape)[::every[0], ::every[1]]
    valid = one.valid.reshape(shape)[::every[0], ::every[1]]
    points = one.points.reshape(*shape, 3)[::every[0], ::every[1]]
    u, v = points[0] - points[0, 0], points[:, 0] - points[0, 0]
    head = ("v \\ u, m", *(f"{x:.2f}" for x in np.linalg.norm(u, axis=1)))
    rows = [(f"{y:.2f}", *(number(float(e)) if ok else "-" for e, ok in zip(line, oks)))
            for y, line, oks in zip(np.linalg.norm(v, axis=1), values, valid)][::-1]
    thinned = "" if every == [1, 1] else f", every {every[1]}th along u and every {every[0]}th along v"
    first = ", ".join(f"{x:.2f}" for x in one.points[0])
    return (f"<p class='facts'>Illuminance at the grid points, lx{thinned}; u and v count from the first point ({first}) m; - is left out.</p>"
            + table(head, rows, numbers=range(len(head)), kind="grid"))
