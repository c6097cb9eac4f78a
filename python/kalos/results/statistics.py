# SPDX-License-Identifier: BSD-3-Clause
"""The figures of a receiver set or an image: mean, extremes and uniformities with their standard errors."""
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays


def relative_error(values, standard_error):
    """Standard errors over their values; where it is dark 0, or infinite if something fluctuates there."""
    rounding = 1e-12 * values.max(initial=0)  # what arithmetic leaves inside a solid
    dark = np.where(standard_error > rounding, np.inf, 0.0)
    return np.divide(standard_error, values, out=dark, where=values > rounding)


FIGURES = ("mean", "mean_standard_error", "min", "min_standard_error", "max", "max_standard_error", "U0", "U0_standard_error", "Ud",
           "Ud_standard_error", "largest_relative_standard_error")


def statistics(values, standard_error, weights=None, replicates=None):
    """Mean, extremes, uniformities U0 = min/mean and Ud = min/max, each with its standard error, and the largest relative
    standard error of a single value that is not dark.

    A ratio to nothing is None. The mean weighs by `weights` (areas); the smallest value is not corrected for noise. Values
    share trajectories, so that the errors of mean and ratios come from the `replicates` (n, P): the spread of the means, and
    to first order that of the ratios, at the places of the extremes. Without replicates the mean's is an upper bound, and
    those of the ratios are None. Of no values, all is None.
    """
    if len(values) == 0:
        return dict.fromkeys(FIGURES)
    mean = float(np.average(values, weights=weights))
    low, high = float(values.min()), float(values.max())
    worst = float(relative_error(values, standard_error).max())
    least, most = int(values.argmin()), int(values.argmax())
    if replicates is None:
        mean_error, ratio_errors = float(np.average(standard_error, weights=weights)), (None, None)
    else:
        means = np.average(replicates, axis=0, weights=weights)
        mean_error = error_of(means)
        ratio_errors = [ratio_error(replicates[least], whole, value) if value else None
                        for whole, value in ((means, mean), (replicates[most], high))]
    return dict(zip(FIGURES, (mean, mean_error, low, float(standard_error[least]), high, float(standard_error[most]),
                              low / mean if mean else None, ratio_errors[0], low / high if high else None, ratio_errors[1],
                              worst if math.isfinite(worst) else None)))


def error_of(replicates):
    """Standard error of the mean of independent estimates."""
    return float(replicates.std(ddof=1) / math.sqrt(len(replicates)))


def ratio_error(part, whole, value):
    """Standard error, to first order, of mean(part)/value, where `value` is mean(whole)."""
    return error_of((part - part.mean() / value * whole) / value)


MISSED, WITHIN_ERROR, BELOW_FLOOR = range(3)  # as kalos::GoalStatus
NAMED = 100  # receivers that missed the goal and are named


def goal(status):
    """How many receivers reached the goal of the error, and which, in the table's order from 0, did not."""
    missed = np.flatnonzero(status == MISSED)
    return {"within_error": int((status == WITHIN_ERROR).sum()), "below_floor": int((status == BELOW_FLOOR).sum()),
            "missed": len(missed), "missed_receivers": missed[:NAMED].tolist()}


def image_statistics(image):
    values = vtk_to_numpy(image.GetPointData().GetArray(arrays.LUMINANCE)).astype(float)
    error = vtk_to_numpy(image.GetPointData().GetArray(arrays.LUMINANCE_STANDARD_ERROR)).astype(float)
    return {key: value for key, value in statistics(values, error).items() if not key.startswith(("U0", "Ud"))}
