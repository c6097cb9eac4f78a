# SPDX-License-Identifier: BSD-3-Clause
"""Figures of daylight factors, as EN 17037 asks for them."""
import numpy as np

TARGET, MINIMUM = 0.5, 0.95  # shares of the area that must reach the target and the minimum target illuminance
LEVELS = {"minimum": (300, 100), "medium": (500, 300), "high": (750, 500)}  # lx, target and minimum target of EN 17037, table A.1


def daylight_figures(factors, weights, median_outdoors=None):
    """Of daylight factors, %, at receivers of these weights: mean, median, and the factor reached on half of the area (d_t) and on 95 %
    of it (d_tm). With the median diffuse illuminance outdoors, lx, the share of the area that reaches each level of EN 17037."""
    factors, weights = np.asarray(factors, float), np.asarray(weights, float)
    if not len(factors):
        return {"mean": None, "median": None, "d_t": None, "d_tm": None}
    found = {"mean": float(np.average(factors, weights=weights)), "median": reached(factors, weights, 0.5),
             "d_t": reached(factors, weights, TARGET), "d_tm": reached(factors, weights, MINIMUM)}
    if median_outdoors:
        found["en_17037"] = {name: {"target": share(factors, weights, 100 * target / median_outdoors),
                                    "minimum_target": share(factors, weights, 100 * least / median_outdoors)}
                             for name, (target, least) in LEVELS.items()}
    return found


def reached(factors, weights, area):
    """The largest value that this share of the area reaches or exceeds."""
    order = np.argsort(-factors, kind="stable")
    grown = np.cumsum(weights[order]) / weights.sum()
    return float(factors[order][np.searchsorted(grown, area * (1 - 1e-12))])


def share(factors, weights, least):
    """Share of the area where the factor is at least this."""
    return float(weights[factors >= least].sum() / weights.sum())
