# SPDX-License-Identifier: BSD-3-Clause
"""Radiance pictures: what VTK's reader, the format's definition and Radiance's own tools read in them."""
import os
import subprocess

import numpy as np
import pytest
from helpers import update_error
from kalos.vtk import vtkKalosHDRWriter
from test_exr import image_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkHDRReader

VALUES = np.array([0, 1e-9, 0.02, 5, 1234.567, 1e6])  # cd/m2, from the bottom row up
BANDS = np.array([[0, 0, 0], [1, 1, 1], [1000, 10, 1], [1, 1000, 10], [0, 0, 50], [20, 30, 0]], float)


def write(path, image, view=""):
    writer = vtkKalosHDRWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.SetView(view)
    return update_error(writer)


def decode(path, columns, rows):
    """Header, and watts (n, 3) from the bottom row up, by the definition of the format: (mantissa + 1/2) 2^(e - 136)."""
    header, _, body = path.read_bytes().partition(b"\n\n")
    size, _, pixels = body.partition(b"\n")
    assert size == f"-Y {rows} +X {columns}".encode() and len(pixels) == 4 * columns * rows
    pixels = np.frombuffer(pixels, np.uint8).reshape(rows, columns, 4)[::-1].reshape(-1, 4).astype(float)
    watts = np.where(pixels[:, 3:] > 0, (pixels[:, :3] + 0.5) * 2.0 ** (pixels[:, 3:] - 136), 0)
    return header.decode().splitlines(), watts


def luminance(watts):
    """cd/m2 as Radiance has it."""
    return 179 * watts @ (0.265, 0.670, 0.065)


def test_luminance(tmp_path):
    view = "rvu -vtv -vp 0 -1 1 -vd 0 1 0 -vu 0 0 1 -vh 60 -vv 45"
    assert write(tmp_path / "a.hdr", image_of(3, 2, Luminance=VALUES, LuminanceStandardError=VALUES / 7), view) is None
    header, watts = decode(tmp_path / "a.hdr", 3, 2)
    assert header == ["#?RADIANCE", "SOFTWARE=Kalos", "VIEW=" + view, "FORMAT=32-bit_rle_rgbe"]
    np.testing.assert_allclose(luminance(watts), VALUES, rtol=1 / 256)


def test_colours_keep_their_ratio_and_the_luminance(tmp_path):
    assert write(tmp_path / "a.hdr", image_of(3, 2, LuminanceBands=BANDS)) is None
    _, watts = decode(tmp_path / "a.hdr", 3, 2)
    np.testing.assert_allclose(luminance(watts), BANDS @ (0.2126, 0.7152, 0.0722), rtol=0.05)
    assert watts[2, 0] / watts[2, 1] == pytest.approx(100, rel=0.5)  # 8 bits of the largest


def test_vtk_reads_it(tmp_path):
    write(tmp_path / "a.hdr", image_of(3, 2, Luminance=VALUES))
    reader = vtkHDRReader()
    reader.SetFileName(str(tmp_path / "a.hdr"))
    reader.Update()
    watts = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
    np.testing.assert_allclose(179 * watts[:, 0], VALUES, rtol=1 / 100, atol=1e-12)  # it adds no half step


def test_radiance_reads_it(tmp_path):
    """pvalue of Radiance, out of the Python environment of the peers."""
    interpreter = os.environ.get("KALOS_PEERS_PYTHON")
    code = ("import sys, pyradiance, os, subprocess; program = os.path.join(os.path.dirname(pyradiance.__file__), 'bin', 'pvalue');"
            "sys.stdout.write(subprocess.run([program, '-o', '-h', '-H', '-d', '-b', sys.argv[1]], capture_output=True, check=True,"
            "text=True).stdout)")
    write(tmp_path / "a.hdr", image_of(3, 2, Luminance=VALUES))
    ran = interpreter and subprocess.run([interpreter, "-c", code, str(tmp_path / "a.hdr")], capture_output=True, text=True,
                                         env={**os.environ, "PYTHONPATH": ""})
    if not ran or ran.returncode:
        pytest.skip("no Radiance, so that its reading is not compared; KALOS_PEERS_PYTHON names a Python with pyradiance")
    values = np.array(ran.stdout.split(), float).reshape(2, 3)[::-1].ravel()
    np.testing.assert_allclose(179 * values, VALUES, rtol=1 / 200, atol=1e-12)


@pytest.mark.parametrize("value, message", [(np.nan, "pixel (1, 0): Luminance is nan"), (-1, "pixel (1, 0): Luminance is -1")])
def test_refused_pixels(tmp_path, value, message):
    assert message in write(tmp_path / "a.hdr", image_of(2, 1, Luminance=[1, value]))
    assert os.listdir(tmp_path) == []


def test_mistakes(tmp_path):
    assert "View: more than one line" in write(tmp_path / "a.hdr", image_of(1, 1, Luminance=[1]), "a\nb")
    assert "no luminance; expected the point array Luminance" in write(tmp_path / "a.hdr", image_of(1, 1, Depth=[1]))
    assert "cannot be written" in write(tmp_path / "none" / "a.hdr", image_of(1, 1, Luminance=[1]))
    writer = vtkKalosHDRWriter()
    writer.SetInputData(image_of(1, 1, Luminance=[1]))
    assert "FileName: not set" in update_error(writer)
