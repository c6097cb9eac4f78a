# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance (lx) and luminance (cd/m2) of lit scenes by Monte Carlo local estimation, in VTK pipelines.

kalos.illuminance() and kalos.luminance() estimate a scene in memory; kalos.surface(), quad(), box(), luminaire() and panel()
make one from NumPy arrays. Every VTK class is here as well: kalos.vtkKalosSceneReader, kalos.vtkKalosIlluminance and so
on. kalos.solving.solve.solve() runs the whole pipeline on a scene file, as the command `kalos solve` does.
"""
from kalos._version import __version__  # noqa: F401
from kalos.errors import InputError, Interrupted, KalosError  # noqa: F401
from kalos.estimation.estimates import illuminance, luminance  # noqa: F401
from kalos.estimation.results import Illuminance, Luminance  # noqa: F401
from kalos.scenes.geometry import box, luminaire, panel, quad, surface  # noqa: F401
from kalos.vtk import *  # noqa: F401,F403
