# SPDX-License-Identifier: BSD-3-Clause
"""How an error falls with effort: errors of repeated estimates, and the time to a wanted error on the log-log curve."""
from dataclasses import dataclass

import numpy as np
from scipy import stats

DARK = 1e-3  # of the median: what is darker (the inside of a box, the floor under it) has no relative error
FARTHEST = 16.0  # times the longest run: no extrapolation beyond that


@dataclass(frozen=True)
class Truth:
    """The reference that estimates are compared with, lx, and its own standard error."""

    values: np.ndarray
    standard_error: np.ndarray
    source: str  # in words
    mean_error: float = 0.0  # of the mean over the values, relative

    @property
    def lit(self):
        return self.values > DARK * np.median(self.values[self.values > 0])

    def scale(self, relative_to):
        """What an error is divided by: the value itself, or the mean over the receivers."""
        lit = self.values[self.lit]
        return lit if relative_to == "value" else np.full(len(lit), lit.mean())

    def noise(self, relative_to):
        """The truth's own root mean square error."""
        return float(np.sqrt(np.mean((self.standard_error[self.lit] / self.scale(relative_to)) ** 2)))


def errors(estimates, truth, relative_to):
    """rms, 95th percentile and largest error over receivers and repetitions, (n, receivers); relative.

    The truth's own noise is taken out of the rms, as it is independent; out of the others it cannot be.
    """
    deviation = (np.asarray(estimates)[:, truth.lit] - truth.values[truth.lit]) / truth.scale(relative_to)
    square, noise = np.mean(deviation**2), truth.noise(relative_to) ** 2
    deviation = np.abs(deviation)
    return {"rms": float(np.sqrt(max(square - noise, 0.01 * square))), "p95": float(np.percentile(deviation, 95)),
            "max": float(deviation.max())}


def parts(estimates, truth, relative_to):
    """The error's parts: noise, the spread of the repetitions, and bias, what they share, of which noise is taken out.

    A bias that its own noise hides is 0.
    """
    relative = (np.asarray(estimates)[:, truth.lit] - truth.values[truth.lit]) / truth.scale(relative_to)
    noise = np.mean(relative.var(axis=0, ddof=1))
    shared = relative.mean(axis=0) ** 2 - relative.var(axis=0, ddof=1) / len(relative)
    hidden = 2 * noise / len(relative) * np.sqrt(2 / shared.size)  # two standard errors of the mean square
    square = np.mean(shared) - truth.noise(relative_to) ** 2
    return {"noise": float(np.sqrt(noise)), "bias": float(np.sqrt(square)) if square > hidden else 0.0}


def deviation_of_mean(estimates, truth):
    """Mean of the estimates over receivers and repetitions less that of the truth, relative, and its standard error."""
    means = np.asarray(estimates)[:, truth.lit].mean(axis=1) / truth.values[truth.lit].mean() - 1
    return float(means.mean()), float(means.std(ddof=1) / np.sqrt(len(means)))


def bias(estimates, efforts, truth):
    """The common error of many estimates, weighted by their effort: relative, the error of their mean over the receivers
    with its standard error, and the error that 95 % of the receivers stay below.

    Noise is taken out of the latter as if both were normal; `noise` is what it was, for one who wonders whether there is
    anything left. The truth's own error is in both.
    """
    values, weights = np.asarray(estimates)[:, truth.lit], np.asarray(efforts, float) / np.sum(efforts)
    known, freedom = truth.values[truth.lit], len(weights) - 1
    means = values.mean(axis=1) / known.mean() - 1
    off = weights @ means
    # An estimate's variance falls as its effort: of unit weight, the spread; of the weighed mean, the same.
    off_error = np.sqrt(weights @ (means - off) ** 2 / freedom + truth.mean_error**2)
    pooled = weights @ values
    square = np.mean(weights @ (values - pooled) ** 2 / freedom / known**2) + truth.noise("value") ** 2
    p95, noise = np.percentile(np.abs(pooled / known - 1), 95), stats.norm.isf(0.025) * np.sqrt(square)
    return {"mean": float(off), "mean_error": float(off_error), "p95": float(np.sqrt(max(p95**2 - noise**2, 0))),
            "p95_noise": float(noise)}


@dataclass(frozen=True)
class TimeTo:
    """The time to an error; None where it is out of reach, with how it was found."""

    seconds: float
    how: str  # "interpolated", "extrapolated", "at most" (the least effort is that good already), "out of reach"


def time_to(goal, seconds, found):
    """From times and errors of a ladder of efforts, by straight lines on the log-log curve.

    The last crossing counts, as an early run can have a small error by chance. Beyond the longest run errors fall
    as the root of time at most: the last steps fall faster where time is mostly what any run takes.
    """
    t, e = np.log(seconds), np.log(found)
    above = np.flatnonzero(e > np.log(goal))
    if len(above) == 0:  # the cheapest: a first run can take longer than one of more effort
        return TimeTo(float(np.exp(t.min())), "at most")
    last = above[-1]
    if last + 1 < len(e):
        share = (e[last] - np.log(goal)) / (e[last] - e[last + 1])
        return TimeTo(float(np.exp(t[last] + share * (t[last + 1] - t[last]))), "interpolated")
    tail = slice(-3, None)
    slope = max(np.polyfit(t[tail], e[tail], 1)[0], -0.5) if len(e) > 1 else 0.0
    factor = (np.log(goal) - e[-1]) / slope if slope < 0 else np.inf
    if factor > np.log(FARTHEST):
        return TimeTo(None, "out of reach")
    return TimeTo(float(np.exp(t[-1] + factor)), "extrapolated")
