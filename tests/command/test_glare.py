# SPDX-License-Identifier: BSD-3-Clause
"""UGR of observers, and the standard errors of figures over many receivers."""
import json
import math
from pathlib import Path

import numpy as np
import pytest

from kalos.core.options import Options
from kalos.preparation.scene import UNPREPARED
from kalos.scenes.reading import read_scene
from kalos.solving.glare import rate_glare
from kalos.solving.solve import estimate, solve, summarise

SPHERE = Path(__file__).resolve().parents[2] / "data" / "sphere" / "sphere-3.obj"
FLUX, RHO = 1000.0, 0.6


@pytest.fixture
def sphere(tmp_path):
    """A lamp at the centre of a unit sphere, and an eye that sees it straight ahead, from (0, -0.5, 0.1)."""

    def write(**more):
        scene = {"kalos": 1, "materials": {"white": {"reflectance": RHO}},
                 "surfaces": [{"name": "sphere", "file": str(SPHERE), "material": "white"}],
                 "luminaires": [{"name": "lamp", "position": [0, 0, 0], "flux": FLUX, "distribution": "isotropic"}],
                 "receivers": [{"name": "eye", "observer": {"position": [0, -0.5, 0], "target": [0, 0, -0.1]}}], **more}
        path = tmp_path / "scene.json"
        path.write_text(json.dumps(scene))
        return path

    return write


def test_photometric_sphere(sphere, tmp_path):
    """Everywhere E_indirect = rho Phi / (4 pi R^2 (1 - rho)); the lamp is a small source of CIE 147, 200 I^2 / (d^2 p^2).

    The sphere is of 1280 triangles, 0.5 % smaller than the round one: 0.02 in UGR. 4.5 standard errors: below 1e-5.
    """
    result = solve(sphere(), tmp_path / "out", Options(trajectories=6400))
    background = RHO * FLUX / (4 * math.pi**2 * (1 - RHO))
    slope = math.degrees(math.atan(0.2))
    index = math.exp((35.2 - 1.22) * 1e-3 * slope + 21e-5 * slope**2)
    intensity = FLUX / (4 * math.pi)
    truth = 8 * math.log10(0.25 / background * 200 * intensity**2 / 0.25 / index**2)
    eye = result["observers"]["eye"]
    assert abs(eye["background_luminance"] / background - 1) < 0.01 + 4.5 * eye["background_luminance_standard_error"] / background
    assert abs(eye["UGR"] - truth) < 0.04 + 4.5 * eye["UGR_standard_error"]
    assert 0 < eye["UGR_standard_error"] < 0.2 and eye["sources"] == 1
    assert any(line["subject"] == "glare" and "CIE 147" in line["reason"] for line in result["audit"])


def test_it_is_printed_and_reported(sphere, command, tmp_path):
    status, out, error = command("solve", sphere(), "--out", tmp_path / "out", "--trajectories", 640, "--report")
    assert status == 0, error
    eye = json.loads((tmp_path / "out" / "summary.json").read_text())["observers"]["eye"]
    line = f"{eye['UGR']:.2f} ± {eye['UGR_standard_error']:.2g}"
    assert "observer  " in out and line in out
    page = (tmp_path / "out" / "report.html").read_text()
    assert "Discomfort glare" in page and line in page


def test_standard_errors_are_the_spread_over_seeds(sphere, tmp_path):
    """40 seeds: the spread of UGR, mean and U0 over their mean standard error lies within 0.6 and 1.6 (chi-square with 39
    degrees of freedom, and that of the errors with 7 each: beyond below 1e-4 a figure)."""
    plane = {"name": "desk", "plane": {"origin": [-0.3, -0.3, -0.5], "u": [0.6, 0, 0], "v": [0, 0.6, 0], "resolution": [4, 4]}}
    path = sphere(receivers=[{"name": "eye", "observer": {"position": [0, -0.5, 0], "target": [0, 0, -0.1]}}, plane])
    reader = read_scene(path)

    def figures(options):
        receivers, images, outputs = estimate(reader, options, UNPREPARED)
        return {"observers": rate_glare(reader, receivers, UNPREPARED)[0], **summarise(path, options, receivers, images, outputs)}

    found = [figures(Options(trajectories=320, seed=seed)) for seed in range(1, 41)]
    for section, name, key in (("observers", "eye", "UGR"), ("observers", "eye", "background_luminance"),
                               ("receivers", "desk", "mean"), ("receivers", "desk", "U0"), ("receivers", "desk", "Ud")):
        values = np.array([one[section][name][key] for one in found])
        errors = np.array([one[section][name][f"{key}_standard_error"] for one in found])
        assert 0.6 < values.std(ddof=1) / errors.mean() < 1.6, key


def test_no_source_in_sight_and_no_background(sphere, tmp_path):
    away = sphere(receivers=[{"name": "eye", "observer": {"position": [0, -0.5, 0], "target": [0, -1, 0]}}])
    eye = solve(away, tmp_path / "out", Options(trajectories=64))["observers"]["eye"]
    assert eye["UGR"] is None and eye["UGR_standard_error"] is None and eye["sources"] == 0 and eye["background_luminance"] > 0
    black = sphere(materials={"white": {"reflectance": 0}})
    assert solve(black, tmp_path / "out", Options(trajectories=64))["observers"]["eye"]["UGR"] is None


@pytest.mark.parametrize("observer, message", [
    ({"position": [0, 0, 0]}, 'receivers.eye.observer: the key "target" is missing'),
    ({"position": [0, 0, 0], "target": [0, 0, 0]}, "receivers.eye.observer.target: the target is the position"),
    ({"position": [0, 0, 0], "target": [0, 0, 1]}, 'receivers.eye.observer: "up" ([0, 0, 1] if absent) is parallel to the view'),
    ({"position": [0, 0, 0], "target": [1, 0, 0], "fov_deg": 3}, 'receivers.eye.observer: unknown key "fov_deg"')])
def test_mistakes(sphere, command, tmp_path, observer, message):
    status, _, error = command("solve", sphere(receivers=[{"name": "eye", "observer": observer}]), "--out", tmp_path / "out")
    assert status == 2 and message in error
