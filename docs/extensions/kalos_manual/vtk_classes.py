# SPDX-License-Identifier: BSD-3-Clause
"""One section for each VTK class, by Breathe from Doxygen."""
from pathlib import Path

MODULES = Path(__file__).resolve().parents[3] / "modules"


def write():
    lines = []
    for module in sorted(path.parent for path in MODULES.glob("*/vtk.module")):
        classes = sorted(path.stem for path in module.glob("vtkKalos*.h") if f"class {path.stem}" in heads(path))
        lines += [f"## {module.name}", ""]
        for name in classes:
            lines += [f"### {name}", "", "```{eval-rst}", f".. doxygenclass:: {name}", "   :project: kalos", "```", ""]
    return "\n".join(lines)


def heads(path):
    """The lines that begin a class with an export macro, as `class NAME`."""
    return "\n".join("class " + line.split()[2] for line in path.read_text(encoding="utf-8").splitlines()
                     if line.startswith("class VTK") and len(line.split()) > 3)
