# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance (lx) and luminance (cd/m2) of lit scenes by Monte Carlo local estimation, in VTK pipelines.

A scene in memory: surface(), quad() and box() make surfaces from NumPy arrays, luminaire(),
panel() and sky() what lights them;
illuminance() and luminance() estimate it and return an Illuminance or a Luminance with a standard error for every value.

A scene file: Scene reads, builds, changes and writes one. solve() writes a folder of tables and pictures as the command
`kalos solve` does, its pictures in the Look asked for; study(), chart() and validate() are the other commands.

Every VTK class is here as well, for pipelines: vtkKalosSceneReader, vtkKalosIlluminance and so on; help(kalos.vtk) lists them.
kalos.ranks.join() lets the processes of mpiexec share a solve. kalos.photometry draws photometric files, kalos.metrics has
cylindrical and semi-cylindrical illuminance. What is wrong with an argument raises InputError, a ValueError; other failures
raise KalosError; Ctrl-C raises Interrupted.
"""
from kalos import _interpreter

_interpreter.check()

from kalos._build import __version__  # noqa: E402
from kalos.calls import chart, solve, study, validate  # noqa: E402
from kalos.errors import InputError, Interrupted, KalosError  # noqa: E402
from kalos.estimation.estimates import illuminance, luminance  # noqa: E402
from kalos.estimation.results import Illuminance, Luminance  # noqa: E402
from kalos.pictures.look import Look  # noqa: E402
from kalos.scenes.geometry import box, quad, surface  # noqa: E402
from kalos.scenes.luminaires import luminaire, panel  # noqa: E402
from kalos.scenes.scene import Scene  # noqa: E402
from kalos.scenes.skies import sky, sun_position  # noqa: E402
from kalos.vtk import *  # noqa: E402,F403

__all__ = ["Illuminance", "InputError", "Interrupted", "KalosError", "Look", "Luminance", "Scene", "__version__", "box", "chart", "illuminance",
           "luminaire", "luminance", "panel", "quad", "sky", "solve", "study", "sun_position", "surface", "validate"]
