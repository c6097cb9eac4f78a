# SPDX-License-Identifier: BSD-3-Clause
"""The growth curves at their smallest sizes: the scenes have the announced sizes, and the exponent is one."""
import numpy as np
import pytest

import growth


def test_exponent():
    sizes = np.array([1.0, 10, 100, 1000])
    assert growth.exponent(sizes, 3 * sizes**1.5) == pytest.approx(1.5)
    assert growth.exponent(sizes, np.array([9, 1, 10, 100.0])) == pytest.approx(1)  # the last three


@pytest.mark.parametrize("inwards, sign", [(True, -1), (False, 1)])
def test_boxes_are_closed(inwards, sign):
    """The divergence theorem: the triangles enclose the volume, positive where the normals point outwards."""
    points, triangles = growth.box(np.array([1.0, 2, 3]), np.array([1.2, 0.8, 0.7]), 3, inwards)
    faces = points[triangles]
    assert len(faces) == 6 * 9 * 2 and len(points) == 6 * 16
    volume = np.einsum("nx,nx->n", faces[:, 0], np.cross(faces[:, 1], faces[:, 2])).sum() / 6
    assert volume == pytest.approx(sign * 1.2 * 0.8 * 0.7)


def test_series(capsys):
    growth.grow("receivers", (50, 100), "local")
    said = capsys.readouterr().out
    assert said.count(" receivers ") == 2 and "exponent" in said
    assert growth.grow("luminaires", (1,), "local") is None
