# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, here with less effort, say what they should, and leave a picture with something in it."""
import csv
import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def example(monkeypatch):
    """Loads an example with some of its constants replaced."""

    def load(name, **constants):
        spec = importlib.util.spec_from_file_location(name, ROOT / "examples" / f"{name}.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        for constant, value in constants.items():
            assert hasattr(module, constant)
            monkeypatch.setattr(module, constant, value)
        return module

    return load


def colours(path):
    return len(np.unique(imread(path)[..., :3].reshape(-1, 3), axis=0))


def test_first_light(example, tmp_path, capsys):
    example("first_light", ERROR=0.5, PIXELS=(24, 18), TRAJECTORIES=320).main(tmp_path)
    words = capsys.readouterr().out.split()
    assert words[:2] == ["desk:", "mean"] and 250 < float(words[2]) < 350  # 300 lx
    assert colours(tmp_path / "first-light.png") > 200


def test_scene_changes(example, tmp_path, capsys):
    example("scene_changes", TRAJECTORIES=320).main(tmp_path)
    dark, light, alone = (float(line.split("lx")[0].split()[-1]) for line in capsys.readouterr().out.splitlines())
    assert alone < dark < light
    scene = json.loads((tmp_path / "office.json").read_text())
    assert scene["materials"]["walls"] == {"reflectance": 0.75} and len(scene["luminaires"]) == 3
    assert colours(tmp_path / "dark" / "task.png") > 50 and (tmp_path / "light" / "floor.csv").exists()


def test_edge_profile(example, tmp_path):
    module = example("edge_profile", SEEDS=range(1, 5), TRAJECTORIES=2000, DISTANCES=np.geomspace(1e-4, 1, 5),
                     METHODS=("local", "clamped", "compensated"))
    module.main(tmp_path)
    rows = list(csv.DictReader((tmp_path / "edge-profile.csv").open(encoding="ascii")))
    error = {(row["method"], float(row["distance_m"])): float(row["rms_error"]) for row in rows}
    mean = {(row["method"], float(row["distance_m"])): float(row["mean_over_truth"]) for row in rows}
    near, far = module.DISTANCES[[0, -1]].tolist()
    assert error["compensated", near] < 0.05 and error["clamped", far] < 0.1
    assert 0.6 < mean["clamped", near] < 0.85  # half of the reflected light comes from the wall: 1 - 0.6 / 2 is left
    assert error["local", near] > 0.2
    assert colours(tmp_path / "edge-profile.png") > 50


def test_connections(example, tmp_path):
    module = example("connections", SEEDS=range(1, 5), TRAJECTORIES=256, SCENES=("furnace-edge",), CONNECTIONS=(1, 2, 4))
    module.main(tmp_path)
    (row,) = csv.DictReader((tmp_path / "connections.csv").open(encoding="ascii"))
    assert row["scene"] == "Beside an edge of the white furnace" and float(row["1_over_all"]) > 10  # spikes
    assert colours(tmp_path / "connections.png") > 50


def test_parameter_study(example, tmp_path, capsys):
    example("parameter_study", PIXELS=5, REFERENCE=3200, METHODS=("sphere-published",)).main(tmp_path)
    words = capsys.readouterr().out
    assert words.startswith("sphere-published, N = 10000, delta = 0.25 m, epsilon = 0.15 m: error near edges ")
    cells = json.loads((tmp_path / "sphere-published" / "study.json").read_text(encoding="utf-8"))["cells"]
    assert len(cells) == 11  # the cross of the table, and compensated with its three numbers of trajectories
    assert colours(tmp_path / "sphere-published" / "study.png") > 200


def test_speed_accuracy(example, tmp_path, capsys):
    module = example("speed_accuracy", METHODS=("compensated",), BUDGET=0.1, REFERENCE=320)
    module.main(tmp_path / "out", peers=())
    said = capsys.readouterr().out.splitlines()[-5:]
    assert [line.split(":")[0] for line in said] == ["5 %", "2 %", "1 %", "0.5 %", "0.3 %"]
    assert colours(tmp_path / "out" / "chart.png") > 50
    times = [{"label": name, "seconds_to": {"1 %": {"cpu_seconds": s}}} for name, s in (("a", None), ("b", 3.0), ("c", 2.0))]
    assert module.fastest({"contenders": times}, "1 %") == (2.0, "c")
    assert module.fastest({"contenders": times[:1]}, "1 %") is None


def test_luminaire(example, tmp_path, capsys):
    example("luminaire", COLUMNS=20, ROWS=4, ERROR=0.2, MOST=3200).main(tmp_path)
    words = capsys.readouterr().out
    mean, direct = (float(part.split("mean ")[1].split()[0]) for part in words.split(";"))
    # Of 6000 lm at most all lands on the 20 m2 of the floor; with what walls and ceiling return more than directly.
    assert direct < 6000 / 20 and 1.2 * direct < mean < 1.8 * direct
    assert colours(tmp_path / "luminaire.png") > 200


def test_edge_spikes(example, tmp_path, capsys):
    """Plain local estimation is far brighter in places than final gathering, and as bright in the mean."""
    example("edge_spikes", PIXELS=(60, 44), TRAJECTORIES={"local": 512, "gathered": 4096}).main(tmp_path)
    found = {line.split(":")[0]: [float(word) for word in line.split() if word.replace(".", "").isdigit()]
             for line in capsys.readouterr().out.splitlines()}
    assert 0.8 < found["local"][0] / found["gathered"][0] < 1.25 and found["local"][1] > 1.5 * found["gathered"][1]
    assert colours(tmp_path / "edge-spikes.png") > 100


@pytest.mark.skipif(not shutil.which("mpiexec"), reason="no mpiexec here")
def test_mpi_hall(tmp_path):
    """The same digest from one process and from three."""
    program = (ROOT / "examples" / "mpi_hall.py").read_text(encoding="utf-8")
    small = tmp_path / "hall.py"
    small.write_text(program.replace("TRAJECTORIES = 90, 60, 1600", "TRAJECTORIES = 6, 4, 320"), encoding="utf-8")
    assert small.read_text(encoding="utf-8") != program
    mpiexec = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", "3"]
    said = []
    for front, out in (([], tmp_path / "one"), (mpiexec, tmp_path / "three")):
        done = subprocess.run([*front, sys.executable, small, out], capture_output=True, text=True, timeout=120, check=False)
        assert done.returncode == 0, done.stderr
        said.append(done.stdout)
        assert colours(out / "mpi-hall.png") > 50
    assert said[0].startswith("1 ranks: ") and said[1].startswith("3 ranks: ")
    assert said[0].split("digest ")[1] == said[1].split("digest ")[1]


@pytest.mark.parametrize("name", ["edge-spikes", "first-light", "edge-profile", "luminaire", "mpi-hall", "parameter-study", "paraview-room"])
def test_pictures_of_the_documentation_are_small(name):
    assert (ROOT / "docs" / "pictures" / f"{name}.png").stat().st_size < 200_000
