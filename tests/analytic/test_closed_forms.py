# SPDX-License-Identifier: BSD-3-Clause
"""Every method on every scene with a closed form, at points at least 0.25 m from concave edges.

Methods that state a bias are judged by their means, beside that bias. A sound method fails a case with probability 1e-4 (kalos.validation.verdicts.FALSE_ALARM).
"""
import pytest

from kalos.validation.cases import CASES, DATA
from kalos.validation.validate import available_methods, examine

METHODS = available_methods(DATA, 1)


def test_the_methods_are_there():
    assert {"local", "direct"} <= set(METHODS)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_case(case, method):
    if not case.takes(method):
        return
    seed = 11
    verdict = examine(case, case.options(method, seed=seed))
    print(f"seed {seed}: {verdict}")
    assert verdict.worst <= verdict.allowed
    assert verdict.error <= verdict.precision, "too noisy to tell anything"
