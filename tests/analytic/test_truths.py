# SPDX-License-Identifier: BSD-3-Clause
"""The closed forms themselves, against printed values and against each other; nothing random."""
import numpy as np
import pytest

from kalos.validation import truths


@pytest.mark.parametrize("h1, rho1, rho2, printed", [
    (0.5, 0.5, 0.5, [0.3603371, 0.1480372, 0.0519993, 0.0132495]),
    (0.5, 0.8, 0.8, [0.4120194, 0.1945525, 0.0881908, 0.0330549]),
    (0.9, 0.2, 0.7, [0.1931366, 0.1324139, 0.0609040, 0.0142151])])
def test_sobolev(h1, rho1, rho2, printed):
    values = [truths.sobolev(1, h1, 1, rho1, rho2, r) for r in (0, 0.5, 1, 2)]
    np.testing.assert_allclose(values, printed, atol=6e-8)


def test_what_finite_squares_cut_off():
    """Light by way of a point beyond 20 m is below 1e-3 of the value at r = 2 m, which is tested to 1e-2.

    Such a path has a vertex at some R > 20 m. All of them together carry at most the integral over R of
    E(R) rho g(R - 2) dA, twice for the two planes, with g what a lumen leaving there gives back, reflections included:
    at most twice the illuminance of an isotropic source at the height of the other plane. Both fall as 1/R3 and faster.
    """
    rho, edge = 0.8, 20.0
    lit = max(truths.sobolev(1, 0.5, 1, rho, rho, r) * r**3 for r in (8.0, 12.0, 16.0))
    back = max(2 * truths.sobolev(1, 1 - 1e-9, 1, rho, rho, r) * r**3 for r in (8.0, 12.0, 16.0))
    # The integral of 2 pi R / (R3 (R - 2)3), with R < 1.12 (R - 2) beyond the edge.
    share = 2 * rho * lit * back * 2 * np.pi * 1.12 / (4 * (edge - 2) ** 4)
    assert share < 1e-3 * truths.sobolev(1, 0.5, 1, rho, rho, 2)


def test_energy_balance_table():
    printed = {0.05: 5.48, 0.1: 11.6, 0.2: 26.0, 0.3: 44.6, 0.4: 69.4, 0.5: 104, 0.6: 156, 0.7: 243, 0.8: 417, 0.9: 937,
               0.95: 1979}
    for reflectance, value in printed.items():
        assert truths.mean_indirect(10000, 96, reflectance) == pytest.approx(value, rel=5e-3)


def test_form_factors_agree():
    floor = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]
    above = truths.polygon_form_factor(np.array([2, 2, 3.0]), np.array([0, 0, -1]), floor)
    assert above == pytest.approx(4 * truths.parallel_rectangle(2, 2, 3), rel=1e-12)
    beside = truths.polygon_form_factor(np.array([2, 0, 0.75]), np.array([0, 1, 0]), floor)
    assert beside == pytest.approx(2 * truths.perpendicular_rectangle(0.75, 2, 4), rel=1e-12)
    assert 2 * truths.perpendicular_rectangle(1e-9, 2, 4) == pytest.approx(0.5, rel=1e-8)
    angles = np.linspace(0, 2 * np.pi, 2001)[:-1]
    disc = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(2000)])
    assert truths.polygon_form_factor(np.array([0, 0, 0.5]), np.array([0, 0, -1]), disc) == pytest.approx(
        truths.disc_form_factor(1, 0.5), rel=1e-5)


def test_printed_tables_of_cie171():
    wall = np.array([(2, 0, z) for z in np.arange(2.75, 0, -0.5)])
    floor = np.array([(2, y, 0) for y in np.arange(0.25, 4, 0.5)])
    inwards, up = np.tile([0.0, 1, 0], (6, 1)), np.tile([0.0, 0, 1], (8, 1))
    printed = [32.677, 75.194, 81.323, 69.061, 53.404, 40.002]
    np.testing.assert_allclose(truths.cie171_area(wall, inwards), printed, atol=6e-4)
    printed = [61.424, 79.255, 95.667, 105.778]
    np.testing.assert_allclose(truths.cie171_area(floor[:4], up), printed, atol=6e-4)
    grid = np.array([(0, 0, 0), (0.5, 0, 0), (1, 0, 0), (1.5, 0, 0), (1.5, 1.5, 0)], float)
    np.testing.assert_allclose(truths.cie171_point(grid), [111.11, 105.19, 90.00, 71.11, 49.38], atol=6e-3)
    printed = [16.716, 21.639, 27.992, 35.901]
    np.testing.assert_allclose(100 * truths.cie171_reflection(wall[1:5], inwards), printed, atol=6e-4)
    printed = [16.071, 16.330, 15.399, 13.322, 10.317, 7.079]
    np.testing.assert_allclose(100 * truths.cie171_obstruction(wall, inwards), printed, atol=6e-4)
    printed = [3.382, 3.629, 3.013, 0, 0]
    np.testing.assert_allclose(100 * truths.cie171_obstruction(floor[:5], up), printed, atol=6e-4)
