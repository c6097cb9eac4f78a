# SPDX-License-Identifier: BSD-3-Clause
"""Whether estimates agree with known values, as far as their standard errors can tell."""
from dataclasses import dataclass

import numpy as np
from scipy import stats

REPLICATES = 8  # at least, of an estimate; its standard error has one degree of freedom less
OFFSET = 1e-5  # of the largest value: receivers are lifted off their surface by micrometres, so that it cannot hide them
FALSE_ALARM = 1e-4  # chance that a sound method fails a case, however many points the case has


@dataclass(frozen=True)
class Verdict:
    """How far an estimate is from the truth, in standard errors, and how far it may be."""

    points: int
    worst: float  # largest deviation, standard errors
    allowed: float
    error: float  # largest standard error, relative to its truth
    precision: float

    @property
    def passed(self):
        return self.worst <= self.allowed and self.error <= self.precision


def allowed_deviation(points, false_alarm=FALSE_ALARM, freedom=REPLICATES - 1):
    """Standard errors that none of `points` values may be off by, but for the given chance.

    Student's t, for the standard errors are estimates; Sidak's correction, which also holds for dependent values.
    """
    single = 1 - (1 - false_alarm) ** (1 / points)
    return float(stats.t.isf(single / 2, freedom))


def judge(estimate, standard_error, truth, precision, false_alarm=FALSE_ALARM, freedom=REPLICATES - 1):
    """The verdict on estimates of known values. A value without noise may be off by OFFSET."""
    deviation = np.maximum(np.abs(estimate - truth) - OFFSET * np.max(np.abs(truth)), 0)
    in_errors = np.divide(deviation, standard_error, out=np.where(deviation > 0, np.inf, 0.0), where=standard_error > 0)
    lit = truth > 0
    relative = np.max(standard_error[lit] / truth[lit])
    return Verdict(len(truth), float(in_errors.max()), allowed_deviation(len(truth), false_alarm, freedom), float(relative),
                   precision)
