# SPDX-License-Identifier: BSD-3-Clause
"""`kalos atlas`: a page of failures, and the words for them."""
import csv
import json

import numpy as np
import pytest
from conftest import one_line

from kalos.charts.atlas import verdict
from kalos.charts.failures import FAILURES
from kalos.charts.families import FAMILIES, about, style
from kalos.commands.atlas import SCENES
from kalos.core.options import METHODS
from kalos.peers import NAMES

RANDOM = np.random.default_rng(1)
TRUTH = np.full(9, 250.0)


def made(shape):
    return {"values": TRUTH * shape, "trajectories": 1, "cpu_seconds": 1.0}


def noisy(level):
    return 1 + level * RANDOM.standard_normal((8, 9))


def test_page_of_two_scenes(command, tmp_path):
    out = tmp_path / "out"
    status, said, _ = command("atlas", "--out", out, "--scenes", "furnace-edge,caustic", "--methods", "local,photon-map,radiosity",
                              "--budget", "0.2")
    assert status == 0 and "Beside an edge of the white furnace: 250 to 250 lx by closed form" in said
    result = json.loads((out / "atlas.json").read_text())
    edge, caustic = result["scenes"]
    assert "too dark by up to " in edge["verdicts"]["photon-map"] and edge["truth_lx"] == [250] * 16
    assert caustic["verdicts"]["radiosity"].startswith("refuses: radiosity knows diffuse surfaces only")
    rows = list(csv.DictReader((out / "atlas.csv").open()))
    assert {row["method"] for row in rows if row["scene"] == "caustic"} == {"local", "photon-map"}
    text = (out / "atlas.html").read_text()
    for name in ("furnace-edge", "caustic"):
        assert f"src='{name}.png'" in text and (out / f"{name}.png").stat().st_size > 20000
    assert "DIALux evo" in text


@pytest.mark.parametrize("option, value, expected", [
    ("--scenes", "attic", "furnace-edge, dihedral, contact"), ("--methods", "magic", "compensated, gathered"),
    ("--budget", "0", "a time > 0, in seconds")])
def test_bad_value(command, tmp_path, option, value, expected):
    status, _, error = command("atlas", "--out", tmp_path / "out", option, value)
    assert status == 2 and one_line(error).startswith(f"{option}: '{value}' is not allowed, expected ")
    assert expected in error and not (tmp_path / "out").exists()


def test_scenes_are_those_that_there_are():
    assert SCENES == tuple(FAILURES)
    for make in FAILURES.values():
        failure = make()
        assert len(failure.points) == len(failure.along) > 8 and failure.about.endswith(".")
        assert failure.known is None or (failure.known > 0).all()


def test_words():
    assert verdict(made(noisy(0.003)), TRUTH, 0 * TRUTH).startswith("within 0.3 %")
    assert verdict(made(noisy(0.1)), TRUTH, 0 * TRUTH).startswith("noise: ")
    assert verdict(made(0.05 * noisy(0.1)), TRUTH, 0 * TRUTH).startswith("never arrives")
    rare = np.full((8, 9), 0.01)
    rare[2, 3] = 12
    assert verdict(made(rare), TRUTH, 0 * TRUTH) == "rare spikes: up to 12 times the truth"
    dark, spiky = noisy(0.01), noisy(0.01)
    dark[:, 0] *= 0.5
    spiky[3, 0] = 9
    assert verdict(made(dark), TRUTH, 0 * TRUTH) in ("bias: too dark by up to 50 %", "bias: too dark by up to 49 %")
    assert verdict(made(spiky), TRUTH, 0 * TRUTH).startswith("spikes: up to 9 times the truth")
    assert verdict(made(dark), TRUTH, TRUTH).startswith("noise") or "within" in verdict(made(dark), TRUTH, TRUTH)
    assert verdict({"refused": "method: radiosity knows"}, TRUTH, TRUTH) == "refuses: radiosity knows"


def test_every_method_and_peer_has_a_family_and_a_colour_of_its_own():
    names = [name for one in FAMILIES for name in one.about]
    assert sorted(names) == sorted([*METHODS, *NAMES])
    assert len({style(name)["color"] for name in names}) == len(names)
    assert all(len(about(name)) < 110 for name in names)
