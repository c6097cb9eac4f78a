# SPDX-License-Identifier: BSD-3-Clause
"""Photometric files for tests, written from an intensity, and a second, plain reading of them."""
import numpy as np

from kalos.errors import update
from kalos.vtk import vtkKalosPhotometryReader


def write_ies(path, intensity, planes=(0,), angles=tuple(range(0, 91, 5)), opening=(0, 0, 0), lumens=-1, version="IESNA:LM-63-2002",
              type_=1):
    """An LM-63 file of `intensity(plane, angle)` in cd; the opening is width, length, height in m."""
    lines = [version, "[LUMINAIRE] Test lamp", "TILT=NONE",
             f"1 {lumens} 1 {len(angles)} {len(planes)} {type_} 2 {' '.join(map(str, opening))}", "1 1 40",
             " ".join(map(repr, map(float, angles))), " ".join(map(repr, map(float, planes)))]
    lines += [" ".join(repr(float(intensity(p, a))) for a in angles) for p in planes]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_ldt(path, intensity, planes=tuple(range(0, 360, 15)), angles=tuple(range(0, 91, 5)), size=(0, 0), flux=1000.0, symmetry=0,
              ratio=0):
    """A EULUMDAT file of `intensity(plane, angle)` in cd; size is length and width of the opening in mm."""
    kept = {0: planes, 1: planes[:1], 4: [p for p in planes if p <= 90]}[symmetry]
    head = ["Company", 1, symmetry, len(planes), 0, len(angles), 0, "report", "Test lamp", "7", "file", "date", 0, 0, 0, *size,
            0, 0, 0, 0, 100, ratio, 1, 0, 1, 1, "lamp", flux, 4000, 80, 40, *[0.5] * 10, *planes, *angles]
    body = [repr(float(intensity(p, a)) * 1000 / flux) for p in kept for a in angles]
    path.write_text("\r\n".join(map(str, [*head, *body])) + "\r\n")
    return path


def read(path, **properties):
    """A reader that has read the file; an error is a KalosError."""
    reader = vtkKalosPhotometryReader()
    reader.SetFileName(str(path))
    for name, value in properties.items():
        getattr(reader, f"Set{name}")(value)
    update(reader)
    return reader


def codes(reader):
    return [reader.GetWarningCode(i) for i in range(reader.GetNumberOfWarnings())]


def bilinear(planes, angles, candela, c, gamma):
    """The standards' interpolation between the entries of a table, written down once more."""
    i = min(np.searchsorted(planes, c, side="right") - 1, len(planes) - 2)
    k = min(np.searchsorted(angles, gamma, side="right") - 1, len(angles) - 2)
    s, t = (c - planes[i]) / (planes[i + 1] - planes[i]), (gamma - angles[k]) / (angles[k + 1] - angles[k])
    low, high = ((1 - t) * row[k] + t * row[k + 1] for row in (candela[i], candela[i + 1]))
    return (1 - s) * low + s * high
