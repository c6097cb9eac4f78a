# SPDX-License-Identifier: BSD-3-Clause
"""The example that charts the error over delta and epsilon runs, here on one scene and with little effort."""
import csv
import importlib.util
from pathlib import Path

from matplotlib.image import imread

PROGRAM = Path(__file__).resolve().parents[2] / "examples" / "neighbourhood.py"


def test_writes_table_and_chart(tmp_path, monkeypatch):
    spec = importlib.util.spec_from_file_location("neighbourhood", PROGRAM)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    for name, value in (("SCENES", {"furnace, boxes": "furnace/furnace.json"}), ("POINTS", 30), ("TRAJECTORIES", 3200),
                        ("SEEDS", (1,)), ("LENGTHS", (0.05, 0.2, 0.8))):
        monkeypatch.setattr(example, name, value)
    example.main(tmp_path)
    rows = list(csv.DictReader((tmp_path / "neighbourhood.csv").open(encoding="utf-8")))
    assert [row["series"] for row in rows] == ["rule"] * 2 + ["none"] + ["delta"] * 6 + ["epsilon"] * 3
    errors = [float(row["rms_near"]) for row in rows]
    assert errors[2] == min(errors)  # compensated
    assert 0.05 < float(rows[0]["delta_m"]) < 0.8
    assert imread(tmp_path / "neighbourhood.png").shape[0] > 500
