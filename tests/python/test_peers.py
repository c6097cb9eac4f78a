# SPDX-License-Identifier: BSD-3-Clause
"""Peers against closed forms: units, luminaires, sides, reflection. Skipped, with the reason, where a peer is not installed."""
import numpy as np
import pytest

from kalos.charts.contenders import PEERS, Room
from kalos.peers import Absent
from kalos.peers.description import beyond, describe
from kalos.scenes.reading import read_scene
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
    ("mitsuba", "CIE 171 5.6, reflection", 4096, 0),
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


def test_what_no_peer_can_model():
    assert beyond(read_scene(DATA / "cornell" / "cornell.json")) is None
    assert beyond(read_scene(DATA / "cornell" / "cornell-mixed.json")) == "glossy surfaces"


def test_radiance_refuses_a_furnace():
    room = Room(DATA / "furnace" / "furnace.json")
    with pytest.raises(Absent, match="both reflect and emit"):
        PEERS["radiance"](describe(room.reader, room.points, room.normals))
