# SPDX-License-Identifier: BSD-3-Clause
"""Materials and textures of glTF models."""
import struct
import zlib

import numpy as np
import pytest
from gltf import SQUARE, TRIANGLES, Gltf, floor
from models import cells, notes, read


@pytest.mark.parametrize("material, expected", [
    (dict(color=(0.7, 0.7, 0.7)), dict(Reflectance=0.7, Specular=0, Mirror=0)),
    (dict(color=(0.7, 0.7, 0.7), roughness=0.25), dict(Reflectance=0.7, Specular=0.04, Roughness=0.25)),
    (dict(color=(0.6, 0.6, 0.6), metallic=1, roughness=0.3), dict(Reflectance=0, Specular=0.6, Roughness=0.3)),
    (dict(color=(0.6, 0.6, 0.6), metallic=0.5, roughness=0.3), dict(Reflectance=0.3, Specular=0.32)),
    (dict(color=(0.9, 0.9, 0.9), metallic=1, roughness=0), dict(Mirror=0.9, Specular=0)),
    (dict(), dict(Reflectance=0.95)),
    (dict(metallic=1, roughness=1), dict(Specular=0.95, Reflectance=0)),
    (dict(color=(0.5, 0.5, 0.5), emissiveFactor=[1, 1, 1]), dict(Exitance=np.pi)),
    (dict(color=(0.5, 0.5, 0.5), emissiveFactor=[0.5, 0.5, 0.5],
          extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 4000}}), dict(Exitance=2000 * np.pi))])
def test_neutral_materials(tmp_path, material, expected):
    gltf = Gltf()
    gltf.material(**material)
    gltf.node(mesh=gltf.mesh(SQUARE, TRIANGLES, material=0))
    reader = read(gltf.save(tmp_path))
    for name, value in expected.items():
        np.testing.assert_allclose(cells(reader, name), value, rtol=1e-12, err_msg=name)


def test_coloured_materials_have_three_bands(tmp_path):
    gltf = floor(color=(0.6, 0.2, 0.1), emissiveFactor=[1, 0.5, 0])
    gltf.material((0.8, 0.4, 0.2), metallic=1, roughness=0.4, name="copper")
    gltf.node(mesh=gltf.mesh(SQUARE, TRIANGLES, material=1))
    reader = read(gltf.save(tmp_path))
    np.testing.assert_allclose(cells(reader, "Reflectance")[0], (0.6, 0.2, 0.1))
    np.testing.assert_allclose(cells(reader, "Exitance")[0], np.pi * np.array((1, 0.5, 0)))
    assert cells(reader, "Specular")[2] == pytest.approx(0.2126 * 0.8 + 0.7152 * 0.4 + 0.0722 * 0.2)
    assert notes(reader)["coloured metals"] == "neutral" and "emissive materials" in notes(reader)


def png(pixels):
    """8-bit RGB rows as a PNG."""
    height, width, _ = np.shape(pixels)
    rows = b"".join(b"\0" + np.asarray(row, np.uint8).tobytes() for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def textured(image, **info):
    gltf = floor()
    gltf.add("images", **info)
    gltf.add("textures", source=0)
    gltf["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    if "uri" not in info:
        gltf["images"][0]["bufferView"] = gltf.add("bufferViews", buffer=0, byteOffset=len(gltf.bytes), byteLength=len(image))
        gltf.bytes += image
    return gltf


def test_a_texture_counts_by_its_mean_in_linear_light(tmp_path):
    image = png([[(255, 255, 255), (0, 0, 0)], [(188, 188, 188), (0, 0, 0)]])  # 188 is 0.5029 linear
    reader = read(textured(image, mimeType="image/png").save(tmp_path, "model.glb"))
    np.testing.assert_allclose(cells(reader, "Reflectance"), 0.5 * (1 + ((188 / 255 + 0.055) / 1.055) ** 2.4) / 4)
    assert notes(reader)["textures"] == "their mean colour"
    (tmp_path / "a b.png").write_bytes(image)
    beside = read(textured(image, uri="a%20b.png").save(tmp_path))
    assert cells(beside, "Reflectance").tolist() == cells(reader, "Reflectance").tolist()


def test_a_jpeg_texture(tmp_path):
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkJPEGWriter

    image = vtkImageData()
    image.SetDimensions(32, 16, 1)
    image.AllocateScalars(3, 3)  # VTK_UNSIGNED_CHAR
    image.GetPointData().GetScalars().Fill(188)
    writer = vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(tmp_path / "grey.jpg"))
    writer.Write()
    reader = read(textured(b"", uri="grey.jpg").save(tmp_path))
    np.testing.assert_allclose(cells(reader, "Reflectance"), 0.5 * 0.5029, rtol=2e-3)


@pytest.mark.parametrize("image", [b"", b"GIF89a..........", png([[(9, 9, 9)]])[:-20], b"\xff\xd8\xff\xe0garbage......"])
def test_a_texture_that_can_not_be_read_is_left_out_and_said(tmp_path, image):
    reader = read(textured(image or b"\0", mimeType="image/png").save(tmp_path))
    assert cells(reader, "Reflectance").tolist() == [0.5, 0.5]
    assert notes(reader)["textures that cannot be read"] == "left out"
