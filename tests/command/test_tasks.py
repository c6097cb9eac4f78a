# SPDX-License-Identifier: BSD-3-Clause
"""Requirements on receiver sets: pass, fail or undecided, in the table, summary.json and the report."""
import json
import re

import numpy as np
import pytest
from conftest import one_line

from kalos.commands.arguments import task
from kalos.report.grid import grid_shape
from kalos.results.tasks import Task

FIGURES = {"mean": 500.0, "mean_standard_error": 5.0, "U0": 0.6, "U0_standard_error": None}


@pytest.mark.parametrize("mean, uniformity, expected", [
    (480, None, "pass"), (489, 0.5, "pass"), (520, None, "fail"), (495, None, "undecided"), (509, None, "undecided"), (511, None, "fail"),
    (480, 0.7, "fail"), (495, 0.7, "fail"), (495, 0.5, "undecided"), (480, 0.6, "pass")])
def test_verdicts(mean, uniformity, expected):
    assert Task("desk", mean, uniformity).judge(FIGURES)["result"] == expected


def test_a_set_without_valid_points_fails():
    assert Task("desk", 1).judge({"mean": None, "mean_standard_error": None})["result"] == "fail"


@pytest.mark.parametrize("text, expected", [
    ("desk:500", Task("desk", 500)), ("desk:300:0.6", Task("desk", 300, 0.6)), ("a:b:200:.4", Task("a:b", 200, 0.4)), ("desk:5:1", Task("desk", 5, 1))])
def test_words(text, expected):
    assert task(text) == expected


def test_in_every_output(scene, command, tmp_path):
    status, out, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, "--report", "--author", "A & B",
                                 "--require", "desk:10:0.1", "--require", "wall:100000")
    assert status == 0, error
    assert "desk: mean 10 lx, U0 0.1 required: pass" in out and "wall: mean 100000 lx required: fail" in out
    told = json.loads((tmp_path / "out" / "summary.json").read_text())["tasks"]
    assert [(one["receivers"], one["result"]) for one in told] == [("desk", "pass"), ("wall", "fail")]
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert re.search(r"<h2>Required values</h2>.*desk.*pass.*wall.*fail", page, re.DOTALL)
    assert re.search(r"<p class='facts'>\d{4}-\d\d-\d\d, by A &amp; B</p>", page)


def test_surfaces_and_grid_points_in_the_report(scene, command, tmp_path):
    scene["materials"]["white"] = {"reflectance": [0.9, 0.8, 0.7], "exitance": 50}
    scene["surfaces"][1]["material"] = "white"
    assert command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, "--report")[0] == 0
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    mean = 0.2126 * 0.9 + 0.7152 * 0.8 + 0.0722 * 0.7
    assert f"<td class=''>wall</td><td class='n'>4.000</td><td class='n'>{mean:.4f}</td><td class='n'>50.00</td>" in page
    assert "<td class=''>floor</td><td class='n'>4.000</td><td class='n'>0.5000</td><td class='n'>0</td>" in page
    grid = re.findall(r"<table class='grid'>(.*?)</table>", page)
    values = [float(line.split(",")[6]) for line in (tmp_path / "out" / "desk.csv").read_text().splitlines()[1:]]
    rows = [[float(cell) for cell in re.findall(r"<td class='n'>([^<]+)</td>", row)] for row in re.findall(r"<tr>(.*?)</tr>", grid[0])[1:]]
    np.testing.assert_allclose(np.array(rows)[::-1, 1:].ravel(), values, rtol=1e-3)  # v grows upwards
    np.testing.assert_allclose(np.array(rows)[::-1, 0], [0, 0.5])


@pytest.mark.parametrize("rows, columns", [(3, 4), (1, 5), (5, 1), (2, 2)])
def test_grid_shape(rows, columns):
    i, j = np.indices((rows, columns)).reshape(2, -1)
    points = np.array([1.0, 2, 3]) + j[:, None] * np.array([0.5, 0.1, 0]) + i[:, None] * np.array([-0.1, 0.3, 0.2])
    assert grid_shape(points) in ((rows, columns), (1, rows) if columns == 1 else (rows, columns))
    points[-1] += 0.01
    assert grid_shape(points) != (rows, columns) or rows * columns == 1


@pytest.mark.parametrize("value, message", [
    ("desk", "--require: 'desk' is not allowed, expected NAME:LX or NAME:LX:U0, such as desk:500:0.6; kalos solve --help tells more"),
    ("desk:many", "--require: 'desk:many' is not allowed, expected NAME:LX or NAME:LX:U0, such as desk:500:0.6; kalos solve --help tells more"),
    ("table:500", "--require: 'table' is no receiver set, expected one of desk, wall, probe")])
def test_message(scene, command, tmp_path, value, message):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--require", value)
    assert status == 2 and one_line(error) == message and not (tmp_path / "out").exists()


def test_tasks_of_the_scene(scene, command, tmp_path):
    """A receiver set, and an observer, may say what is required of them; --require has precedence."""
    scene["receivers"][0]["task"] = {"mean": 10, "U0": 0.1}
    scene["receivers"][1]["task"] = {"mean": 10}
    scene["receivers"].append({"name": "seat", "observer": {"position": [1, 0.2, 1], "target": [1, 0.8, 1]}, "task": {"UGR": 90}})
    status, out, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, "--report", "--require", "wall:100000")
    assert status == 0, error
    told = {one["receivers"]: one for one in json.loads((tmp_path / "out" / "summary.json").read_text())["tasks"]}
    assert {name: one["result"] for name, one in told.items()} == {"desk": "pass", "seat": "pass", "wall": "fail"}
    assert told["seat"]["required_UGR"] == 90 and "seat: UGR at most 90 required: pass" in out
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "<td class='n'>90</td>" in page and "none is applied, values are those of new luminaires" in page


@pytest.mark.parametrize("ugr, error, expected", [(18.0, 0.1, "pass"), (20.0, 0.1, "fail"), (19.1, 0.1, "undecided"), (None, None, "pass")])
def test_glare_is_an_upper_limit(ugr, error, expected):
    assert Task("seat", glare=19).judge({"UGR": ugr, "UGR_standard_error": error})["result"] == expected


@pytest.mark.parametrize("task, where", [({"mean": 0}, "task.mean: found 0; expected a number above 0"),
                                         ({"mean": 5, "U0": 1.5}, "task.U0: found 1.5; expected a number above 0 and at most 1"),
                                         ({"U0": 0.5}, 'task: the key "mean" is missing'), ({"mean": 5, "UGR": 19}, 'task: unknown key "UGR"')])
def test_a_wrong_task(scene, command, tmp_path, task, where):
    scene["receivers"][0]["task"] = task
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out")
    assert status == 2 and f"receivers.desk.{where}" in one_line(error)


def test_maintenance_factor(scene, command, tmp_path):
    """It scales the flux of all luminaires, or of one, and every output states it."""
    def mean(**factors):
        scene.update({key: value for key, value in factors.items() if key == "maintenance_factor"})
        if "own" in factors:
            scene["luminaires"][0]["maintenance_factor"] = factors["own"]
        status, out, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, "--report")
        assert status == 0, error
        return json.loads((tmp_path / "out" / "summary.json").read_text())["receivers"]["desk"]["mean"], out

    new, out = mean()
    assert "maintenance factor" not in out
    maintained, out = mean(maintenance_factor=0.8)
    assert maintained == pytest.approx(0.8 * new, rel=1e-6) and re.search(r"maintenance factor +0.8 of the flux of 1 luminaires", out)
    own, _ = mean(own=0.5)
    assert own == pytest.approx(0.5 * new, rel=1e-6)
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "maintained flux, lm" in page and "0.5 of the flux of 1 luminaires" in page


@pytest.mark.parametrize("factor", [0, 1.01, "0.8"])
def test_a_wrong_maintenance_factor(scene, command, tmp_path, factor):
    scene["maintenance_factor"] = factor
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out")
    assert status == 2 and "maintenance_factor: " in one_line(error)
