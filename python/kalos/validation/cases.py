# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of data/ whose illuminance is known in closed form."""
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np

from kalos.core.options import Options
from kalos.validation import gloss, truths

PACKAGE = Path(__file__).resolve().parents[1]
DATA = PACKAGE.parents[1] / "data"  # of the source tree
if not DATA.exists():
    DATA = PACKAGE.parents[3] / "share" / "kalos" / "data"  # of an installed one


PATHS = {"paths": 64, "bidirectional": 8}  # they start a path at each receiver per trajectory: so many times fewer do


@dataclass(frozen=True)
class Case:
    """A scene whose illuminance is known at every receiver."""

    name: str
    scene: str  # below data/
    truth: Callable  # of points (n, 3) and normals (n, 3): illuminance, lx, (n,)
    trajectories: int
    precision: float  # largest relative standard error that still tests something
    cell: float = None  # m, half side of the cells of method direct; where None its means over cells are no points
    methods: tuple = None  # that find the light of narrow lobes within any reasonable time; None: all
    finite: bool = True  # finite elements can cover it
    near: float = None  # m, delta and epsilon of the methods that average or clamp, where the automatic ones are too wide

    def takes(self, method):
        """Whether the case tells anything about a method: means over cells are no points, planes without end no elements."""
        if self.methods:
            return method in self.methods
        return (method != "direct" or bool(self.cell)) and (method != "radiosity" or self.finite)

    def options(self, method, trajectories=None, seed=1):
        """How this case is solved by a method."""
        near = self.cell if method == "direct" else self.near
        own = self.trajectories // PATHS.get(method, 1)
        return Options(method=method, trajectories=trajectories or own, seed=seed, delta=near, epsilon=near)


def even(value):
    return lambda points, normals: np.full(len(points), value)


def sobolev_case(h1, rho1, rho2):
    def truth(points, normals):
        return np.array([truths.sobolev(1, h1, 1, rho1, rho2, float(np.hypot(x, y))) for x, y, _ in points])

    name = f"{10 * rho1:.0f}-{10 * rho2:.0f}"
    return Case(f"Sobolev's planes, {rho1} {rho2}", f"sobolev/sobolev-{name}.json", truth, 100000, 0.01, finite=False, near=0.02)


def with_normals(truth):
    """A truth of receivers (n, 6) as one of points and normals."""
    return lambda points, normals: truth(np.hstack([points, normals]))


GLOSS = ("compensated", "gathered")
CASES = [
    Case("white furnace, boxes", "furnace/furnace.json", even(truths.white_furnace(0.6, 100)), 300000, 0.05, cell=0.25),
    sobolev_case(0.5, 0.5, 0.5),
    sobolev_case(0.5, 0.8, 0.8),
    sobolev_case(0.9, 0.2, 0.7),
    Case("CIE 171 5.2, point", "cie171/5-2.json", lambda p, n: truths.cie171_point(p), 10000, 1e-3),
    Case("CIE 171 5.3, area", "cie171/5-3.json", truths.cie171_area, 10000, 1e-3),
    Case("CIE 171 5.4, isotropic", "cie171/5-4.json",
         lambda p, n: truths.isotropic_point(p, n, np.array([2, 2, 1.5]), 10000), 10000, 1e-3),
    Case("CIE 171 5.6, reflection", "cie171/5-6.json", lambda p, n: 300 * truths.cie171_reflection(p, n), 10000, 1e-3),
    Case("CIE 171 5.7, obstruction", "cie171/5-7.json", lambda p, n: 300 * truths.cie171_obstruction(p, n), 400000, 0.01),
    Case("lamp over a glossy plane", "gloss/plane.json", with_normals(gloss.glossy_plane(1000, (0, 0, 1), 0.3, 0.5, 0.2)), 20000, 0.01,
         methods=GLOSS),
    Case("lamp, gloss and a mirror", "gloss/mirror.json", with_normals(gloss.glossy_plane(1000, (1.5, 0, 1), 0.3, 0.3, 0.2, 0.8)), 20000,
         0.01, methods=GLOSS),
    Case("furnace, glossy floor", "gloss/furnace.json", with_normals(gloss.furnace_floor(1000, (4, 3, 2.5), 0.4, 0.3, 0.3)), 20000,
         0.01, methods=GLOSS),
]
