# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, here with less effort, say what they should, and leave a picture with something in it."""
import csv
import importlib.util
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


@pytest.mark.parametrize("name", ["first-light", "edge-profile"])
def test_pictures_of_the_documentation_are_small(name):
    assert (ROOT / "docs" / f"{name}.png").stat().st_size < 150_000
