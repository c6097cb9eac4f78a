# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of data/ whose illuminance is known in closed form."""
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Optional, Tuple

import numpy as np

from kalos.core.options import Options
from kalos.validation import gloss, skies, truths

PACKAGE = Path(__file__).resolve().parents[1]
DATA = PACKAGE.parents[1] / "data"  # of the source tree
if not DATA.exists():
    DATA = PACKAGE.parents[3] / "share" / "kalos" / "data"  # of an installed one


@dataclass(frozen=True)
class Case:
    """A scene whose illuminance is known at every receiver."""

    name: str
    scene: str  # below data/
    truth: Callable  # of points (n, 3) and normals (n, 3): illuminance, lx, (n,)
    trajectories: int
    precision: float  # largest relative standard error that still tests something
    cell: float = None  # m, half side of the cells of method direct; where None its means over cells are no points
    sky: Optional[int] = None  # type of the CIE that takes the place of the scene's
    methods: Optional[Tuple[str, ...]] = None  # those that are examined, such as find narrow lobes; None: all
    near: float = None  # m, delta and epsilon of the methods that average or clamp, where the automatic ones are too wide

    def takes(self, method):
        """Whether the case tells anything about a method: means over cells are no points."""
        return method in self.methods if self.methods else method != "direct" or bool(self.cell)

    def options(self, method, trajectories=None, seed=1):
        """How this case is solved by a method."""
        near = self.cell if method == "direct" else self.near
        return Options(method=method, trajectories=trajectories or self.trajectories, seed=seed, delta=near, epsilon=near)


def even(value):
    return lambda points, normals: np.full(len(points), value)


def sobolev_case(h1, rho1, rho2):
    def truth(points, normals):
        return np.array([truths.sobolev(1, h1, 1, rho1, rho2, float(np.hypot(x, y))) for x, y, _ in points])

    name = f"{10 * rho1:.0f}-{10 * rho2:.0f}"
    return Case(f"Sobolev's planes, {rho1} {rho2}", f"sobolev/sobolev-{name}.json", truth, 100000, 0.01, near=0.02)


def with_normals(truth):
    """A truth of receivers (n, 6) as one of points and normals."""
    return lambda points, normals: truth(np.hstack([points, normals]))


GLOSS = ("compensated", "gathered")


DAYLIGHT = {"5-9-1": ((1.5, 1.5, 3), (1, 0, 0), (0, 1, 0)), "5-9-4": ((0, 0, 3), (4, 0, 0), (0, 4, 0)),
            "5-11-2": ((1, 4, 1), (2, 0, 0), (0, 0, 1)), "5-11-4": ((0, 4, 0), (4, 0, 0), (0, 0, 3))}  # openings: corner and sides, m
GLAZED = {"5-9-1": "5-10-1", "5-9-4": "5-10-4", "5-11-2": "5-12-2", "5-11-4": "5-12-4"}
ALL_METHODS = (1, 13)  # skies that every method is examined under; the others differ for none of them


def daylight_case(scene, opening, kind, glass):
    """An opening of CIE 171 under one of the CIE's skies of 10 000 lx."""

    def truth(points, normals):
        shares = skies.through(kind, points, normals, *opening, transmittance=skies.pane(0.88, 1.52) if glass else None)
        return 10000 * shares.sum(axis=0)

    name = f"CIE 171 {scene.replace('-', '.', 1).replace('-', ', ')} m, sky {kind}"
    return Case(name, f"cie171/{scene}.json", truth, 65536, 3e-3, sky=kind, methods=None if kind in ALL_METHODS else ("compensated",))


def daylight_cases():
    for scene, opening in DAYLIGHT.items():
        for kind in skies.COEFFICIENTS:
            yield daylight_case(scene, opening, kind, False)
        for kind in (5, 13):
            yield daylight_case(GLAZED[scene], opening, kind, True)


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
    *daylight_cases(),
]
