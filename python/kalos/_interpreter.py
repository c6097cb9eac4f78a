# SPDX-License-Identifier: BSD-3-Clause
"""Checks that this Python has the VTK that Kalos was built for; the error tells in one line what is needed and what was found."""
import sys

from kalos._build import PYTHON, VTK


def check():
    """Raises ImportError if this Python does not have the VTK that Kalos was built for."""
    version = "{}.{}".format(*sys.version_info)
    if version != PYTHON:
        refuse(f"this is Python {version}")
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
    except ImportError as error:
        refuse(f"it has no usable vtkmodules ({error})")
    found = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    if found != VTK:
        refuse(f"its VTK is {found}, of {vtkVersion.__module__} in {sys.modules['vtkmodules'].__path__[0]}")
    try:
        import kalos.vtk  # noqa: F401
    except ImportError as error:
        refuse(f"its VTK {found} in {sys.modules['vtkmodules'].__path__[0]} is of another build ({error})")


def refuse(found):
    raise ImportError(f"kalos needs Python {PYTHON} with the VTK {VTK} that it was built for, and {sys.executable} does not fit: {found}; "
                      "expected the system's python3 or pvpython") from None
