# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of the page: tables and pictures."""
import base64
from html import escape


def table(head, rows, numbers=(), kind=""):
    """A table whose columns `numbers` are set to the right; `kind` is a class of the style sheet."""
    mark = ["n" if i in numbers else "" for i in range(len(head))]

    def line(tag, cells):
        return "<tr>" + "".join(f"<{tag} class='{m}'>{escape(str(c))}</{tag}>" for m, c in zip(mark, cells)) + "</tr>"

    opening = f"<table class='{kind}'>" if kind else "<table>"
    return f"{opening}<thead>{line('th', head)}</thead><tbody>{''.join(line('td', row) for row in rows)}</tbody></table>"


def embedded(file, text):
    """A picture in a file in memory as part of the page."""
    data = base64.b64encode(file.getvalue()).decode("ascii")
    return f"<img alt='{escape(text, quote=True)}' src='data:image/png;base64,{data}'>"
