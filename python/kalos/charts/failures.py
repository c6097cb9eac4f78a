# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of `kalos atlas`: a line of receivers each, where methods fail in a way of their own, and the truth there."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple

import numpy as np

from kalos.estimation.estimates import illuminance
from kalos.scenes.geometry import box, quad, surface
from kalos.scenes.luminaires import luminaire, panel
from kalos.validation.truths import polygon_form_factor, white_furnace

RHO, GLOW = 0.6, 100.0  # of the furnaces
REFERENCE = 200000  # trajectories, where no closed form is known


@dataclass(frozen=True)
class Failure:
    """A scene, receivers along a line, and what their illuminance is."""

    name: str
    title: str
    about: str  # what makes it hard
    surfaces: list
    luminaires: Optional[list]
    points: np.ndarray
    normal: tuple
    along: np.ndarray  # m, position of the receivers in pictures
    axis: str
    logarithmic: bool
    known: Optional[np.ndarray] = None  # lx; None: estimated
    source: str = "closed form"
    judge: str = "compensated"  # estimates the truth where no closed form is known

    def truth(self, seed: int = 2**31 - 1) -> Tuple[Any, Any, str]:
        """Values, their standard errors, and where they come from."""
        if self.known is not None:
            return self.known, np.zeros(len(self.known)), self.source
        found = self.solve(self.judge, REFERENCE, seed)
        error = float(np.median(found.standard_error / found.illuminance))
        return found.illuminance, found.standard_error, f"{REFERENCE} trajectories of {self.judge}, within {100 * error:.1g} %"

    def solve(self, method, trajectories, seed):
        return illuminance(self.surfaces, self.luminaires, self.points, self.normal, method=method, trajectories=trajectories,
                           seed=seed, threads=1)


def line(along, place: Callable):
    return np.array([place(t) for t in along], float)


def furnace_edge():
    along = np.geomspace(1e-4, 1, 16)
    room = box((2, 2, 2), (4, 4, 4), RHO, exitance=GLOW, inwards=True)
    return Failure("furnace-edge", "Beside an edge of the white furnace",
                   "Walls that glow and reflect meet at right angles: the kernel grows without bound, E is the same everywhere.",
                   [room], None, line(along, lambda t: (t, 1.63, 0)), (0, 0, 1), along, "distance from the wall", True,
                   np.full(len(along), white_furnace(RHO, GLOW)))


def dihedral():
    """A wedge of 5 degrees, closed at its wide end and its sides, all of which glow."""
    along, high = np.geomspace(1e-3, 2, 16), 3 * np.tan(np.radians(5))
    corners = [(0, 0, 0), (3, 0, 0), (3, 0, high), (0, 3, 0), (3, 3, 0), (3, 3, high)]
    faces = [(0, 1, 4), (0, 4, 3), (0, 3, 5), (0, 5, 2), (1, 2, 5), (1, 5, 4), (0, 2, 1), (3, 4, 5)]
    return Failure("dihedral", "In a wedge of 5 degrees", "Two faces nearly touch over a long way: half of the wedge is nearer than any radius.",
                   [surface(corners, faces, RHO, exitance=GLOW)], None, line(along, lambda t: (t, 1.63, 0)), (0, 0, 1), along,
                   "distance from the edge", True, np.full(len(along), white_furnace(RHO, GLOW)))


def contact():
    along = np.geomspace(1e-4, 1, 16)
    room = box((2, 2, 2), (4, 4, 4), RHO, exitance=GLOW, inwards=True)
    chest = box((3, 2, 0.5), (1, 1, 1), RHO, exitance=GLOW)
    return Failure("contact", "At the foot of a box", "A box stands on the floor: an edge that no mesh has, and a disc that reaches below it.",
                   [room, chest], None, line(along, lambda t: (2.5 - t, 2.1, 0)), (0, 0, 1), along, "distance from the box", True,
                   np.full(len(along), white_furnace(RHO, GLOW)))


def keyhole():
    """A bright room and a dark closet behind a wall with a hole of 10 cm."""
    along = np.linspace(0.2, 1.8, 12)
    walls = [box((2, 1, 1), (4, 2, 2), 0.7, inwards=True)]
    for y, z, wide, tall in ((0, 0, 2, 0.95), (0, 1.05, 2, 0.95), (0, 0.95, 0.95, 0.1), (1.05, 0.95, 0.95, 0.1)):
        walls.append(quad((2, y, z), (0, wide, 0), (0, 0, tall), 0.7))
    return Failure("keyhole", "Behind a keyhole", "All light comes through a hole of 10 cm: few trajectories and few paths get there.",
                   walls, [luminaire((3, 1, 1.9), 10000)], line(along, lambda t: (t, 1.4, 0)), (0, 0, 1), along,
                   "place on the closet's floor", False)


def glossy():
    along = np.linspace(0.1, 3.9, 14)
    room = box((2, 1.5, 1.25), (4, 3, 2.5), 0.5, inwards=True)
    plate = quad((0.2, 0.01, 0.2), (0, 0, 2), (3.6, 0, 0), 0.1, specular=0.7, roughness=0.2)
    return Failure("glossy-room", "Before a glossy wall", "A polished plate throws a lamp's light on the floor: narrow lobes, which some methods never ask.",
                   [room, plate], [panel((1.7, 1.2, 2.4), (0.3, 0, 0), (0, 0.3, 0), 5000, aim=(0, 0, -1))],
                   line(along, lambda t: (t, 0.6, 0)), (0, 0, 1), along, "place on the floor", False, judge="paths")


def many_lamps():
    along = np.linspace(0.2, 9.8, 14)
    hall = box((5, 5, 1.5), (10, 10, 3), 0.5, inwards=True)
    racks = [box((5, y, 1), (9, 0.4, 2), 0.3) for y in (2.5, 5, 7.5)]
    lamps = [luminaire((x, y, 2.9), 300) for x in np.arange(0.25, 10, 0.5) for y in np.arange(0.25, 10, 0.5)]
    return Failure("many-lamps", "Under 400 lamps between racks", "Each point is lit by some of them: which ones is what a method has to find out.",
                   [hall, *racks], lamps, line(along, lambda t: (t, 3.75, 0)), (0, 0, 1), along, "place in the aisle", False)


def caustic():
    """A luminous panel that shines at a mirror, behind its back: all light there is that of its image."""
    along, size, flux, mirror = np.linspace(1.2, 3.4, 12), 0.1, 1000.0, 0.9
    points = line(along, lambda t: (t, 1.5, 0))
    image = np.array([(-1, 1.45, 0.75), (-1, 1.45 + size, 0.75), (-1, 1.45 + size, 0.75 + size), (-1, 1.45, 0.75 + size)])
    known = [mirror * flux / size**2 * polygon_form_factor(p, np.array([0.0, 0, 1]), image) for p in points]
    reflector = quad((0, -3, -3), (0, 10, 0), (0, 0, 10), 0, mirror=mirror)
    floor = quad((0, 0, -0.01), (4, 0, 0), (0, 3, 0), 0.01)
    lamp = panel((1, 1.5, 0.75 + size / 2), (0, size, 0), (0, 0, size), flux, aim=(-1, 0, 0))
    return Failure("caustic", "Behind a lamp that shines at a mirror",
                   "All light comes by the image of a small panel: only a ray that meets it, or a photon, finds it.",
                   [reflector, floor], [lamp], points, (0, 0, 1), along, "distance from the mirror", False, np.array(known))


def empty_room():
    along = np.linspace(0.3, 3.7, 12)
    room = box((2, 1.5, 1.25), (4, 3, 2.5), 0.5, inwards=True)
    return Failure("empty-room", "In an empty diffuse room", "Nothing is in the way and nothing shines: where finite elements are at home.",
                   [room], [luminaire((1.2, 1.5, 2.4), 3000)], line(along, lambda t: (t, 1.2, 0)), (0, 0, 1), along, "place on the floor", False)


FAILURES: dict[str, Callable[[], Failure]] = {
    "furnace-edge": furnace_edge, "dihedral": dihedral, "contact": contact, "keyhole": keyhole, "glossy-room": glossy,
    "many-lamps": many_lamps, "caustic": caustic, "empty-room": empty_room}
