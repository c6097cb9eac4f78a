# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of `kalos atlas`: a small panel for every method, and the page that holds them."""
from html import escape

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from kalos.charts.families import FAMILIES, about, family, style
from kalos.pictures.drawing import DPI, GREY

COLUMNS = 4
PANEL = (2.75, 1.75)  # inches
LOW, HIGH = 0.2, 5.0  # of the truth; what lies beyond sits on the frame as a triangle
TICKS = (0.2, 0.5, 1, 2, 5)
LENGTHS = ((1e-4, "0.1 mm"), (1e-3, "1 mm"), (1e-2, "1 cm"), (1e-1, "10 cm"), (1, "1 m"))


def draw_failure(path, failure, found, truth, source):
    """Estimates over the truth along the line, a panel a method, in the order of their families."""
    names = [name for one in FAMILIES for name in one.about if name in found]
    rows = -(-len(names) // COLUMNS)
    top, bottom = 0.85, 0.5  # inches
    height = rows * PANEL[1] + top + bottom
    figure = Figure(figsize=(COLUMNS * PANEL[0] + 0.4, height), dpi=DPI)
    FigureCanvasAgg(figure)
    grid = figure.subplots(rows, COLUMNS, sharex=True, sharey=True, squeeze=False,
                           gridspec_kw={"left": 0.055, "right": 0.985, "top": 1 - (top + 0.15) / height, "bottom": bottom / height,
                                        "hspace": 0.55, "wspace": 0.1})
    for axes, name in zip(grid.ravel(), names):
        panel(axes, failure, name, found[name], truth)
    for axes in grid.ravel()[len(names):]:
        axes.set_axis_off()
    for k, axes in enumerate(grid.ravel()[:len(names)]):
        axes.tick_params(labelbottom=k + COLUMNS >= len(names))
    figure.text(0.055, 1 - 0.12 / height, failure.title, fontsize=13, va="top")
    figure.text(0.055, 1 - 0.4 / height, failure.about, fontsize=9, color=GREY, va="top")
    values = f"{truth[0]:.4g} lx" if np.ptp(truth) == 0 else f"{truth.min():.3g} to {truth.max():.3g} lx"
    figure.text(0.055, 0.1 / height, f"Estimate over truth, over the {failure.axis}. Truth: {values}, {source}. Same processor time for all; "
                "dots: single seeds, line: their mean.", fontsize=8, color=GREY)
    figure.savefig(path, metadata={"Software": None})


def panel(axes, failure, name, found, truth):
    colour = style(name)["color"]
    axes.axhline(1, color="0.35", linewidth=0.8, linestyle="--")
    if "refused" not in found:
        ratios = found["values"] / truth
        inside = np.clip(ratios, LOW, HIGH)
        for mark, where in ((".", inside == ratios), ("^", ratios > HIGH), ("v", ratios < LOW)):
            seed, place = np.nonzero(where)
            axes.plot(failure.along[place], inside[seed, place], mark, color=colour, markersize=3.5, alpha=0.35, markeredgewidth=0, clip_on=False)
        axes.plot(failure.along, np.clip(ratios.mean(axis=0), LOW, HIGH), color=colour, linewidth=1.6)
    axes.set_yscale("log")
    axes.set_ylim(LOW, HIGH)
    axes.set_yticks(TICKS)
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    if failure.logarithmic:
        axes.set_xscale("log")
        shown = [(x, text) for x, text in LENGTHS if failure.along[0] <= x * 1.001 and x <= failure.along[-1] * 1.001]
        axes.set_xticks([x for x, _ in shown], [text for _, text in shown])
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g} m"))
    axes.tick_params(labelsize=7)
    axes.grid(color="0.93")
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.set_title(name, loc="left", fontsize=9.5, color=colour, weight="bold", pad=14)
    axes.text(0, 1.03, shortened(found["verdict"]), transform=axes.transAxes, fontsize=7.2, color="0.25", va="bottom")


def percent(share):
    """A share in words: `2.1 %`, `150 %`."""
    return f"{100 * share:.2g} %" if share < 0.995 else f"{100 * share:.0f} %"


def shortened(text, most=46):
    return text if len(text) <= most else text[:most - 1].rsplit(" ", 1)[0] + " …"


STYLE = """body{font:15px/1.5 system-ui,sans-serif;margin:2.5em auto;max-width:72em;padding:0 1.5em;color:#222}
h1{font-weight:600}h2{margin:2.2em 0 .2em;font-weight:600}p{max-width:52em;margin:.3em 0}img{width:100%;margin:.8em 0}
table{border-collapse:collapse;font-size:14px}td,th{text-align:left;padding:.2em 1em .2em 0;border-bottom:1px solid #e4e4e4;vertical-align:top}
.m{font-weight:600;white-space:nowrap}.s{color:#777}"""


def page(result):
    """atlas.html: every scene with its picture, its truth and what each method makes of it."""
    methods = list(result["scenes"][0]["verdicts"])
    parts = [f"<!doctype html><html lang='en'><meta charset='utf-8'><title>How methods fail</title><style>{STYLE}</style>",
             "<h1>How methods fail</h1>",
             f"<p>Every method has {result['budget_seconds']:g} s of one processor on each scene, over {result['seeds']} seeds. Colours tell "
             "families apart: methods of one family fail alike.</p><table>"]
    for one in FAMILIES:
        for name in (name for name in one.about if name in methods):
            parts.append(f"<tr><td class='m' style='color:{style(name)['color']}'>{escape(name)}</td><td>{escape(about(name))}</td>"
                         f"<td class='s'>{escape(family(name).title.partition(':')[0])}</td></tr>")
    parts.append("</table>")
    for scene in result["scenes"]:
        low, high = min(scene["truth_lx"]), max(scene["truth_lx"])
        values = f"{low:.4g} lx everywhere" if low == high else f"{low:.3g} to {high:.3g} lx"
        winners = ", ".join(f"{one['method']} ({percent(one['rms'])})" for one in scene["least_error"])
        parts.append(f"<h2>{escape(scene['title'])}</h2><p>{escape(scene['about'])}</p><p class='s'>Truth: {values}, "
                     f"{escape(scene['source'])}. Least error: {winners}.</p><img src='{scene['name']}.png' alt='{escape(scene['title'], quote=True)}'><table>")
        parts += [f"<tr><td class='m' style='color:{style(name)['color']}'>{escape(name)}</td><td>{escape(text)}</td></tr>"
                  for name, text in scene["verdicts"].items()]
        parts.append("</table>")
    return "\n".join(parts) + "</html>\n"
