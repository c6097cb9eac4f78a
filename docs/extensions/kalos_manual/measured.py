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

# What a picture is made by, in a scratch folder that {out} stands for, and the file that it leaves there.
PICTURES = {
    "cornell.png": ("{kalos} solve data/cornell/cornell.json --out {out} --trajectories 4096", "front.png"),
    "edge-spikes.png": ("{python} examples/edge_spikes.py {out}", "edge-spikes.png"),
    "first-light.png": ("{python} examples/first_light.py {out}", "first-light.png"),
    "edge-profile.png": ("{python} examples/edge_profile.py {out}", "edge-profile.png"),
    "luminaire.png": ("{python} examples/luminaire.py {out}", "luminaire.png"),
    "neighbourhood.png": ("{python} examples/neighbourhood.py {out}", "neighbourhood.png"),
    "mesh-preparation.png": ("{python} examples/mesh_preparation.py {out}", "mesh-preparation.png"),
    "parameter-study.png": ("{python} examples/parameter_study.py {out}", "sphere-published/study.png"),
    "mpi-hall.png": ("mpiexec -n 2 {python} examples/mpi_hall.py {out}", "mpi-hall.png"),
    "paraview-room.png": ("tests/with_screen pvpython examples/paraview_room.py {out}/room.png --plugin {plugin}", "room.png"),
    "connections.png": ("{python} examples/connections.py {out}", "connections.png"),
    "atlas-edge.png": ("{kalos} atlas --out {out}/atlas", "atlas/furnace-edge.png"),
    "chart.png": ("{python} examples/speed_accuracy.py {out}", "chart.png"),  # with the peers of KALOS_PEERS_PYTHON
}
NOTEBOOKS = ("wall", "spikes", "speed")


def environment(build):
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(build / "python"), os.environ.get("PYTHONPATH", "")])}


def pictures(root, build):
    """Runs the examples, and the notebooks, whose outputs stand in them."""
    plugin = next(build.glob("lib*/paraview-*/plugins/Kalos/Kalos.so"), "")
    for picture, (command, made) in PICTURES.items():
        if picture == "chart.png" and "KALOS_PEERS_PYTHON" not in os.environ:
            continue  # it would lack the peers
        with tempfile.TemporaryDirectory() as out:
            words = command.format(python=sys.executable, kalos=build / "bin" / "kalos", plugin=plugin, out=out).split()
            subprocess.run(words, check=True, cwd=root, env=environment(build))
            shutil.copyfile(Path(out) / made, root / "docs" / "pictures" / picture)
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
