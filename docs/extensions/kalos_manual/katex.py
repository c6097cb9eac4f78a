# SPDX-License-Identifier: BSD-3-Clause
"""Formulas by Debian's KaTeX, copied into the site, so that pages need no network."""
import html
import shutil
from pathlib import Path

from docutils.nodes import SkipNode

KATEX = Path("/usr/share/javascript/katex")
START = ("document.addEventListener('DOMContentLoaded', () => { for (const node of document.querySelectorAll('.kalos-math'))"
         " katex.render(node.textContent, node, {displayMode: node.tagName === 'DIV', throwOnError: false}); });")


def inline(writer, node):
    writer.body.append(f'<span class="kalos-math">{html.escape(node.astext())}</span>')
    raise SkipNode


def display(writer, node):
    tag = rf" \tag{{{node['number']}}}" if node["number"] else ""
    label = f' id="{node["ids"][0]}"' if node["ids"] else ""
    text = node.astext().strip()
    writer.body.append(f'<div class="kalos-math math-block"{label}>{html.escape(text + tag)}</div>')
    raise SkipNode


def copy(app, error):
    if error or app.builder.format != "html":
        return
    target = Path(app.outdir) / "_static" / "katex"
    target.mkdir(parents=True, exist_ok=True)
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copyfile(KATEX / name, target / name)
    shutil.copytree(KATEX / "fonts", target / "fonts", dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.ttf"))


def setup(app):
    app.add_html_math_renderer("kalos", (inline, None), (display, None))
    app.config.html_math_renderer = "kalos"
    app.add_css_file("katex/katex.min.css")
    app.add_js_file("katex/katex.min.js")
    app.add_js_file(None, body=START)
    app.connect("build-finished", copy)
