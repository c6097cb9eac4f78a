# SPDX-License-Identifier: BSD-3-Clause
"""How the user wants pictures: range and kind of the scale, colours, isolines."""
from dataclasses import dataclass
from typing import Optional, Tuple

from kalos.errors import KalosError

OWN_COLOURS = "kalos"


@dataclass(frozen=True)
class Look:
    """Two pictures of the same look have the same scale where its range is given."""

    illuminance: Optional[Tuple[float, float]] = None  # lx, ends of the scale; None is automatic
    luminance: Optional[Tuple[float, float]] = None  # cd/m2
    log: bool = False
    colours: str = OWN_COLOURS  # or a colour map of Matplotlib
    isolines: bool = False

    def check(self):
        """Raises KalosError where it cannot be drawn."""
        from matplotlib import colormaps

        if self.colours != OWN_COLOURS and self.colours not in colormaps:
            raise KalosError(f"--colours: {self.colours!r} is not allowed, expected {OWN_COLOURS} or a colour map of Matplotlib, such "
                             "as viridis")
        for option, ends in (("--range", self.illuminance), ("--luminance-range", self.luminance)):
            if self.log and ends and not ends[0] > 0:
                raise KalosError(f"{option}: starts at {ends[0]:g}, expected more than 0 with --log")


LOOK = Look()  # where nothing is said
