# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a study: rows of small images, each normalised to its own maximum, with their errors underneath."""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from kalos.pictures.colours import false_colours
from kalos.pictures.drawing import DPI, GREY, cell_points, draw_map
from kalos.pictures.projection import flat_frame
from kalos.pictures.scale import Scale

PANEL = 1.75  # inches, a side
GAP = 0.2  # between panels
LABEL = 0.28  # above a panel: its setting
ERRORS = 0.42  # below: two lines of figures
TITLE = 0.42  # above a row
MARGIN = 0.3
HEAD = 1.05
BAR = 0.55  # the scale, at the bottom
MEANT = 6.9  # least width, inches: the heading needs it


def draw_study(path, subject, rows, estimates, cells, reference, near):
    """`cells` holds per options the row of the table, `reference` what study.json says about it."""
    columns = max(len(row.panels) for row in rows)
    width = max(MEANT, 2 * MARGIN + columns * PANEL + (columns - 1) * GAP)
    row_height = TITLE + LABEL + PANEL + ERRORS
    height = HEAD + len(rows) * row_height + BAR + MARGIN
    figure = Figure(figsize=(width, height), dpi=DPI)
    FigureCanvasAgg(figure)

    def write(x, y, text, **style):
        figure.text(x / width, 1 - y / height, text, va="top", **style)

    write(MARGIN, 0.2, f"{subject.name}: {subject.quantity}, each panel from 0 to its own maximum", fontsize=13)
    write(MARGIN, 0.5, error_line(reference, near), fontsize=9, color=GREY)
    scale = Scale(false_colours(), Normalize(0, 1), "neither")
    for i, row in enumerate(rows):
        top = HEAD + i * row_height
        write(MARGIN, top, row.title, fontsize=11, weight="bold")
        for j, panel in enumerate(row.panels):
            left, panel_top = MARGIN + j * (PANEL + GAP), top + TITLE - 0.1 + LABEL
            write(left, panel_top - 0.21, panel.label, fontsize=10)
            axes = figure.add_axes((left / width, 1 - (panel_top + PANEL) / height, PANEL / width, PANEL / height))
            draw_panel(axes, subject, estimates[panel.options].values, scale)
            write(left, panel_top + PANEL + 0.06, figures_line(cells[panel.options]), fontsize=8, color=GREY, linespacing=1.25)
    axes = figure.add_axes((MARGIN / width, (MARGIN + 0.15) / height, 2.4 / width, 0.12 / height))
    bar = figure.colorbar(ScalarMappable(norm=scale.norm, cmap=scale.colours), cax=axes, orientation="horizontal")
    bar.set_ticks([0, 0.5, 1], labels=["0", "0.5", f"1 × the maximum {subject.quantity} of a panel"])
    bar.ax.tick_params(labelsize=8)
    bar.ax.get_xticklabels()[-1].set_ha("left")
    bar.outline.set_linewidth(0.5)
    figure.savefig(path, format="png", metadata={"Software": None})


def error_line(reference, near):
    noise = [f"{100 * reference[key]:.1f} % {where}" for key, where in (("rms_near", "near edges"), ("rms_elsewhere", "elsewhere"))
             if reference[key] is not None]
    return (f"Error: root mean square of the relative errors; near: less than {near} m from an edge or contact.\n"
            f"Reference: {reference['trajectories']} trajectories of {reference['method']}, itself within {', '.join(noise)}.")


def share(value):
    """A relative error in few characters."""
    if value is None:
        return "-"
    return f"{100 * value:.0f} %" if value >= 0.1 else f"{100 * value:.1f} %"


def figures_line(cell):
    bias = "-" if cell["bias"] is None else f"{100 * cell['bias']:+.1f} %"
    return (f"error near {share(cell['rms_near'])}, else {share(cell['rms_elsewhere'])}\n"
            f"bias {bias}, {cell['cpu_seconds']:.3g} s")


def draw_panel(axes, subject, values, scale):
    """An image, a plan of the first flat set of cells, or a chart of what cannot be laid on paper."""
    normalised = values / max(float(values.max()), 1e-300)
    if subject.is_image:
        axes.imshow(normalised.reshape(subject.resolution[::-1]), origin="lower", cmap=scale.colours, norm=scale.norm,
                    interpolation="nearest")
        axes.set_axis_off()
        return
    start = 0
    for one in subject.receivers:
        own = normalised[start:start + len(one.points)]
        start += len(one.points)
        frame = flat_frame(one.points, one.normals) if one.cells else None
        if frame:
            polygons = [cell_points(one.dataset, i) for i in range(one.dataset.GetNumberOfCells())]
            draw_map(axes, polygons, own, scale, frame)
            axes.set_axis_off()
            return
    axes.plot(np.arange(1, len(normalised) + 1), normalised, ".", markersize=3, color="#0b5d8f")
    axes.set_ylim(0, 1.05)
    axes.tick_params(labelsize=6, length=2)
