# SPDX-License-Identifier: BSD-3-Clause
"""A page from a notebook of examples/notebooks: its words, its cells, and what these gave when it was last run."""
import base64
import json
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
ANSI = re.compile(r"\x1b\[[0-9;]*m")


def text(value):
    return value if isinstance(value, str) else "".join(value)


def shown(output, stem, number):
    """The Markdown of one output of a cell; pictures are files of docs/tutorials/pictures, which git does not keep."""
    data = output.get("data", {})
    if "image/png" in data:
        folder = ROOT / "docs" / "tutorials" / "made"
        folder.mkdir(exist_ok=True)
        path = folder / f"{stem}-{number}.png"
        path.write_bytes(base64.b64decode(text(data["image/png"])))
        return [f"![Output of the cell above](made/{path.name})", ""]
    words = text(output.get("text", data.get("text/plain", ""))).rstrip()
    return ["```text", ANSI.sub("", words), "```", ""] if words else []


def write(name):
    book = json.loads((ROOT / "examples" / "notebooks" / f"{name}.ipynb").read_text(encoding="utf-8"))
    lines, number = [], 0
    for cell in book["cells"]:
        source = text(cell["source"])
        if cell["cell_type"] == "markdown":
            lines += [source, ""]
            continue
        lines += ["```python", source, "```", ""]
        for output in cell["outputs"]:
            number += 1
            lines += shown(output, name, number)
    return "\n".join(lines)
