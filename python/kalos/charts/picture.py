# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a chart: error against time, large, and beside it against rays, at 95 % of the receivers and at the worst.

Kalos's unbiased and consistent methods are drawn in strong colours, its biased and simple ones thin, peers dashed; every
line carries its name at its end.
"""
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from kalos.pictures.drawing import DPI, GREY

SIZE = (11.0, 6.4)  # inches
STRONG = {"gathered": "#0b5d8f", "compensated": "#1b9e77", "local": "#7a3e9d"}
QUIET = ("#8c6d31", "#a55194", "#637939", "#7f7f7f", "#5b7f95")
PEER = ("#c2571a", "#d4a017", "#8f2d2d")
MOST = 100.0  # %: larger errors are not drawn


def draw_chart(folder, result):
    """chart.png and chart.svg."""
    figure = Figure(figsize=SIZE, dpi=DPI)
    FigureCanvasAgg(figure)
    styles = style(result["contenders"])
    of = result["relative_to"]
    main = figure.add_axes((0.07, 0.1, 0.45, 0.72))
    curves(main, result, styles, "cpu_seconds", f"rms_of_{of}")
    finish(main, "rms error", "processor time, s")
    ends(main, result, styles)
    if result["reference"]["rms"] > 0:
        low, high = main.get_ylim()
        if low < 100 * result["reference"]["rms"] < high:
            main.axhline(100 * result["reference"]["rms"], color="0.6", linewidth=0.8, linestyle=":")
            main.text(0.015, 100 * result["reference"]["rms"], "reference itself", fontsize=7.5, color=GREY, ha="left",
                      va="bottom", transform=main.get_yaxis_transform())
    single = "pixel" if result["quantity"] == "luminance" else "receiver"
    small = [(f"95 % of the {single}s are better", "cpu_seconds", f"p95_of_{of}", "processor time, s"),
             (f"worst {single}", "cpu_seconds", f"max_of_{of}", "processor time, s")]
    if any(row["rays"] for row in result["steps"]):
        small.insert(0, ("rms error", "rays", f"rms_of_{of}", "rays"))
    height = 0.86 / len(small)
    for k, (title, along, name, label) in enumerate(small):
        axes = figure.add_axes((0.765, 0.1 + (len(small) - 1 - k) * (height - 0.02), 0.22, height - 0.155))
        curves(axes, result, styles, along, name, small=True)
        finish(axes, title, label, small=True)
    reference = result["reference"]
    own = f"each {single}'s own value" if of == "value" else f"the mean over the {single}s"
    accuracy = "" if reference["rms"] == 0 else f", itself within {100 * reference['rms']:.2g} %"
    threads = "one thread" if result["threads"] == 1 else f"{result['threads']} threads"
    figure.text(0.07, 0.965, f"{Path(result['scene']).stem}, {result['receivers']}: error against time, {result['lit']} {single}s", fontsize=13.5, va="top")
    line = f"Errors in % of {own}; reference: {reference['source']}{accuracy}. {threads.capitalize()}, set-up apart."
    figure.text(0.07, 0.915, line, fontsize=9, color=GREY, va="top")
    for kind in ("png", "svg"):
        figure.savefig(folder / f"chart.{kind}", format=kind, metadata={"Software": None} if kind == "png" else {"Date": None})


def style(contenders):
    """Line style per name."""
    quiet, peer, found = iter(QUIET * 3), iter(PEER * 3), {}
    for one in contenders:
        if one["peer"]:
            found[one["name"]] = {"color": next(peer), "linestyle": (0, (4, 1.5)), "linewidth": 1.8, "marker": "s"}
        elif one["name"] in STRONG:
            found[one["name"]] = {"color": STRONG[one["name"]], "linewidth": 2.2, "marker": "o"}
        else:
            found[one["name"]] = {"color": next(quiet), "linewidth": 1.0, "marker": "."}
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
