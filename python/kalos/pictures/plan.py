# SPDX-License-Identifier: BSD-3-Clause
"""The plan of a flat receiver set: false colour, isolux lines with their labels, and the error beside it."""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from kalos.pictures.drawing import DPI, cell_points, draw_map, save, shown
from kalos.pictures.isolux import draw_isolux
from kalos.pictures.scale import colour_bar, colour_scale
from kalos.results import statistics

THIN = 0.2  # height over width below which a plan is stretched


def draw_plan(file, receivers, frame, lines, look):
    """Illuminance with isolux lines on the left, its relative standard error on the right, as PNG."""
    polygons = [cell_points(receivers.dataset, i) for i in range(receivers.dataset.GetNumberOfCells())]
    flat = np.concatenate([frame.project(p) for p in polygons])
    wide, high = np.ptp(flat, axis=0)
    tall = wide < 1.2 * high
    figure = Figure(figsize=(10, 5.2) if tall else (8, 2.2 + 11.5 * max(THIN, high / wide)), dpi=DPI)
    FigureCanvasAgg(figure)
    upper, lower = figure.subplots(1, 2) if tall else figure.subplots(2, 1)
    figure.subplots_adjust(hspace=0.35, wspace=0.6)
    values = shown(receivers.illuminance, receivers.valid)
    scale = colour_scale(values, look.illuminance, look)
    draw_map(upper, polygons, values, scale, frame)
    colour_bar(upper, scale, "illuminance, lx")
    upper.set_title("illuminance with isolux lines, lx", loc="left", fontsize=11)
    if high < THIN * wide:
        upper.set_aspect("auto")
        figure.text(0.5, 0.5, "stretched upwards: the axes have different scales", ha="center", fontsize=8, color="0.35")
    draw_isolux(upper, lines, frame)
    relative = shown(relative_error(receivers.illuminance, receivers.standard_error), receivers.valid)
    scale = colour_scale(relative)
    draw_map(lower, polygons, relative, scale, frame)
    colour_bar(lower, scale, "standard error, %")
    lower.set_title("relative standard error, %", loc="left", fontsize=11)
    if high < THIN * wide:
        lower.set_aspect("auto")
    save(figure, file, receivers.dataset)


def relative_error(illuminance, standard_error):
    """In percent; 0 where it is dark."""
    found = 100 * statistics.relative_error(illuminance, standard_error)
    return np.where(np.isfinite(found), found, 0)
