# SPDX-License-Identifier: BSD-3-Clause
"""Luminance images as Radiance pictures."""
import math

from kalos.errors import update
from kalos.vtk import vtkKalosHDRWriter


def write_hdr(folder, reader, images):
    """NAME.hdr for every camera of the scene, with its view in the header."""
    for index in range(reader.GetNumberOfCameras()):
        name = reader.GetCameraName(index)
        writer = vtkKalosHDRWriter()
        writer.SetFileName(str(folder / f"{name}.hdr"))
        writer.SetView(view(reader, index))
        writer.SetInputData(images[name])
        update(writer, writer.Write)


def view(reader, index):
    """Options of Radiance's rvu for a camera of the scene: -vh and -vv are full angles in degrees."""
    position, target, up, resolution = [0.0] * 3, [0.0] * 3, [0.0] * 3, [0] * 2
    for get, values in ((reader.GetCameraPosition, position), (reader.GetCameraTarget, target), (reader.GetCameraUp, up),
                        (reader.GetCameraResolution, resolution)):
        get(index, values)
    vertical = reader.GetCameraFieldOfView(index)
    half = math.tan(math.radians(vertical) / 2) * resolution[0] / resolution[1]
    towards = [t - p for t, p in zip(target, position)]
    vectors = " ".join(f"{option} " + " ".join(f"{x:.9g}" for x in vector)
                       for option, vector in (("-vp", position), ("-vd", towards), ("-vu", up)))
    return f"rvu -vtv {vectors} -vh {2 * math.degrees(math.atan(half)):.9g} -vv {vertical:.9g}"
