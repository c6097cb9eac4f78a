# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a chart: error against time, large, and beside it noise, bias and the worst receiver.

Families of methods have colours of their own, peers are dashed; every line carries its name at its end, and the families stand
below with a line for each method.
"""
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from kalos.charts.families import FAMILIES
from kalos.charts.families import style as family_style
from kalos.pictures.drawing import DPI, GREY

SIZE = (11.0, 6.4)  # inches
STRONG = ("gathered", "compensated", "paths", "radiosity", "photon-map")  # drawn as strong lines
LINE, MARGIN = 0.17, 0.15  # inches: of the legend, below it
MOST = 100.0  # %: larger errors are not drawn


def draw_chart(folder, result):
    """chart.png and chart.svg."""
    known = families(result)
    foot = MARGIN + LINE * sum(1 + len(names) for _, names in known)  # inches
    size = (SIZE[0], SIZE[1] + foot)
    figure = Figure(figsize=size, dpi=DPI)
    FigureCanvasAgg(figure)

    def place(left, bottom, width, height):
        """Axes in shares of the upper part."""
        up = SIZE[1] / size[1]
        return figure.add_axes((left, 1 - up + up * bottom, width, up * height))

    styles = style(result["contenders"])
    of = result["relative_to"]
    main = place(0.07, 0.1, 0.45, 0.72)
    curves(main, result, styles, "cpu_seconds", f"rms_of_{of}")
    finish(main, "rms error: bias and noise together", "processor time, s")
    ends(main, result, styles)
    mark_reference(main, result)
    single = "pixel" if result["quantity"] == "luminance" else "receiver"
    small = (("noise: the spread of seeds", f"noise_of_{of}"), ("bias: what all seeds share", f"bias_of_{of}"),
             (f"worst {single}", f"max_of_{of}"))
    height = 0.86 / len(small)
    for k, (title, name) in enumerate(small):
        axes = place(0.765, 0.1 + (len(small) - 1 - k) * (height - 0.02), 0.22, height - 0.155)
        curves(axes, result, styles, "cpu_seconds", name, small=True)
        finish(axes, title, "processor time, s", small=True)
    head(figure, result, single, SIZE[1] / size[1])
    legend(figure, known, size[1])
    for kind in ("png", "svg"):
        figure.savefig(folder / f"chart.{kind}", format=kind, metadata={"Software": None} if kind == "png" else {"Date": None})


def head(figure, result, single, up):
    of, reference = result["relative_to"], result["reference"]
    own = f"each {single}'s own value" if of == "value" else f"the mean over the {single}s"
    accuracy = "" if reference["rms"] == 0 else f", itself within {100 * reference['rms']:.2g} %"
    threads = "one thread" if result["threads"] == 1 else f"{result['threads']} threads"
    figure.text(0.07, 1 - 0.035 * up, f"{Path(result['scene']).stem}, {result['receivers']}: error against time, {result['lit']} {single}s",
                fontsize=13.5, va="top")
    line = f"Errors in % of {own}; reference: {reference['source']}{accuracy}. {threads.capitalize()}, set-up apart."
    figure.text(0.07, 1 - 0.085 * up, line, fontsize=9, color=GREY, va="top")


def mark_reference(axes, result):
    """A line at the reference's own error."""
    rms = 100 * result["reference"]["rms"]
    low, high = axes.get_ylim()
    if not low < rms < high:
        return
    axes.axhline(rms, color="0.6", linewidth=0.8, linestyle=":")
    axes.text(0.015, rms, "reference itself", fontsize=7.5, color=GREY, ha="left", va="bottom", transform=axes.get_yaxis_transform())


def families(result):
    """The families that take part, with the names of those that do."""
    names = [one["name"] for one in result["contenders"]]
    found = [(one, [name for name in one.about if name in names]) for one in FAMILIES]
    return [(one, taking) for one, taking in found if taking]


def legend(figure, known, height):
    """One line a contender, by families: what it is and who uses it."""
    y = (MARGIN + LINE * sum(1 + len(names) for _, names in known)) / height
    for one, names in known:
        figure.text(0.07, y, one.title, fontsize=8.5, color="0.25", weight="bold", va="top")
        y -= LINE / height
        for name in names:
            mark = y - 0.5 * LINE / height
            figure.add_artist(Line2D((0.075, 0.1), (mark, mark), transform=figure.transFigure, linewidth=2, **family_style(name)))
            figure.text(0.108, y, name, fontsize=8.5, va="top")
            figure.text(0.225, y, one.about[name], fontsize=8.5, color=GREY, va="top")
            y -= LINE / height


def style(contenders):
    """Line style per name: strong where there is no bias, with squares for peers."""
    found = {}
    for one in contenders:
        strong = one["name"] in STRONG
        found[one["name"]] = {**family_style(one["name"]), "linewidth": 2.2 if strong else 1.8 if one["peer"] else 1.2,
                              "marker": "s" if one["peer"] else "o" if strong else "."}
    return found


def points(result, name, along, error):
    rows = [row for row in result["steps"] if row["contender"] == name and row[along] and 0 < row[error] <= MOST / 100]
    return np.array([row[along] for row in rows]), 100 * np.array([row[error] for row in rows])


def curves(axes, result, styles, along, error, small=False):
    for one in result["contenders"]:
        x, y = points(result, one["name"], along, error)
        line = dict(styles[one["name"]])
        if small:
            line.update(linewidth=0.7 * line["linewidth"], marker="")
        axes.plot(x, y, markersize=3.5, **line)


def finish(axes, title, label, small=False):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color="0.9")
    axes.set_axisbelow(True)
    axes.set_title(f"{title}, %", loc="left", fontsize=9 if small else 10.5)
    axes.set_xlabel(label, fontsize=8 if small else 10, labelpad=2)
    axes.tick_params(labelsize=7.5 if small else 9)
    low, high = axes.get_ylim()
    ticks = [m * 10.0**k for k in range(-4, 7) for m in ((1, 2, 5) if not small or high / low < 100 else (1,))]
    axes.set_yticks([t for t in ticks if low <= t <= high])
    axes.set_ylim(low, high)
    axes.xaxis.set_major_locator(LogLocator(base=10, numticks=12))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    if "time" in label:
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def ends(axes, result, styles):
    """Names at the ends of the lines, in a column to the right, moved apart where they would overlap."""
    labels = []
    for one in result["contenders"]:
        x, y = points(result, one["name"], "cpu_seconds", f"rms_of_{result['relative_to']}")
        if len(x):
            labels.append((np.log(y[-1]), x[-1], y[-1], one))
    if not labels:
        return
    labels.sort(key=lambda item: item[0])
    low, high = np.log(axes.get_ylim())
    step = (high - low) / 24
    places = []
    for y, *_ in labels:
        places.append(max(y, places[-1] + step) if places else max(y, low))
    excess = places[-1] - high
    for k in range(len(places) - 1, -1, -1):
        limit = high if k == len(places) - 1 else places[k + 1] - step
        places[k] = min(places[k], limit) if excess > 0 else places[k]
    for place, (_, x, y, one) in zip(places, labels):
        line = styles[one["name"]]
        lead = {"arrowstyle": "-", "color": line["color"], "linewidth": 0.5, "alpha": 0.6, "shrinkA": 2, "shrinkB": 3, "relpos": (0, 0.5)}
        axes.annotate(one["label"].removeprefix("Kalos, "), (x, y), xytext=(1.03, (place - low) / (high - low)),
                      textcoords="axes fraction", fontsize=9, color=line["color"], va="center", annotation_clip=False,
                      weight="bold" if line["linewidth"] > 2 else "normal", arrowprops=lead)
