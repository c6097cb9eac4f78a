# SPDX-License-Identifier: BSD-3-Clause
"""The examples in the docstrings run and print what they say; every public function has one, typed and with its units."""
import doctest
import inspect

import pytest

import kalos
from kalos.estimation import estimates
from kalos.scenes import geometry, luminaires, scene

PUBLIC = ("illuminance", "luminance", "surface", "quad", "box", "luminaire", "panel")
NAMES = (*PUBLIC, "Scene")


@pytest.mark.parametrize("module", [estimates, geometry, luminaires, scene])
def test_examples(module):
    names = {name: getattr(kalos, name) for name in NAMES}
    result = doctest.testmod(module, extraglobs=names)
    assert result.attempted >= 2 and result.failed == 0


@pytest.mark.parametrize("name", PUBLIC)
def test_every_function_is_documented(name):
    function = getattr(kalos, name)
    assert ">>>" in function.__doc__ and ("lx" in function.__doc__ or "cd/m2" in function.__doc__ or ", m" in function.__doc__)
    signature = inspect.signature(function)
    assert signature.return_annotation is not inspect.Signature.empty
    assert all(p.annotation is not inspect.Parameter.empty for p in signature.parameters.values())
