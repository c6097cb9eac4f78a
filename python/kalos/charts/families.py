# SPDX-License-Identifier: BSD-3-Clause
"""The families that methods and peers belong to, their colours, and one line each of what it is and who uses it."""
from dataclasses import dataclass
from typing import Any, Dict

from kalos.peers import NAMES


@dataclass(frozen=True)
class Family:
    """Methods that fail alike; `colours` from strong to light, one a method in order."""

    title: str
    about: dict  # line per method
    colours: tuple
    linestyle: object = "-"


FAMILIES = (
    Family("exact: local estimates that are bounded or left as they are",
           {"compensated": "vertices and gather rays share each score: no bias, no spikes; the default here",
            "gathered": "gather rays onto shared estimates: fastest on grids; a bias that it states",
            "local": "vertices alone (instant radiosity, MCNP's point detector): no bias, spikes at edges"},
           ("#0b5d8f", "#2f9fd0", "#174a63")),
    Family("averaging: the kernel near a receiver is averaged, clamped or counted on a cell",
           {"sphere-published": "one sample of a sphere, as printed (Budak et al. 2023): too dark near by",
            "sphere-exact": "the same with exact weights: blurs over the sphere",
            "disc": "mean over a disc, in closed form: what a meter's head reads",
            "clamped": "kernel cut at a limit, as renderers do: too dark at edges",
            "direct": "flux counted on a cell: direct simulation, the literature's baseline"},
           ("#8c6d31", "#b08a3c", "#5d5a2a", "#c4a35a", "#6f5a3a")),
    Family("finite elements", {"radiosity": "equations between elements of surface: RELUX, AGi32, the older DIALux"}, ("#7a3e9d",)),
    Family("photons", {"photon-map": "density of photons on a disc: DIALux evo; half of it is off the surface at an edge"}, ("#d1457b",)),
    Family("paths",
           {"paths": "path tracing with next event estimation: Mitsuba, Cycles, LuxCoreRender",
            "bidirectional": "every joint of a light's and a receiver's path: LuxCoreRender's and Mitsuba 0.6's BDPT"},
           ("#1b8a5a", "#6cbf3f")),
    Family("peers: other programs", dict(zip(NAMES, ("Mitsuba 3's path tracer, one LLVM wavefront", "Radiance's rtrace, no cache",
                                                     "Radiance's rtrace with its ambient cache"))),
           ("#c2571a", "#d4a017", "#8f2d2d"), (0, (4, 1.5))),
)


def family(name: str) -> Family:
    """The family of a method or peer."""
    return next(one for one in FAMILIES if name in one.about)


def about(name: str) -> Any:
    return family(name).about[name]


def style(name: str) -> Dict[str, Any]:
    """Colour and line of a method or peer."""
    one = family(name)
    return {"color": one.colours[list(one.about).index(name)], "linestyle": one.linestyle}
