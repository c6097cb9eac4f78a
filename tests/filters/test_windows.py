# SPDX-License-Identifier: BSD-3-Clause
"""Walls with windows, as exporters write them: light passes the window and nothing else.

Source of truth: a point luminaire before the wall; behind it E = I cos / d2 where the line of sight crosses the window.
"""
import numpy as np
import pytest

from helpers import minimal_scene, write_scene
from models import direct

# The plane x = 2, 4 m wide and 3 m high, with a window from (1, 1) to (3, 2).
WALL = [(0, 0), (4, 0), (4, 3), (0, 3), (1, 1), (1, 2), (3, 2), (3, 1)]
LAMP = np.array((1.0, 2.0, 1.5))
OUTLINES = {
    "bridge": [1, 2, 3, 4, 1, 5, 6, 7, 8, 5],
    "bridge, turned over": [5, 8, 7, 6, 5, 1, 4, 3, 2, 1],
    "bridge, hole the same way round": [1, 2, 3, 4, 1, 5, 8, 7, 6, 5],
    "bridge from another corner": [3, 4, 1, 2, 3, 7, 8, 5, 6, 7],
    "two concave halves": [[1, 2, 3, 7, 8, 5], [1, 5, 6, 7, 3, 4]],
}


def obj(outline):
    faces = outline if isinstance(outline[0], list) else [outline]
    return "".join(f"v 2 {y} {z}\n" for y, z in WALL) + "".join(f"f {' '.join(map(str, face))}\n" for face in faces)


@pytest.mark.parametrize("outline", OUTLINES.values(), ids=OUTLINES)
@pytest.mark.parametrize("first", [False, True])
def test_light_passes_the_window(tmp_path, outline, first):
    (tmp_path / "wall.obj").write_text(obj(outline))
    scene = minimal_scene()
    wall = {"name": "wall", "file": "wall.obj", "material": "white"}
    scene["surfaces"] = [wall, *scene["surfaces"]] if first else [*scene["surfaces"], wall]
    scene["luminaires"] = [{"name": "lamp", "position": LAMP.tolist(), "flux": 4 * np.pi * 1000, "distribution": "isotropic"}]
    where = np.array([(3.0, y, z) for y in np.linspace(-0.6, 4.6, 9) for z in np.linspace(0.1, 2.9, 7)])
    to = LAMP - where
    distance = np.linalg.norm(to, axis=1)
    crossing = where + to * ((2 - where[:, 0]) / to[:, 0])[:, None]
    through = (np.abs(crossing[:, 1] - 2) < 1) & (np.abs(crossing[:, 2] - 1.5) < 0.5)
    around = (crossing[:, 1] < 0) | (crossing[:, 1] > 4)
    expected = np.where(through | around, 1000 * -to[:, 0] / distance**3, 0)
    assert through.sum() > 5 and (~(through | around)).sum() > 5
    np.testing.assert_allclose(direct(write_scene(tmp_path, scene), where, (-1, 0, 0)), expected, rtol=1e-9)
