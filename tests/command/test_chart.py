# SPDX-License-Identifier: BSD-3-Clause
"""`kalos chart`: its files, its output and its errors."""
import csv
import json
import xml.etree.ElementTree as xml
from types import SimpleNamespace

import numpy as np
import pytest
from conftest import one_line
from matplotlib.image import imread

from kalos.charts.chart import climb
from kalos.charts.contenders import View
from kalos.charts.convergence import Truth
from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.results.receivers import from_dataset, point_receivers
from kalos.validation.cases import DATA
from kalos.validation.verdicts import allowed_deviation

SHORT = ("--peers", "none", "--budget", 0.3, "--reference-trajectories", 6400)


@pytest.fixture
def chart(scene, command, tmp_path):
    path = scene.save()

    def run(*arguments, of=path):
        status, out, error = command("chart", of, "--out", tmp_path / "out", *SHORT, *arguments)
        return tmp_path / "out", status, out, error

    return run


def test_table_and_pictures(chart):
    folder, status, out, error = chart("--receivers", "desk", "--methods", "local,compensated")
    assert status == 0, error
    rows = list(csv.DictReader((folder / "chart.csv").open()))
    for name in ("local", "compensated"):
        own = [row for row in rows if row["contender"] == name]
        efforts = [int(row["effort"]) for row in own]
        assert len(own) >= 2 and all(after / before in (2, 4) for before, after in zip(efforts, efforts[1:]))
        # Eight receivers and four seeds: an error of 32 values is known to an eighth; a hundredth would need a wonder.
        assert float(own[-1]["rms_of_value"]) < float(own[0]["rms_of_value"])
        assert all(float(row["rms_of_value"]) <= float(row["max_of_value"]) for row in own)
        assert all(float(row["cpu_seconds"]) > 0 and float(row["rays"]) > 0 for row in own)
    result = json.loads((folder / "chart.json").read_text())
    assert result["receivers"] == "desk" and result["lit"] == 8 and 0 < result["reference"]["rms"] < 0.05
    assert "processor time to" in out and "Kalos, compensated" in out and "compensated      trajectories" in error
    picture = imread(folder / "chart.png")
    np.testing.assert_array_equal(picture[[0, 0, -1, -1], [0, -1, 0, -1], :3], 1)
    assert xml.parse(folder / "chart.svg").getroot().tag.endswith("svg")


class Costly:
    """A method of 64 values with an error of 1/sqrt(effort), whose every run takes a second, and 0.2 ms a trajectory."""

    NAME, EFFORT, START = "costly", "trajectories", 128

    def solve(self, effort, seed):
        values = 1 + np.random.default_rng(seed).normal(size=64) / np.sqrt(effort)
        return SimpleNamespace(values=values, cpu_seconds=1 + 2e-4 * effort, effort=effort, rays=None)


def test_steps_that_cost_the_same_are_passed_quickly():
    rows, _ = climb(Costly(), Truth(np.ones(64), np.zeros(64), "one"), 60, 1)
    efforts = [row["effort"] for row in rows]
    assert efforts == [128, 256, 1024, 4096, 8192, 16384] and {row["seeds"] for row in rows} == {4}


@pytest.mark.parametrize("scene_file", ["furnace/furnace.json", "chart/edge-furnace.json", "chart/sobolev-row.json"])
def test_closed_form_is_the_reference_where_there_is_one(chart, scene_file):
    folder, status, _, error = chart("--methods", "compensated", of=DATA / scene_file)
    assert status == 0, error
    result = json.loads((folder / "chart.json").read_text())
    assert result["reference"] == {"source": "closed form", "file": None, "rms": 0.0}
    # Unbiased: the mean over the receivers within six of its standard errors at every step.
    assert all(abs(row["mean_off"]) < max(6 * row["mean_off_error"], 0.02) for row in result["steps"])


def test_gathered_states_its_bias(chart):
    folder, status, out, error = chart("--receivers", "desk", "--methods", "gathered,compensated")
    assert status == 0, error
    gathered, compensated = json.loads((folder / "chart.json").read_text())["contenders"]
    own = gathered["bias"]
    assert abs(own["stated"]) < 6 * own["stated_error"] + 0.02 and own["stated_error"] < 0.05
    assert abs(own["mean"]) < 6 * own["mean_error"] + 0.02
    assert "stated" not in compensated["bias"]
    assert "Kalos, gathered: bias " in out and "by its own account; 95 % of the values are within " in out


def test_an_image(chart, scene):
    """Pixel for pixel the same light: what a camera sees of a floor is rho E / pi of the points that it sees there."""
    folder, status, out, error = chart("--camera", "front", "--methods", "gathered,compensated")
    assert status == 0, error
    result = json.loads((folder / "chart.json").read_text())
    assert result["receivers"] == "front" and result["quantity"] == "luminance"
    view = View(scene.save(), "front")
    assert result["lit"] + result["dark"] == len(view.points) == view.seen.sum() < 16 * 12
    for one in result["contenders"]:
        steps = [row["rms_of_value"] for row in result["steps"] if row["contender"] == one["name"]]
        assert steps[-1] < steps[0]
    # The same by hand, through the points and the response that peers get.
    seen = view.solve(Options(trajectories=32000), None)
    estimator = illuminance_filter(view.reader, Options(trajectories=32000, seed=2))
    estimator.SetInputDataObject(0, point_receivers(view.points, view.normals))
    update(estimator)
    found = from_dataset("points", estimator.GetOutputDataObject(0))
    luminance, error = (view.response.sum(axis=1) * values for values in (found.illuminance, found.standard_error))
    assert (abs(seen.values - luminance) < allowed_deviation(len(luminance)) * np.hypot(seen.standard_error, error) + 1e-6).all()
    assert np.median(error / luminance) < 0.01


@pytest.mark.parametrize("arguments, message", [
    (("--camera", "moon"), "--camera: 'moon' is not in "),
    (("--camera", "front", "--receivers", "desk"), "--camera: there are --receivers already, expected one of the two"),
    (("--receivers", "moon"), "--receivers: 'moon' is not in "),
    (("--methods", "magic"), "--methods: 'magic' is not allowed, expected one of "),
    (("--peers", "povray"), "--peers: 'povray' is not allowed, expected none, or some of mitsuba, radiance, radiance-cached; "),
    (("--budget", "0"), "--budget: '0' is not allowed, expected a time > 0, in seconds; "),
    (("--threads", "0"), "--threads: '0' is not allowed, expected a whole number from 1 to 1024; ")])
def test_bad_options(chart, arguments, message):
    folder, status, _, error = chart(*arguments)
    assert status == 2
    assert one_line(error).startswith(message)
    assert not folder.exists()


def test_a_scene_without_receivers(scene, chart):
    del scene["receivers"]
    path = scene.save()
    _, status, _, error = chart()
    assert status == 2
    assert one_line(error) == f"{path}: receivers: there are none, expected a scene with receivers"
