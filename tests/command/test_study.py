# SPDX-License-Identifier: BSD-3-Clause
"""`kalos study`: its files, the reference that it keeps, and its errors."""
import csv
import json
import os

import numpy as np
import pytest
from conftest import one_line
from matplotlib.image import imread

SMALL = ("--trajectories", 640, "--reference-trajectories", 6400)


@pytest.fixture
def study(scene, command, tmp_path):
    path = scene.save()

    def run(*arguments):
        status, out, error = command("study", path, "--out", tmp_path / "out", *SMALL, *arguments)
        return tmp_path / "out", status, out, error

    return run


def rows_of(folder):
    return list(csv.DictReader((folder / "study.csv").open()))


def test_every_combination_and_compensated(study):
    folder, status, out, error = study("--sweep", "method=sphere-exact,clamped", "--sweep", "delta=auto,0.3")
    assert status == 0, error
    rows = rows_of(folder)
    assert [(row["method"], row["delta_m"]) for row in rows] == [
        ("sphere-exact", ""), ("sphere-exact", "0.3"), ("clamped", ""), ("clamped", "0.3"), ("compensated", "")]
    for row in rows:
        assert int(row["trajectories"]) == 640
        assert 0 < float(row["rms_near"]) < 5 and 0 < float(row["rms_elsewhere"]) < 2 and abs(float(row["bias"])) < 0.2
        assert float(row["cpu_seconds"]) > 0
    result = json.loads((folder / "study.json").read_text())
    assert [cell["rms_near"] for cell in result["cells"]] == [float(row["rms_near"]) for row in rows]
    assert 0 < result["values_near"] < result["values"] < 16 * 12  # some pixels see nothing
    assert "study of front" in out and "sphere-exact" in out
    picture = imread(folder / "study.png")
    np.testing.assert_array_equal(picture[[0, 0, -1, -1], [0, -1, 0, -1], :3], 1)


def test_reference_is_kept_as_long_as_the_scene(scene, study):
    folder, status, _, error = study("--sweep", "seed=1,2")
    assert status == 0 and "reference  " in error
    first = json.loads((folder / "study.json").read_text())
    _, status, _, error = study("--sweep", "seed=1,2")
    assert status == 0 and "reference  " not in error
    again = json.loads((folder / "study.json").read_text())
    assert [cell["rms_near"] for cell in again["cells"]] == [cell["rms_near"] for cell in first["cells"]]
    scene["luminaires"][0]["flux"] = 1001
    scene.save()
    _, status, _, error = study("--sweep", "seed=1,2")
    assert status == 0 and "reference  " in error
    assert len([name for name in os.listdir(folder) if name.startswith("reference-")]) == 2


def test_table1_is_a_cross(study):
    folder, status, _, error = study("--table1")
    assert status == 0, error
    settings = [(row["method"], int(row["trajectories"]), row["delta_m"], row["epsilon_m"]) for row in rows_of(folder)]
    assert settings == [("sphere-published", 10000, "0.25", "0.15"), ("sphere-published", 1000, "0.25", "0.15"),
                        ("sphere-published", 100, "0.25", "0.15"), ("sphere-published", 10000, "0.25", "0.05"),
                        ("sphere-published", 10000, "0.25", "0.1"), ("sphere-published", 10000, "0.01", "0.15"),
                        ("sphere-published", 10000, "0.05", "0.15"), ("sphere-published", 10000, "0.1", "0.15"),
                        ("compensated", 10000, "", ""), ("compensated", 1000, "", ""), ("compensated", 100, "", "")]


@pytest.mark.parametrize("without", ["wall", "desk"])
def test_receivers_where_there_is_no_camera(scene, study, without):
    del scene["cameras"]
    scene["receivers"] = [one for one in scene["receivers"] if one["name"] == "probe" or one["name"] != without]
    scene.save()
    folder, status, _, error = study("--sweep", "method=local,disc")
    assert status == 0, error
    assert all(0 <= float(row["untrusted_share"]) <= 1 for row in rows_of(folder))


@pytest.mark.parametrize("arguments, message", [
    ((), "--sweep: missing, expected NAME=v1,v2,... or --table1"),
    (("--sweep", "delta=1,1"), "--sweep: delta: a value appears twice in '1,1', expected each once; kalos study --help tells "
                               "more"),
    (("--sweep", "depth=1"), "--sweep: 'depth=1' is not allowed, expected NAME=v1,v2,... with a NAME out of trajectories, "
                             "delta, epsilon, method, seed; kalos study --help tells more"),
    (("--sweep", "delta=-1"), "--sweep: delta: '-1' is not allowed, expected auto, or a length > 0 in metres; kalos study "
                              "--help tells more"),
    (("--sweep", "method=magic"), "--sweep: method: 'magic' is not allowed, expected one of "),
    (("--sweep", "delta=0.1,0.2"), "--sweep: delta has no effect on compensated, expected --method sphere-exact or another "
                                   "with such a neighbourhood"),
    (("--sweep", "seed=1", "--sweep", "seed=2"), "--sweep: seed appears twice, expected each name once"),
    (("--sweep", "seed=" + ",".join(map(str, range(401)))), "--sweep: 401 combinations, expected at most 400"),
    (("--table1", "--sweep", "seed=1"), "--table1: given together with --sweep, expected one of them"),
    (("--method", "sphere-exact", "--sweep", "delta=3"),
     "--delta: is 3 m, expected auto, or a length up to the size of the scene, 2 m")])
def test_bad_sweep(study, arguments, message):
    folder, status, _, error = study(*arguments)
    assert status == 2
    last = error.splitlines()[-1] + "\n"  # a bar of progress may have come before
    assert one_line(last).startswith(message)
    assert not folder.exists()


def test_a_spoilt_reference_is_refused(study):
    folder, status, _, _ = study("--sweep", "seed=1")
    reference, = [folder / name for name in os.listdir(folder) if name.startswith("reference-")]
    reference.write_bytes(b"spoilt")
    _, status, _, error = study("--sweep", "seed=1")
    assert status == 2
    assert f"kalos: error: {reference}: file: not a reference that can be read" in error
