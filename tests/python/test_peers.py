# SPDX-License-Identifier: BSD-3-Clause
"""Peers against closed forms: units, luminaires, sides, reflection. Skipped, with the reason, where a peer is not installed."""
import json

import numpy as np
import pytest

from kalos.charts.contenders import PEERS, Room
from kalos.core.options import Options
from kalos.peers import Absent
from kalos.peers.description import describe
from kalos.validation.cases import CASES, DATA
from kalos.validation.verdicts import allowed_deviation

RUNS = 8
CASE = {case.name: case for case in CASES}


def estimates(name, case, effort):
    """RUNS independent estimates of the receivers of a case, and the truth."""
    room = Room(DATA / case.scene)
    try:
        peer = PEERS[name](describe(room.reader, room.points, room.normals))
    except Absent as absent:
        pytest.skip(f"{name}: {absent}")
    try:
        return np.array([peer.solve(effort, seed).values for seed in range(1, RUNS + 1)]), case.truth(room.points, room.normals)
    finally:
        peer.close()


@pytest.mark.parametrize("peer, case, effort, bias", [
    ("mitsuba", "white furnace, boxes", 1024, 0), ("mitsuba", "Sobolev's planes, 0.5 0.5", 16384, 1e-3),
    ("mitsuba", "CIE 171 5.2, point", 4, 1e-5), ("mitsuba", "CIE 171 5.3, area", 1024, 0),
    ("mitsuba", "CIE 171 5.6, reflection", 4096, 0), ("mitsuba", "lamp over a glossy plane", 65536, 1e-3),
    ("mitsuba", "furnace, glossy floor", 16384, 0),
    # Radiance's luminaires are bodies, its direct light of areas is a sum over patches of them.
    ("radiance", "Sobolev's planes, 0.5 0.5", 1024, 2e-3), ("radiance", "CIE 171 5.2, point", 4, 1e-3),
    ("radiance", "CIE 171 5.3, area", 4, 3e-3), ("radiance-cached", "Sobolev's planes, 0.5 0.5", 32, 0.1)])
def test_closed_form(peer, case, effort, bias):
    """Every receiver within Student's t of the truth, but for a chance of 1e-4, beyond a bias that is known."""
    values, truth = estimates(peer, CASE[case], effort)
    error = values.std(axis=0, ddof=1) / np.sqrt(RUNS)
    lit = truth > 0
    off = np.maximum(np.abs(values.mean(axis=0) - truth) - (bias + 1e-5) * truth.max(), 0)
    assert (off <= allowed_deviation(len(truth), 1e-4, RUNS - 1) * error).all(), (values.mean(axis=0) / truth, error / truth)
    assert (error[lit] / truth[lit]).max() < 0.05, "too noisy to tell anything"


def test_seeds_repeat_and_differ():
    values, _ = estimates("mitsuba", CASE["Sobolev's planes, 0.5 0.5"], 64)
    again, _ = estimates("mitsuba", CASE["Sobolev's planes, 0.5 0.5"], 64)
    np.testing.assert_array_equal(values, again)
    assert len(np.unique(values[:, 0])) == RUNS


@pytest.mark.parametrize("name, why", [("mitsuba", "point luminaire in a mirror"), ("radiance", "only gloss at receivers")])
def test_mirrors_are_refused(name, why):
    room = Room(DATA / "gloss" / "mirror.json")
    with pytest.raises(Absent, match=why):
        PEERS[name](describe(room.reader, room.points, room.normals))


@pytest.mark.parametrize("file", ["downlight.ies", "panel.ies", "pendant.ldt"])
def test_candela_tables(tmp_path, file):
    """Openings over a black plane, near and far: what Kalos finds, to the standard errors of both."""
    lamp = {"name": "lamp", "position": [0.3, 0.2, 1.5], "aim": [0.2, 0, -1], "file": str(DATA / "photometry" / file)}
    scene = {"kalos": 1, "materials": {"black": {"reflectance": 0}},
             "surfaces": [{"name": "floor", "quad": {"origin": [-2, -2, 0], "u": [4, 0, 0], "v": [0, 4, 0]}, "material": "black"}],
             "luminaires": [lamp], "receivers": [{"name": "floor", "plane": {"origin": [-1, -1, 0], "u": [2, 0, 0], "v": [0, 2, 0],
                                                                             "resolution": [8, 8]}}]}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    room = Room(tmp_path / "scene.json")
    expected = room.solve(Options(trajectories=20000), None)
    try:
        peer = PEERS["mitsuba"](describe(room.reader, room.points, room.normals))
    except Absent as absent:
        pytest.skip(f"mitsuba: {absent}")
    found = np.array([peer.solve(4096, seed).values for seed in range(1, RUNS + 1)])
    peer.close()
    error = np.hypot(found.std(axis=0, ddof=1) / np.sqrt(RUNS), expected.standard_error)
    off = np.maximum(np.abs(found.mean(axis=0) - expected.values) - 5e-4 * expected.values.max(), 0)  # single precision
    assert (off <= allowed_deviation(len(off), 1e-4, RUNS - 1) * error).all(), (found.mean(axis=0) / expected.values)
    assert expected.values.max() > 10 and (error < 0.05 * expected.values.max()).all()


def test_radiance_refuses_a_furnace():
    room = Room(DATA / "furnace" / "furnace.json")
    with pytest.raises(Absent, match="both reflect and emit"):
        PEERS["radiance"](describe(room.reader, room.points, room.normals))
