# SPDX-License-Identifier: BSD-3-Clause
"""The picture of rows.py: a small chart of error against processor time per row, all with the same axes."""
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from kalos.charts.picture import curves, style
from kalos.pictures.drawing import DPI, GREY

COLUMNS, WIDTH, HEIGHT = 3, 11.0, 2.75  # inches, of the page and of a row of charts
SHOWN = (0.05, 30.0)  # %
TOLD = ("2 %", "1 %")  # errors whose ratio to the best peer is written down


def draw(path, rows, of, goals):
    """`rows`: name -> title, chart, and times per contender and goal as rows.times() has them."""
    count = -(-len(rows) // COLUMNS)
    height = count * HEIGHT + 1.0
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    FigureCanvasAgg(figure)
    grid = figure.subplots(count, COLUMNS, sharex=True, sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.06, right=0.985, top=1 - 1.05 / height, bottom=0.5 / height, wspace=0.06, hspace=0.2)
    styles = {}
    for axes, (title, result, found) in zip(grid.flat, rows.values()):
        styles.update(style(result["contenders"]))
        curves(axes, result, styles, "cpu_seconds", f"rms_of_{of}")
        axes.set_title(title, loc="left", fontsize=9, pad=4)
        tell(axes, result, found, styles, goals)
    for k, axes in enumerate(grid.flat):
        axes.set_visible(k < len(rows))
        finish(axes, bottom=k + COLUMNS >= len(rows), left=k % COLUMNS == 0)
    figure.text(0.06, 1 - 0.18 / height, f"rms error of each {of}, %, against processor time on one thread, s", fontsize=13, va="top")
    for k, (name, line) in enumerate(styles.items()):
        figure.text(0.06 + 0.16 * k, 1 - 0.52 / height, f"—  {name}", fontsize=10, color=line["color"], va="top", weight="bold")
    figure.text(0.06 + 0.16 * len(styles), 1 - 0.52 / height, "in the corners: how many times longer the best peer takes", fontsize=9,
                color=GREY, va="top")
    figure.savefig(path, metadata={"Software": None})


def tell(axes, result, found, styles, goals):
    """The ratios to the best peer, in the lower left corner, where the curves do not come."""
    own = [one["name"] for one in result["contenders"] if not one["peer"]]
    if not any(ratio for name in own for _, _, ratio in found[name]):
        return
    top = 0.06 + 0.085 * len(own)
    for i, goal in enumerate(("", *TOLD)):
        x = 0.26 + 0.14 * i
        if goal:
            axes.text(x, top, goal, transform=axes.transAxes, fontsize=7.5, color=GREY, ha="right", va="center")
        for k, name in enumerate(own):
            y, color = top - 0.085 * (k + 1), styles[name]["color"]
            if not goal:
                axes.text(0.03, y, name, transform=axes.transAxes, fontsize=8, color=color, va="center")
                continue
            ratio = found[name][goals.index(goal)][2]
            axes.text(x, y, f"{ratio:.2g}×" if ratio else "–", transform=axes.transAxes, fontsize=8, color=color, ha="right",
                      va="center", weight="bold")


def finish(axes, bottom, left):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(*SHOWN)
    axes.set_yticks([0.1, 0.2, 0.5, 1, 2, 5, 10, 20])
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_locator(LogLocator(base=10, numticks=12))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.grid(True, which="major", color="0.92")
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=8, labelbottom=bottom, labelleft=left)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
