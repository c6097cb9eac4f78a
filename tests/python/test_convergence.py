# SPDX-License-Identifier: BSD-3-Clause
"""Errors against a truth, and times to an error on a log-log curve."""
from dataclasses import replace

import numpy as np
import pytest

from kalos.charts.convergence import Truth, bias, deviation_of_mean, errors, parts, time_to

TRUTH = Truth(np.array([100.0, 50.0, 0.0, 200.0]), np.zeros(4), "made up")


def test_errors_leave_dark_receivers_out():
    found = errors([[101, 49, 5, 204]], TRUTH, "value")
    assert found["rms"] == pytest.approx(np.sqrt((0.01**2 + 0.02**2 + 0.02**2) / 3))
    assert found["max"] == pytest.approx(0.02)
    mean = 350 / 3
    assert errors([[101, 49, 5, 204]], TRUTH, "mean")["rms"] == pytest.approx(np.sqrt((1 + 1 + 16) / 3) / mean)


def test_dark_is_below_a_thousandth_of_the_median():
    values = np.array([100.0, 99, 0, 0.09, 0.11, 100, 100])
    assert Truth(values, np.zeros(7), "made up").lit.tolist() == [True, True, False, False, True, True, True]


def test_percentile_runs_over_receivers_and_repetitions():
    estimates = np.full((25, 4), TRUTH.values)
    estimates[0, 0] = 110
    found = errors(estimates, TRUTH, "value")
    assert found["p95"] == 0 and found["max"] == pytest.approx(0.1)
    estimates[:6, 0] = 110  # 6 of 75: more than 5 %, less than 10 %
    assert errors(estimates, TRUTH, "value")["p95"] == pytest.approx(0.1)


def test_noise_of_the_truth_is_taken_out():
    """Independent normal noise of 3 % on the truth and 4 % on 10 000 estimates: rms 5 %, less 3 % is 4 %.

    The standard error of an rms over 10 000 values is 0.7 % of it; six of them, a false alarm in 1e-8.
    """
    rng = np.random.default_rng(1)
    noisy = Truth(1 + 0.03 * rng.standard_normal(10000), np.full(10000, 0.03), "noisy")
    found = errors([1 + 0.04 * rng.standard_normal(10000)], noisy, "mean")
    assert found["rms"] == pytest.approx(0.04, rel=0.06)


def test_deviation_of_the_mean():
    off, error = deviation_of_mean([[102, 51, 0, 204], [104, 52, 0, 208]], TRUTH)
    assert off == pytest.approx(0.03) and error == pytest.approx(0.01)


def test_bias_is_what_runs_have_in_common():
    """Normal biases of 2 % at 4000 receivers and 1 % on all, under noise of 10 % over the root of the effort.

    95 % of the former beside the latter lie within 4.36 %; over 40 seeds that came out with a standard deviation of 0.064.
    """
    rng = np.random.default_rng(2)
    truth = Truth(np.exp(rng.normal(size=4000)), np.zeros(4000), "made up")
    own, efforts = 1.01 + 0.02 * rng.normal(size=4000), [4, 4, 16, 16, 64, 64]
    runs = [truth.values * (own + 0.1 / np.sqrt(effort) * rng.normal(size=4000)) for effort in efforts]
    found = bias(runs, efforts, truth)
    assert found["mean"] == pytest.approx(np.average(own, weights=truth.values) - 1, abs=5 * found["mean_error"])
    assert 0 < found["mean_error"] < 1e-3
    assert found["p95"] == pytest.approx(0.0436, abs=5 * 0.00064) and found["p95_noise"] == pytest.approx(1.96 * 0.1 / np.sqrt(168), rel=0.03)
    known = replace(truth, mean_error=0.01)
    assert bias(runs, efforts, known)["mean_error"] == pytest.approx(np.hypot(found["mean_error"], 0.01))
    unbiased = bias([truth.values * (1 + 0.1 * rng.normal(size=4000)) for _ in range(4)], [1] * 4, truth)
    assert unbiased["p95"] < 0.5 * unbiased["p95_noise"] and abs(unbiased["mean"]) < 6 * unbiased["mean_error"]


def test_time_on_the_square_root_law():
    seconds = np.array([1.0, 2, 4, 8])
    found = 0.04 / np.sqrt(seconds)
    assert time_to(0.02, seconds, found).seconds == pytest.approx(4)
    between = time_to(0.03, seconds, found)
    assert between.seconds == pytest.approx((4 / 3) ** 2) and between.how == "interpolated"
    beyond = time_to(0.01, seconds, found)
    assert beyond.seconds == pytest.approx(16) and beyond.how == "extrapolated"
    before = time_to(0.05, seconds, found)
    assert before.seconds == 1 and before.how == "at most"


def test_a_slow_first_run_is_no_fault():
    found = time_to(0.05, [3, 2, 4], [0.04, 0.03, 0.02])
    assert found.seconds == pytest.approx(2) and found.how == "at most"


def test_beyond_the_longest_run_the_root_of_time_is_the_best():
    assert time_to(0.01, [4.0, 4.2, 4.4], [0.08, 0.04, 0.02]).seconds == pytest.approx(4 * 4.4)


def test_a_lucky_step_is_no_merit():
    assert time_to(0.02, [1, 2, 4, 8], [0.05, 0.015, 0.03, 0.02 / 1.5]).seconds > 4


def test_a_bias_is_never_extrapolated_away():
    flat = time_to(0.005, [1, 2, 4, 8], [0.02, 0.0105, 0.0101, 0.01])
    assert flat.seconds is None and flat.how == "out of reach"
    assert time_to(0.005, [1.0], [0.02]).seconds is None


def test_parts_tell_bias_from_noise():
    random = np.random.default_rng(5)
    truth = Truth(np.full(4000, 100.0), np.zeros(4000), "made up")
    noisy = 100 * (1 + 0.05 * random.standard_normal((8, 4000)))
    assert parts(noisy, truth, "value")["noise"] == pytest.approx(0.05, rel=0.02)
    assert parts(noisy, truth, "value")["bias"] < 0.004  # hidden in its noise, 0.05 / sqrt(8) over many values
    assert parts(1.1 * noisy, truth, "value")["bias"] == pytest.approx(0.1, rel=0.02)
    half = noisy.copy()
    half[:, ::2] *= 0.5
    assert parts(half, truth, "mean")["bias"] == pytest.approx(0.5 / np.sqrt(2), rel=0.02)
