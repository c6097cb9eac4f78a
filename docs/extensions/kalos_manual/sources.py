# SPDX-License-Identifier: BSD-3-Clause
"""The role `source`: a link to a line of the sources, which stand in the site as pages of their own."""
import html
from pathlib import Path

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_for_filename
from sphinx.addnodes import pending_xref
from sphinx.util import logging

ROOT = Path(__file__).resolve().parents[3]
LOG = logging.getLogger(__name__)


def line_of(path, words):
    """The number of the one line of a file that holds these words; raises ValueError."""
    lines = (ROOT / path).read_text(encoding="utf-8").splitlines()
    found = [number for number, line in enumerate(lines, 1) if words in line]
    if len(found) != 1:
        raise ValueError(f"{path}: {len(found)} lines hold '{words}'; expected one")
    return found[0]


def role(name, rawtext, text, lineno, inliner, options=None, content=()):
    """`PATH` or `PATH:WORDS`."""
    path, _, words = text.partition(":")
    document = inliner.document
    environment = document.settings.env
    try:
        if not (ROOT / path).is_file():
            raise ValueError(f"{path}: there is no such file")
        line = line_of(path, words) if words else 1
    except ValueError as error:
        LOG.warning("source: %s", error, location=(environment.docname, lineno))
        return [nodes.literal(text, text)], []
    used = environment.__dict__.setdefault("kalos_sources", set())
    used.add(path)
    label = f"{Path(path).name}:{line}" if words else path
    node = pending_xref("", nodes.literal(label, label), refdomain="", reftype="kalos-source", reftarget=path, line=line,
                        refdoc=environment.docname, refexplicit=True)
    return [node], []


def resolve(app, environment, node, content):
    if node.get("reftype") != "kalos-source":
        return None
    uri = app.builder.get_relative_uri(node["refdoc"], page_of(node["reftarget"]))
    return nodes.reference("", "", content, internal=True, refuri=f"{uri}#L-{node['line']}")


def page_of(path):
    return f"source/{path}"


def pages(app):
    """One page for each quoted file."""
    for path in sorted(getattr(app.env, "kalos_sources", ())):
        text = (ROOT / path).read_text(encoding="utf-8")
        lexer = get_lexer_for_filename(path, stripnl=False)
        code = highlight(text, lexer, HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True, linespans="S"))
        yield page_of(path), {"title": path, "body": f"<h1>{Path(path).name}</h1>\n<p><code>{html.escape(path)}</code></p>\n{code}"}, "page.html"


def setup(app):
    app.add_role("source", role)
    app.connect("missing-reference", resolve)
    app.connect("html-collect-pages", pages)
