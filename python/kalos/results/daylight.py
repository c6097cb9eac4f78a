# SPDX-License-Identifier: BSD-3-Clause
"""Figures of daylight factors, as EN 17037 asks for them."""
import numpy as np

TARGET, MINIMUM = 0.5, 0.95  # shares of the area that must reach the target and the minimum target illuminance
LEVELS = {"minimum": (300, 100), "medium": (500, 300), "high": (750, 500)}  # lx, target and minimum target of EN 17037, table A.1


def daylight_figures(factors, illuminance, direct, weights):
    """Of daylight factors, %, and illuminances, lx, all and direct, at receivers of these weights.

    The means of the factors, of what comes straight from sky and ground, and of what surfaces reflect; the median; the factor
    reached on half of the area (d_t) and on 95 % of it (d_tm); and the shares of the area that reach the levels of EN 17037
    under this very sky, whose horizontal illuminance should be the median of the site for that.
    """
    if not len(factors):
        return {key: None for key in ("mean", "mean_direct", "mean_reflected", "median", "d_t", "d_tm", "en_17037")}
    factors, weights = np.asarray(factors, float), np.asarray(weights, float)
    straight = np.divide(factors * direct, illuminance, out=np.zeros_like(factors), where=illuminance > 0)
    return {"mean": float(np.average(factors, weights=weights)), "mean_direct": float(np.average(straight, weights=weights)),
            "mean_reflected": float(np.average(factors - straight, weights=weights)), "median": reached(factors, weights, 0.5),
            "d_t": reached(factors, weights, TARGET), "d_tm": reached(factors, weights, MINIMUM),
            "en_17037": {name: {"target": share(illuminance, weights, target), "minimum_target": share(illuminance, weights, least)}
                         for name, (target, least) in LEVELS.items()}}


def reached(values, weights, area):
    """The largest value that this share of the area reaches or exceeds."""
    order = np.argsort(-values, kind="stable")
    grown = np.cumsum(weights[order]) / weights.sum()
    return float(values[order][np.searchsorted(grown, area * (1 - 1e-12))])


def share(values, weights, least):
    """Share of the area where the value is at least this."""
    return float(weights[values >= least].sum() / weights.sum())
