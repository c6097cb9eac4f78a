# SPDX-License-Identifier: BSD-3-Clause
"""Many lamps, few receivers, colours."""
from closed import even
from room import Room
from shapes import box, room_places, row, scene, shell

SIZE = (4, 3, 2.5)
LUMINOUS_SHARES = (0.2126, 0.7152, 0.0722)  # of linear Rec. 709


def coloured_furnace(name, receivers):
    """A white furnace in three bands, each with its own reflectance."""
    reflectance, exitance = [0.8, 0.5, 0.1], [60.0, 100.0, 200.0]
    truth = sum(share * m / (1 - rho) for share, m, rho in zip(LUMINOUS_SHARES, exitance, reflectance))
    surfaces = [*shell(SIZE, "glow"), box("block", (2.3, 1.0, 0.4), (0.8, 0.6, 0.8), "glow", 30)]
    return Room(name, "colours", scene({"glow": {"reflectance": reflectance, "exitance": exitance}}, surfaces), receivers,
                "closed form: white furnace of every band, weighed by its luminous share", even(truth))


ROOMS = [coloured_furnace("colour-furnace", room_places(SIZE)), coloured_furnace("colour-furnace-one", row((2.6, 2.1, 0), (2.6, 2.1, 0), (0, 0, 1), 1))]
