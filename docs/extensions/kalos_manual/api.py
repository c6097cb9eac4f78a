# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings of the package as the site shows them: what they say of an argument or a field becomes an item of a list."""
import inspect
import re

NAMES = re.compile(r"(?:^|(?<=[.;] ))((?:\*{0,2}[a-z_]\w*)(?:, [a-z_]\w*)*): ")
CODE = re.compile(r"(?<!`)`([^`]+)`(?!`)")


def known(thing):
    """The names of the arguments of a function, or of the fields of a class."""
    found = set(getattr(thing, "__annotations__", ()))
    try:
        found |= set(inspect.signature(thing).parameters)
    except (TypeError, ValueError):
        pass
    if inspect.isclass(thing):
        found |= {name for name in vars(thing) if not name.startswith("_")}
        found |= set(re.findall(r"self\.([a-z]\w*)", inspect.getsource(thing)))
    return found


def items(paragraph, names):
    """A paragraph as lines of text and of a list: an item begins where names of arguments and a colon stand."""
    starts = [found for found in NAMES.finditer(paragraph) if all(name.strip("*") in names for name in found[1].split(", "))]
    ends = [found.start() for found in starts] + [len(paragraph)]
    lines = [paragraph[:ends[0]].strip(), ""]
    for found, end in zip(starts, ends[1:]):
        shown = ", ".join(f"**{name}**" for name in found[1].split(", "))
        lines.append(f"* {shown}: {paragraph[found.end():end].strip()}")
    return lines


def process(app, what, name, thing, options, lines):
    text = CODE.sub(r"``\1``", "\n".join(lines))
    names, made = known(thing), []
    for paragraph in text.split("\n\n"):
        if ">>>" in paragraph or not paragraph.strip():
            made += [*paragraph.split("\n"), ""]
        else:
            made += [*items(" ".join(line.strip() for line in paragraph.split("\n")), names), ""]
    lines[:] = made


def setup(app):
    app.connect("autodoc-process-docstring", process)
