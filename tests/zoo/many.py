# SPDX-License-Identifier: BSD-3-Clause
"""Many lamps, few receivers, colours."""
import numpy as np

from closed import even
from room import Room
from shapes import box, grid, joined, lamp, panel, quad, room_places, row, scene, shell

SIZE = (4, 3, 2.5)
LUMINOUS_SHARES = (0.2126, 0.7152, 0.0722)  # of linear Rec. 709


def coloured_furnace(name, receivers):
    """A white furnace in three bands, each with its own reflectance."""
    reflectance, exitance = [0.8, 0.5, 0.1], [60.0, 100.0, 200.0]
    truth = sum(share * m / (1 - rho) for share, m, rho in zip(LUMINOUS_SHARES, exitance, reflectance))
    surfaces = [*shell(SIZE, "glow"), box("block", (2.3, 1.0, 0.4), (0.8, 0.6, 0.8), "glow", 30)]
    return Room(name, "colours", scene({"glow": {"reflectance": reflectance, "exitance": exitance}}, surfaces), receivers,
                "closed form: white furnace of every band, weighed by its luminous share", even(truth))


TRACED = "path tracer of the zoo"
MATERIALS = {"white": 0.8, "wall": 0.5, "dark": 0.25, "glow": {"reflectance": 0, "exitance": 2e5}, "red": {"reflectance": [0.7, 0.1, 0.1]},
             "green": {"reflectance": [0.1, 0.6, 0.15]}, "pale": {"reflectance": [0.7, 0.7, 0.6]}}
FACES = {"": "wall", "ceiling": "white", "floor": "dark"}
DESK = [box("desk", (2.5, 0.5, 0.37), (1.4, 0.6, 0.74), "wall"), box("cabinet", (0.25, 0.45, 0.9), (0.4, 0.6, 1.8), "wall")]


def plain(name, kind, luminaires, more=(), receivers=None, faces=None, ordinary=True):
    places = joined(room_places(SIZE), grid((1.9, 0.25, 0.75), (1.2, 0, 0), (0, 0.5, 0), 3, 2)) if receivers is None else receivers
    return Room(name, kind, scene(MATERIALS, [*shell(SIZE, faces or FACES), *DESK, *more], luminaires), places, TRACED,
                ordinary=ordinary)


def many_lamps(name, columns, rows, near=None):
    """A low hall under a grid of lamps; with `near` a dim one of so many lumens 3 cm above a receiver."""
    size = (20, 16, 4)
    lamps = [lamp((20 * (i + 0.5) / columns, 16 * (j + 0.5) / rows, 3.9), 2e5 / (columns * rows), "lambertian", name=f"lamp{i}-{j}")
             for i in range(columns) for j in range(rows)]
    receivers = joined(room_places(size), row((8.2, 7.1, 0.8), (8.6, 7.1, 0.8), (0, 0, 1), 3))
    lamps += [lamp((8.4, 7.1, 0.83), near, name="near")] if near else []
    surfaces = [*shell(size, FACES), box("bench", (8.4, 7.1, 0.4), (1, 0.8, 0.8), "wall")]
    return Room(name, "many lamps", scene(MATERIALS, surfaces, lamps), receivers, TRACED)


PANELS = [panel((x, y, 2.499), (0.6, 0, 0), (0, 0.6, 0), (0, 0, -1), 2000, f"panel{x}-{y}") for x in (1.0, 3.0) for y in (0.8, 2.2)]
SPARK = [quad("spark", (1.0, 1.2, 2.45), (0, 0.05, 0), (0.05, 0, 0), "glow")]
ROOMS = [
    coloured_furnace("colour-furnace", room_places(SIZE)),
    coloured_furnace("colour-furnace-one", np.array([[2.6, 2.1, 0, 0, 0, 1]])),
    plain("office", "ordinary", PANELS), plain("downlight", "ordinary", [lamp((1.8, 1.3, 2.5), 2000, "lambertian")]),
    plain("floor-lamp", "ordinary", [lamp((1.1, 2.2, 1.7))]),
    plain("few-receivers", "few receivers", PANELS, receivers=np.array([(1.3, 2.4, 0, 0, 0, 1), (2.2, 0.6, 0.75, 0, 0, 1.0)])),
    plain("spark", "small bright mesh", [], SPARK, ordinary=False),
    plain("colour-room", "colours", [lamp((1.8, 1.3, 2.1))], faces={"": "pale", "left": "red", "right": "green"}),
    many_lamps("lamps-2000", 50, 40), many_lamps("lamps-400-one-near", 20, 20, 0.5),
]
