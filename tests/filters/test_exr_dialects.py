# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR images of other programs: primaries other than Rec. 709, several parts, newer compressions.

Source of truth: the matrices of SMPTE RP 177 for the primaries, and the file layout of OpenEXR.
"""
import struct

import numpy as np
import pytest

from helpers import update_error
from kalos.vtk import vtkKalosEXRReader

REC709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
AP0 = (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, 0.32168, 0.33767)
P3 = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def header(channels, width, height, part=None, chromaticities=None, compression=0):
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iBxxxii", 2, 0, 1, 1) for name in sorted(channels)) + b"\0"
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    text = (attribute("channels", "chlist", listed) + attribute("compression", "compression", bytes([compression]))
            + attribute("dataWindow", "box2i", box) + attribute("displayWindow", "box2i", box)
            + attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
            + attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
            + attribute("screenWindowWidth", "float", struct.pack("<f", 1)))
    if chromaticities:
        text += attribute("chromaticities", "chromaticities", struct.pack("<8f", *chromaticities))
    if part:
        text += (attribute("name", "string", part.encode()) + attribute("type", "string", b"scanlineimage")
                 + attribute("chunkCount", "int", struct.pack("<i", height)))
    return text + b"\0"


def exr(*parts, width=2, height=1, **more):
    """An uncompressed image; parts are a dictionary each, channel to value, and one is an image of a single part."""
    several = len(parts) > 1
    start = struct.pack("<II", 20000630, 2 | (0x1000 if several else 0))
    start += b"".join(header(part, width, height, f"part{i}" if several else None, **more) for i, part in enumerate(parts))
    start += b"\0" if several else b""
    chunks = [(struct.pack("<i", i) if several else b"") + struct.pack("<ii", y, 4 * width * len(part))
              + b"".join(struct.pack(f"<{width}f", *[part[name]] * width) for name in sorted(part))
              for i, part in enumerate(parts) for y in range(height)]
    offsets = np.cumsum([len(start) + 8 * len(chunks)] + [len(chunk) for chunk in chunks])[:-1]
    return start + struct.pack(f"<{len(offsets)}Q", *offsets) + b"".join(chunks)


def read(path, content):
    path.write_bytes(content)
    reader = vtkKalosEXRReader()
    reader.SetFileName(str(path))
    return update_error(reader), reader.GetOutput().GetPointData()


def to_xyz(chromaticities):
    """Columns X, Y and Z of unit red, green and blue, by SMPTE RP 177."""
    xy = np.reshape(chromaticities, (4, 2))
    columns = np.column_stack([xy, 1 - xy.sum(axis=1)]).T
    white = columns[:, 3] / xy[3, 1]
    return columns[:, :3] * np.linalg.solve(columns[:, :3], white)


@pytest.mark.parametrize("chromaticities", [None, REC709, AP0, P3])
def test_primaries(tmp_path, chromaticities):
    rgb = np.array([1.0, 2.0, 0.5])
    error, data = read(tmp_path / "a.exr", exr(dict(zip("RGB", rgb)), chromaticities=chromaticities))
    assert error is None
    xyz = to_xyz(chromaticities or REC709) @ rgb
    assert data.GetArray("Luminance").GetValue(0) == pytest.approx(xyz[1], rel=1e-4)
    expected = np.linalg.solve(to_xyz(REC709), xyz)
    np.testing.assert_allclose(data.GetArray("LuminanceBands").GetTuple(0), expected, rtol=1e-3, atol=1e-4)


def test_the_first_part_with_luminance(tmp_path):
    error, data = read(tmp_path / "a.exr", exr({"Z": 9.0}, {"R": 1.0, "G": 2.0, "B": 3.0}))
    assert error is None
    assert data.GetArray("LuminanceBands").GetTuple(0) == (1, 2, 3)


@pytest.mark.parametrize("content, message", [
    (lambda: exr({"R": 1.0}, {"G": 1.0}, {"B": 1.0}),
     "header: none of the 3 parts has a luminance by itself; expected a part with the channel Y, or R, G and B"),
    (lambda: exr({"Y": 1.0}, compression=10),
     "header: the compression of number 10 is newer than this OpenEXR; expected a file written with ZIP, PIZ"),
])
def test_files_that_can_not_be_read(tmp_path, content, message):
    error, _ = read(tmp_path / "a.exr", content())
    assert error.replace(f"{tmp_path}/a.exr: ", "").startswith(message)
