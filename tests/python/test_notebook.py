# SPDX-License-Identifier: BSD-3-Clause
"""Results in Jupyter: a cell that ends in one shows its picture, and its line where there are no pictures."""
import base64

import pytest

import kalos

CELL = """
import numpy as np
import kalos
room = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
lamp = kalos.luminaire((2, 2, 2.9), 3000)
x, y = np.meshgrid(np.linspace(0.5, 3.5, 4), np.linspace(0.5, 3.5, 4))
"""
ILLUMINANCE = CELL + "kalos.illuminance(room, lamp, np.stack([x, y, 0 * x + 0.75], axis=-1), (0, 0, 1), trajectories=64)\n"
LUMINANCE = CELL + "kalos.luminance(room, lamp, (2, 0.1, 1.5), (2, 4, 1.5), resolution=(8, 6), trajectories=64)\n"
PNG = b"\x89PNG\r\n\x1a\n"


def test_ipython_shows_the_picture():
    shell = pytest.importorskip("IPython.core.interactiveshell", reason="no IPython").InteractiveShell.instance()
    for code, kind in ((ILLUMINANCE, kalos.Illuminance), (LUMINANCE, kalos.Luminance)):
        ran = shell.run_cell(code)
        ran.raise_error()
        shown, _ = shell.display_formatter.format(ran.result)
        assert isinstance(ran.result, kind) and shown["image/png"].startswith(PNG)
        assert "trajectories of compensated" in shown["text/plain"]


def test_a_notebook(tmp_path):
    """Run as Jupyter runs it, in a kernel of its own."""
    pytest.importorskip("ipykernel", reason="no Jupyter kernel")
    nbclient, nbformat = (pytest.importorskip(name, reason="no Jupyter") for name in ("nbclient", "nbformat"))
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code) for code in (ILLUMINANCE, LUMINANCE)])
    nbclient.NotebookClient(book, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    for cell in book.cells:
        shown, = (output.data for output in cell.outputs if output.output_type == "execute_result")
        assert base64.b64decode(shown["image/png"]).startswith(PNG) and "text/plain" in shown
