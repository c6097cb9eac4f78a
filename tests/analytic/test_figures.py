# SPDX-License-Identifier: BSD-3-Clause
"""`kalos validate --figures` at a fraction of its effort: the figures are printed, and a missed one fails."""
import pytest

from kalos.validation import figures, truths
from kalos.validation.cases import DATA


@pytest.fixture
def said():
    return []


def test_near_edges(said):
    figures.near_edges(DATA, "near-edge", 0.6, 1, said.append, seeds=4, trajectories=3200)
    assert len([line for line in said if line.startswith("  edge ")]) == 10
    assert len([line for line in said if line.startswith(("  corner ", "  lip ", "  middle "))]) == 16
    assert "slowest: " in said[-3] and "mean off by at most " in said[-2] and "intervals hold the truth" in said[-1]


def test_angles(said):
    figures.near_edges(DATA, "angles", 0.6, 1, said.append, seeds=4, trajectories=3200)
    assert len([line for line in said if line.startswith("  angle-")]) == 30


def test_a_wrong_truth_is_missed(said, monkeypatch):
    monkeypatch.setattr(truths, "white_furnace", lambda reflectance, exitance: 1.5 * exitance / (1 - reflectance))
    assert not figures.near_edges(DATA, "near-edge", 0.6, 1, said.append, seeds=4, trajectories=3200)
    assert said[-2].endswith("MISSED")


def test_closed_forms(said):
    assert figures.closed_forms(DATA, 1, said.append, factor=0.1)
    assert len(said) == 6 and all(line.endswith("reached") for line in said[1:])


def test_cost(said):
    figures.cost(DATA, 1, said.append, side=4, trajectories=640, times=1)
    assert "times the processor time of local" in said[0]


def test_cube(said):
    assert figures.cube(DATA, 1, said.append, precision=5e-3)
    assert len(said) == 11


def test_sobolev(said):
    """At the foot of the source, where cells are hit often enough even by a test."""
    assert figures.sobolev(DATA, 1, said.append, distances=(0,), direct_trajectories=400000, trajectories=32000)
    assert "ratio" in said[1]


def test_within():
    assert figures.within(0.002, 0.001, 1e-3, 100) and not figures.within(0.002, 0.0001, 1e-3, 100)
    assert not figures.within(-0.002, 0.0001, 1e-3, 100)
    assert figures.within(0.002, 0.0002, 1e-3, 3)  # few values: their spread is hardly known
