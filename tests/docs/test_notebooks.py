# SPDX-License-Identifier: BSD-3-Clause
"""The tutorials run as Jupyter runs them, here with small numbers, and leave what their words promise."""
import os
import sys
from pathlib import Path

import pytest
from pages import DOCS, ROOT

nbformat = pytest.importorskip("nbformat", reason="no Jupyter")
pytest.importorskip("nbclient", reason="no Jupyter")
pytest.importorskip("ipykernel", reason="no Jupyter kernel")
sys.path.insert(0, str(DOCS / "extensions"))
from kalos_manual.measured import NOTEBOOKS, executed  # noqa: E402

FOLDER = ROOT / "examples" / "notebooks"
SMALL = {"wall": [("POINTS = 25", "POINTS = 7"), ("ERROR = 0.01", "ERROR = 0.05")],
         "spikes": [("SEEDS = 24", "SEEDS = 6"), ("TRAJECTORIES = 2000", "TRAJECTORIES = 800")],
         "speed": [("BUDGET = 2.0", "BUDGET = 0.1"), ("REFERENCE = 20000", "REFERENCE = 320")]}


def smaller(name):
    """Replaces the constants of a notebook; each must be there."""
    left = dict(SMALL[name])

    def change(source):
        for old in [one for one in left if one in source]:
            source = source.replace(old, left.pop(old))
        return source

    return change, left


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_it_runs(name):
    change, left = smaller(name)
    text = executed(FOLDER / f"{name}.ipynb", Path(os.environ["KALOS_BUILD"]), change)
    assert not left
    book = nbformat.reads(text, as_version=4)
    kinds = [set(output.get("data", {})) for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]
    assert any("image/png" in kind for kind in kinds)
    said = "".join(output.get("text", "") for cell in book.cells if cell.cell_type == "code" for output in cell.outputs)
    if name == "spikes":
        mean = {line.split()[0]: float(line.split("mean ")[1].split()[0]) for line in said.splitlines() if "within 1 cm" in line}
        assert mean["clamped"] < 0.85 and mean["sphere-exact"] < 0.9 and abs(mean["compensated"] - 1) < 0.03
    if name == "wall":
        assert float(said.split("off by at most ")[1].split("%")[0]) < 10


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_it_shows_its_outputs(name):
    book = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    nbformat.validate(book)
    assert any(cell.outputs for cell in book.cells if cell.cell_type == "code"), "docs/make --pictures runs it"
    assert (FOLDER / f"{name}.ipynb").stat().st_size < 400_000
