# SPDX-License-Identifier: BSD-3-Clause
"""The proxies of the ParaView plugin, from the XML files that ParaView reads."""
import xml.etree.ElementTree as ElementTree
from pathlib import Path

XMLS = Path(__file__).resolve().parents[3] / "apps" / "paraview" / "xmls"
PROPERTIES = {"IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty", "IdTypeVectorProperty", "InputProperty"}


def words(element):
    found = element.find("Documentation")
    return " ".join((found.text or "").split()).replace("|", "\\|") if found is not None else ""


def proxy(element):
    lines = [f"### {element.get('label')}", "", f"`{element.get('name')}` in Python. {words(element)}", "",
             "| property | label | meaning |", "| --- | --- | --- |"]
    for found in element:
        if found.tag in PROPERTIES and found.get("panel_visibility") != "never" and words(found):
            lines.append(f"| `{found.get('name')}` | {found.get('label')} | {words(found)} |")
    return [*lines, ""]


def write():
    groups = {}
    for path in sorted(XMLS.glob("*.xml")):
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            for element in group:
                if element.get("label"):
                    groups.setdefault(group.get("name"), []).extend(proxy(element))
    names = {"sources": "Sources and readers", "filters": "Filters", "writers": "Writers"}
    return "\n".join(line for name, lines in sorted(groups.items(), key=lambda pair: list(names).index(pair[0]) if pair[0] in names else 9)
                     if name in names for line in [f"## {names[name]}", "", *lines])
