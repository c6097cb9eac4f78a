# SPDX-License-Identifier: BSD-3-Clause
"""The table of all data arrays, from the one header that names them."""
import re
from pathlib import Path

HEADER = Path(__file__).resolve().parents[3] / "modules" / "CommonPhotometry" / "vtkKalosArrayNames.h"
ENTRY = re.compile(r'constexpr const char\* \w+\s*=\s*"(\w+)";')


def cell(words):
    return " ".join(words.split()).replace("|", "\\|")


def entries(text):
    """(group, name, meaning) of every array, in the header's order."""
    text = text[text.index("namespace"):]
    group, before = "", []
    for statement in re.split(r"\n(?=constexpr|//|///)", text):
        start = statement.strip()
        if start.startswith("constexpr"):
            name = ENTRY.search(statement)[1]
            after = " ".join(re.findall(r"///<? ?(.*)", statement))
            yield group, name, cell(" ".join([*before, after]))
            before = []
        elif start.startswith("///"):
            before.append(start[3:].strip())
        elif start.startswith("// "):
            group = start[3:].strip()


def write():
    lines, last = [], None
    for group, name, meaning in entries(HEADER.read_text(encoding="utf-8")):
        if group != last:
            lines += ["", f"### {group.rstrip('.')}", "", "| array | meaning and unit |", "| --- | --- |"]
            last = group
        lines.append(f"| `{name}` | {meaning} |")
    return "\n".join(lines)
