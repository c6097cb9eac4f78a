# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance (lx) and luminance (cd/m2) of lit scenes by Monte Carlo local estimation, in VTK pipelines.

Every VTK class of Kalos is here: kalos.vtkKalosSceneReader, kalos.vtkKalosIlluminance and so on. kalos.solve.solve runs
the whole pipeline on a scene file, as the command `kalos solve` does.
"""
from kalos.errors import KalosError  # noqa: F401
from kalos.vtk import *  # noqa: F401,F403

__version__ = "0.1.0"
