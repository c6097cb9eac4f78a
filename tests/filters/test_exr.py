# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR images: round trips without loss, refused pixels, damaged files."""
import math
import os
import struct

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from helpers import update_error
from kalos.vtk import vtkKalosEXRReader, vtkKalosEXRWriter

# Beyond what half floats hold or resolve: 1e-9 would vanish, 1e6 overflow, 1234.567 round.
VALUES = np.array([0, 1e-9, 1234.567, 1e6, 3.4e38, 0.1], dtype=np.float32)


def image_of(width, height, **arrays):
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.asarray(values, dtype=np.float64), deep=True)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    return image


def write(path, image):
    writer = vtkKalosEXRWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    return update_error(writer)


def read(path):
    reader = vtkKalosEXRReader()
    reader.SetFileName(str(path))
    assert update_error(reader) is None
    data = reader.GetOutput().GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    return reader.GetOutput().GetDimensions(), arrays


def read_error(path):
    reader = vtkKalosEXRReader()
    reader.SetFileName(str(path))
    error = update_error(reader)
    assert error is not None, "no error"
    assert reader.GetOutput().GetPointData().GetNumberOfArrays() == 0
    return error.replace(str(path), "FILE")


def test_round_trip_of_luminance(tmp_path):
    assert write(tmp_path / "a.exr", image_of(3, 2, Luminance=VALUES, LuminanceStandardError=VALUES / 7)) is None
    dimensions, arrays = read(tmp_path / "a.exr")
    assert dimensions == (3, 2, 1)
    assert sorted(arrays) == ["Luminance", "LuminanceStandardError"]
    assert all(array.dtype == np.float32 for array in arrays.values())
    assert (arrays["Luminance"] == VALUES).all()
    assert (arrays["LuminanceStandardError"] == VALUES / np.float32(7)).all()
    assert os.listdir(tmp_path) == ["a.exr"]


def test_round_trip_of_three_bands(tmp_path):
    bands = np.arange(18, dtype=np.float32).reshape(6, 3)
    assert write(tmp_path / "a.exr", image_of(3, 2, Luminance=VALUES, LuminanceBands=bands)) is None
    _, arrays = read(tmp_path / "a.exr")
    assert (arrays["LuminanceBands"] == bands).all()
    assert arrays["Luminance"] == pytest.approx(bands @ [0.2126, 0.7152, 0.0722], rel=1e-6)


def test_header_and_row_order(tmp_path):
    # Byte by byte, as another program would read it.
    write(tmp_path / "a.exr", image_of(1, 2, Luminance=[5, 7]))
    content = (tmp_path / "a.exr").read_bytes()
    assert content[:4] == b"\x76\x2f\x31\x01"
    # Channel list: name, type 2 = float32, then sampling 1 x 1.
    assert b"channels\0chlist\0" in content and b"Y\0" + struct.pack("<iiii", 2, 0, 1, 1) in content
    chromaticities = struct.pack("<8f", 0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329)
    assert b"chromaticities\0chromaticities\0" + struct.pack("<i", 32) + chromaticities in content
    assert b"whiteLuminance\0float\0" + struct.pack("<if", 4, 1.0) in content
    # Two pixels are stored raw; the top row, VTK's last, comes first.
    assert struct.pack("<ff", 7, 5) in content


@pytest.mark.parametrize("value, shown", [
    (math.nan, "nan"), (math.inf, "inf"), (-0.001, "-0.001"), (1e39, "1e+39")])
@pytest.mark.parametrize("name", ["Luminance", "LuminanceStandardError"])
def test_values_that_are_no_luminance(tmp_path, name, value, shown):
    (tmp_path / "a.exr").write_text("before")
    arrays = {"Luminance": [1.0] * 6, "LuminanceStandardError": [1.0] * 6}
    arrays[name][4] = value
    error = write(tmp_path / "a.exr", image_of(3, 2, **arrays))
    assert error == (f"{tmp_path}/a.exr: pixel (1, 1): {name} is {shown}; "
                     "expected a finite float32 value of at least 0 cd/m2")
    assert (tmp_path / "a.exr").read_text() == "before"
    assert os.listdir(tmp_path) == ["a.exr"]


def test_writer_mistakes(tmp_path):
    good = image_of(1, 1, Luminance=[1])
    writer = vtkKalosEXRWriter()
    writer.SetInputData(good)
    assert update_error(writer) == "image: FileName: not set; expected the path of an .exr file"
    assert write(tmp_path / "a.exr", image_of(1, 1, Other=[1])).endswith(
        "image: no luminance; expected the point array Luminance, 1 component, in cd/m2")
    volume = vtkImageData()
    volume.SetDimensions(2, 2, 2)
    assert write(tmp_path / "a.exr", volume).endswith(
        "image: not one slice of pixels; expected a width x height x 1 image")
    message = "file: cannot be written; expected a writable folder with room on the disk"
    assert write(tmp_path / "absent" / "a.exr", good) == f"{tmp_path}/absent/a.exr: {message}"
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "child").mkdir()
    assert write(tmp_path / "folder", good) == f"{tmp_path}/folder: {message}"
    assert os.listdir(tmp_path) == ["folder"]


def test_reader_mistakes(tmp_path):
    reader = vtkKalosEXRReader()
    assert update_error(reader) == "image: FileName: not set; expected the path of an .exr file"
    assert read_error(tmp_path / "a.exr") == "FILE: file: no such file; expected an OpenEXR image"
    (tmp_path / "a.exr").write_bytes(b"\x89PNG" * 100)
    assert read_error(tmp_path / "a.exr") == "FILE: file: not an OpenEXR image; expected one"
    (tmp_path / "a.exr").write_bytes(b"\x76\x2f\x31\x01" + b"\x02\0\0\0garbage" * 10)
    assert read_error(tmp_path / "a.exr") == "FILE: header: an attribute ends beyond the file; expected a complete OpenEXR image"


def test_truncated_files(tmp_path):
    values = np.random.default_rng(1).random(64 * 64)
    write(tmp_path / "a.exr", image_of(64, 64, Luminance=values))
    content = (tmp_path / "a.exr").read_bytes()
    for length in (100, len(content) // 3, len(content) // 2, len(content) - 1):
        (tmp_path / "b.exr").write_bytes(content[:length])
        what = "header: an attribute ends beyond the file" if length == 100 else "file: damaged or truncated"
        assert read_error(tmp_path / "b.exr") == f"FILE: {what}; expected a complete OpenEXR image"


def patched(tmp_path, old, new):
    write(tmp_path / "a.exr", image_of(3, 2, Luminance=VALUES))
    content = (tmp_path / "a.exr").read_bytes()
    assert old in content
    (tmp_path / "a.exr").write_bytes(content.replace(old, new))
    return tmp_path / "a.exr"


@pytest.mark.parametrize("old, new, message", [
    (b"whiteLuminance\0float\0\4\0\0\0", b"whiteLuminance\0float\0\4\0\0\x66", "header: an attribute ends beyond the file"),
    (struct.pack("<4i", 0, 0, 2, 1), struct.pack("<4i", 0, 0, 9999999, 1), "header: more pixels than the file can hold")])
def test_a_small_file_that_asks_for_much(tmp_path, old, new, message):
    assert read_error(patched(tmp_path, old, new)).startswith("FILE: " + message + "; expected a complete OpenEXR image")


def test_too_large_a_window(tmp_path):
    path = patched(tmp_path, struct.pack("<4i", 0, 0, 2, 1), struct.pack("<4i", 0, 0, 99999, 99999))
    with path.open("ab") as file:
        file.write(bytes(100000))  # room for the table of offsets, without which it is a truncated file
    assert read_error(path) == "FILE: header: the data window is empty or too large; expected 1 to 100000000 pixels"


def test_other_channels(tmp_path):
    path = patched(tmp_path, b"Y\0" + struct.pack("<i", 2), b"Z\0" + struct.pack("<i", 2))
    assert read_error(path) == "FILE: header: no luminance; expected the channel Y, or R, G and B, at full resolution"


@pytest.mark.parametrize("unit", [2.5, 0.0, math.nan])
def test_white_luminance_is_the_unit(tmp_path, unit):
    name = b"whiteLuminance\0float\0" + struct.pack("<i", 4)
    path = patched(tmp_path, name + struct.pack("<f", 1), name + struct.pack("<f", unit))
    if unit == 2.5:
        _, arrays = read(path)
        assert arrays["Luminance"][:4] == pytest.approx(2.5 * VALUES[:4])
    else:
        assert read_error(path) == "FILE: header: whiteLuminance is not a number above 0; expected cd/m2"
