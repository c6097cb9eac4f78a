# SPDX-License-Identifier: BSD-3-Clause
"""Edges, contacts and narrow gaps, where the geometric kernel is unbounded."""
from typing import NamedTuple

import numpy as np

from closed import furnace
from room import Room
from shapes import box, grid, joined, lamp, obj, row, scene, shell, sphere

FURNACE, TRACED = "closed form: white furnace, M0/(1 - rho) everywhere", "path tracer of the zoo"
GREY, EXITANCE = 0.6, 100.0
LUMINOUS = {"grey": {"reflectance": GREY, "exitance": EXITANCE}}


def prism(profile, length):
    """The text of an OBJ file: a polygon (x, z), counterclockwise seen from -y, drawn out along y, closed, normals inwards."""
    count = len(profile)
    vertices = [(x, y, z) for y in (0, length) for x, z in profile]
    sides = [(i, (i + 1) % count, (i + 1) % count + count, i + count) for i in range(count)]
    return obj(vertices, [*sides, tuple(range(count))[::-1], tuple(range(count, 2 * count))])


def wedge(angle, depth):
    slope = np.radians(angle)
    return [(0, 0), (depth, 0), (depth * np.cos(slope), depth * np.sin(slope))]


def along_wedge(angle):
    """Receivers on both planes of a wedge, 1 mm to 1.6 m from its edge."""
    slope, places = np.radians(angle), np.geomspace(0.001, 1.6, 7)
    lower = [[x, 1.1, 0, 0, 0, 1] for x in places]
    upper = [[x * np.cos(slope), 0.9, x * np.sin(slope), np.sin(slope), 0, -np.cos(slope)] for x in places]
    return np.array(lower + upper, float)


def fins(material, gap=0.005, thickness=0.002, count=20):
    return [box(f"fin{i}", (1 + i * (gap + thickness), 1, 0.25), (thickness, 1, 0.5), material) for i in range(count)]


def between_fins(gap=0.005, thickness=0.002):
    """Receivers on the floor between fins, and up the side of one."""
    x = 1 + 7 * (gap + thickness) + thickness / 2
    return joined(row((x + 0.0005, 0.9, 0), (x + gap - 0.0005, 0.9, 0), (0, 0, 1), 5), row((x, 1.1, 0.002), (x, 1.1, 0.45), (1, 0, 0), 7))


def ball_on_floor(radius=0.4, level=4, center=(1.5, 1.2)):
    """A ball that touches the floor: OBJ text."""
    points, faces = sphere(radius, level, inwards=False)
    points = points - [0, 0, points[:, 2].min()] + [*center, 0]
    return obj(points, faces)


def about_contact(center=(1.5, 1.2), nearest=0.003):
    distances = np.geomspace(nearest, 0.4, 12)
    return np.array([[center[0] + d * np.cos(2.4 * i), center[1] + d * np.sin(2.4 * i), 0, 0, 0, 1] for i, d in enumerate(distances)])


def down_gap(x, y, top, nearest, farthest):
    """Receivers down a side of a gap, the normal along x."""
    return np.array([[x, y, top - d, 1, 0, 0] for d in np.geomspace(nearest, farthest, 10)])


def surface(name):
    return {"name": name, "file": f"{name}.obj", "material": "grey"}


class Place(NamedTuple):
    """What is made into two rooms: a white furnace, and one lit by a lamp."""

    kind: str
    surfaces: list
    receivers: np.ndarray
    shallow: np.ndarray = None  # receivers by the lamp, where others are too dark for any truth
    files: dict = {}
    light: tuple = (1.6, 1.0, 1.6)

    def furnace(self, name):
        return Room(f"{name}-furnace", self.kind, scene(LUMINOUS, self.surfaces), self.receivers, FURNACE, furnace(GREY, EXITANCE),
                    files=self.files)

    def lit(self, name):
        receivers = self.receivers if self.shallow is None else self.shallow
        return Room(f"{name}-lamp", self.kind, scene({"grey": GREY}, self.surfaces, [lamp(self.light)]), receivers, TRACED,
                    files=self.files)


HALL = shell((3, 2.5, 2), "grey")
BLOCKS = [box("west", (0.99995, 1.2, 0.4), (1, 1, 0.8), "grey"), box("east", (2, 1.2, 0.4), (1, 1, 0.8), "grey")]
PLATE = box("plate", (1.5, 1.2, 0.051), (1, 1, 0.1), "grey")
DESKS = [box(f"desk{i}", (0.6 + 0.9 * i, 1.0 + 0.3 * i, 0.5), (0.5, 0.7, 1.0), "grey", 20 * i) for i in range(3)]
SHELVES = [box(f"shelf{i}", (0.2, 1.2, 0.2 + 0.3 * i), (0.4, 1.0, 0.02), "grey") for i in range(6)]
PLACES = {
    "comb": Place("comb of fins", [*HALL, *fins("grey")], between_fins(), down_gap(1.05, 1.1, 0.5, 0.001, 0.05)),
    "ball": Place("ball contact", [*HALL, surface("ball")], about_contact(), files={"ball.obj": ball_on_floor()}),
    "slot": Place("slot of 0.05 mm", [*HALL, *BLOCKS],
                  joined(row((1.49999, 1.0, 0), (1.49999, 1.5, 0), (0, 0, 1), 4),
                         row((1.49995, 1.3, 0.001), (1.49995, 1.3, 0.79), (1, 0, 0), 8)),
                  down_gap(1.49995, 1.3, 0.8, 0.00002, 0.0005)),
    "contact": Place("1 mm above the floor", [*HALL, PLATE],
                     joined(row((1.01, 1.2, 0), (1.5, 1.2, 0), (0, 0, 1), 6), row((1.01, 1.3, 0.001), (1.4, 1.3, 0.001), (0, 0, -1), 6)),
                     np.array([[1 + d, 1.3, 0, 0, 0, 1] for d in np.geomspace(0.0002, 0.01, 10)])),
    "desk": Place("plane through furniture", [*HALL, *DESKS],
                  joined(row((0.8501, 0.7, 0.75), (0.8501, 1.3, 0.75), (0, 0, 1), 5),
                         grid((1.9, 0.1, 0.75), (1, 0, 0), (0, 0.7, 0), 4, 2))),
    "shelf": Place("shelves", [*HALL, *SHELVES],
                   joined(row((0.01, 1.1, 0.811), (0.39, 1.1, 0.811), (0, 0, 1), 6), row((0, 1.3, 0.82), (0, 1.3, 1.08), (1, 0, 0), 6))),
    "wedge": Place("5 degree wedge", [surface("wedge")], along_wedge(5), files={"wedge.obj": prism(wedge(5, 2), 2)},
                   light=(1.7, 1.2, 0.07)),
}
ROOMS = [place.furnace(name) for name, place in PLACES.items()] + [place.lit(name) for name, place in PLACES.items()]
