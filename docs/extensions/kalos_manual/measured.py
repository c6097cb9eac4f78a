# SPDX-License-Identifier: BSD-3-Clause
"""What the manual shows of runs that take minutes: the pictures of the examples, and the figures of `kalos validate`."""
import datetime
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PICTURES = {"edge_spikes": "edge-spikes.png", "first_light": "first-light.png", "edge_profile": "edge-profile.png",
            "luminaire": "luminaire.png", "neighbourhood": "neighbourhood.png", "mesh_preparation": "mesh-preparation.png"}
NOTEBOOKS = ("wall", "spikes", "speed")


def environment(build):
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(build / "python"), os.environ.get("PYTHONPATH", "")])}


def pictures(root, build):
    """Runs the examples, and the notebooks, whose outputs stand in them."""
    with tempfile.TemporaryDirectory() as scratch:
        for name, picture in PICTURES.items():
            subprocess.run([sys.executable, root / "examples" / f"{name}.py", scratch], check=True, env=environment(build))
            shutil.copyfile(Path(scratch) / picture, root / "docs" / "pictures" / picture)
    for name in NOTEBOOKS:
        path = root / "examples" / "notebooks" / f"{name}.ipynb"
        path.write_text(executed(path, build), encoding="utf-8")


def executed(path, build, cells=lambda source: source):
    """A notebook as text, run by Jupyter in its folder; `cells` may change the sources that run."""
    import nbclient
    import nbformat

    book = nbformat.read(path, as_version=4)
    for cell in book.cells:
        if cell.cell_type == "code":
            cell.source = cells(cell.source)
    os.environ.update(environment(build))
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(path.parent)}}).execute()
    for cell in book.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":  # without progress bars
            cell.outputs = [output for output in cell.outputs if output.get("name") != "stderr"]
    return json.dumps(book, indent=1, ensure_ascii=False) + "\n"


def figures(root, build):
    """The table of `kalos validate --figures`, with version and date."""
    command = [build / "bin" / "kalos", "validate", "--figures"]
    version = subprocess.run([command[0], "--version"], check=True, capture_output=True, text=True).stdout.strip()
    found = subprocess.run(command, check=False, capture_output=True, text=True)
    if found.returncode:
        sys.exit(f"docs/make: kalos validate --figures fell short\n{found.stdout}{found.stderr}")
    head = f"{version}, {datetime.date.today()}: kalos validate --figures\n"
    (root / "docs" / "validation" / "figures.txt").write_text(head + found.stdout, encoding="utf-8")
