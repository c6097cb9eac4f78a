# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance (lx) and luminance (cd/m2) of lit scenes by Monte Carlo local estimation, in VTK pipelines.

kalos.illuminance() and kalos.luminance() estimate a scene in memory; kalos.surface(), quad(), box(), luminaire() and panel()
make one from NumPy arrays. Every VTK class is here as well: kalos.vtkKalosSceneReader, kalos.vtkKalosIlluminance and so
on. kalos.solve.solve() runs the whole pipeline on a scene file, as the command `kalos solve` does.
"""
from kalos.errors import InputError, Interrupted, KalosError  # noqa: F401
from kalos.vtk import *  # noqa: F401,F403

__version__ = "0.1.0"

from kalos.estimate import illuminance, luminance  # noqa: E402,F401
from kalos.results import Illuminance, Luminance  # noqa: E402,F401
from kalos.scene import box, luminaire, panel, quad, surface  # noqa: E402,F401
