# SPDX-License-Identifier: BSD-3-Clause
"""vtkKalosPhotometryReader: what it says of a file, its outputs, its samples, and photometric files in scenes."""
import json
from pathlib import Path

import numpy as np
import pytest
from files import bilinear, codes, read, write_ies, write_ldt
from kalos.errors import KalosError, update
from kalos.photometry import draw_photometry
from kalos.vtk import vtkKalosSceneReader
from matplotlib.image import imread
from vtkmodules.util.numpy_support import vtk_to_numpy

ROOT = Path(__file__).resolve().parents[2]
PLANES = (0, 20, 50, 90, 135, 180, 222.5, 300, 360)
ANGLES = (0, 3.5, 10, 30, 47, 60, 75, 90, 110, 160, 180)


def uneven(plane, angle):
    """Without symmetry, and with the same value in planes 0 and 360."""
    return 300 + 100 * np.sin(np.radians(plane)) + 50 * np.cos(3 * np.radians(angle)) + angle * (plane % 360) / 300


def test_intensity_is_that_of_the_file(tmp_path):
    """Anywhere, to 1e-6 of a direct reading of the file's numbers."""
    generator = np.random.default_rng(1)
    tables = {"a.ies": write_ies(tmp_path / "a.ies", uneven, PLANES, ANGLES),
              "b.ldt": write_ldt(tmp_path / "b.ldt", uneven, PLANES[:-1], ANGLES)}
    for name, path in tables.items():
        reader = read(path)
        candela = np.array([[uneven(p, a) for a in ANGLES] for p in PLANES])
        candela[-1] = candela[0]
        for c, gamma in zip(generator.uniform(0, 360, 2000), generator.uniform(0, 180, 2000)):
            direct = bilinear(PLANES, ANGLES, candela, c, gamma)
            assert reader.GetIntensity(c, gamma) == pytest.approx(direct, rel=1e-6), name
            assert reader.GetIntensity(c - 360, gamma) == pytest.approx(direct, rel=1e-6)


def test_flux_by_sampling(tmp_path):
    """Means over the samples are those over the flux: E[f] = integral of f I / flux, f from -1 to 1.

    Three f at 4.5 standard errors: false alarm 2e-5. The integral is a fine midpoint sum."""
    reader = read(write_ies(tmp_path / "a.ies", uneven, PLANES, ANGLES))
    assert codes(reader) == []
    c, gamma = (np.arange(720) + 0.5) / 2, (np.arange(360) + 0.5) / 2
    cd = np.array([[reader.GetIntensity(x, y) for y in gamma] for x in c])
    weight = cd * np.sin(np.radians(gamma)) * np.radians(0.5) ** 2
    assert weight.sum() == pytest.approx(reader.GetTableFlux(), rel=1e-4)
    drawn, pair = [], [0.0, 0.0]
    for u in np.random.default_rng(2).random((100000, 2)):
        reader.SampleDirection(*u, pair)
        drawn.append(tuple(pair))
    drawn = np.radians(drawn)
    for f in (lambda x, y: np.cos(y), lambda x, y: np.sin(y) * np.cos(x), lambda x, y: np.sin(y) * np.sin(x)):
        truth = (weight * f(*np.meshgrid(np.radians(c), np.radians(gamma), indexing="ij"))).sum() / weight.sum()
        values = f(drawn[:, 0], drawn[:, 1])
        error = values.std(ddof=1) / np.sqrt(len(values))
        assert abs(values.mean() - truth) < 4.5 * error + 1e-4 and error < 0.005


def test_header(tmp_path):
    reader = read(write_ies(tmp_path / "a.ies", lambda p, a: 100, opening=(0.3, 1.2, 0.05), lumens=900))
    assert (reader.GetFormat(), reader.GetLuminaireName()) == ("IES LM-63-2002", "Test lamp")
    assert reader.GetTableFlux() == pytest.approx(200 * np.pi, rel=1e-12)
    assert (reader.GetLampFlux(), reader.GetLargestIntensity(), reader.GetNumberOfLampSets()) == (900, 100, 1)
    assert (reader.GetOpeningAlongC0(), reader.GetOpeningAlongC90(), reader.GetOpeningHeight()) == (1.2, 0.3, 0.05)
    assert not reader.GetOpeningIsRound()
    reader = read(write_ies(tmp_path / "b.ies", lambda p, a: 100, opening=(-0.3, 0, 0), lumens=100))
    assert reader.GetOpeningIsRound() and codes(reader) == ["ies-flux"]
    assert reader.GetWarning(0).startswith("line 8: lumens per lamp: the intensities make 628 lm, more than")


def test_outputs(tmp_path):
    reader = read(write_ies(tmp_path / "a.ies", lambda p, a: 200 - a, (0,), (0, 45, 90), (-0.4, 0, 0)),
                  Position=(1, 2, 3), Aim=(0, 0, -2), Name="lamp")
    solid, table, curves, luminaire = (reader.GetOutputDataObject(i) for i in range(4))
    points, cd = vtk_to_numpy(solid.GetPoints().GetData()), vtk_to_numpy(solid.GetPointData().GetArray("Intensity"))
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), cd / 200, atol=1e-6)
    assert points[:, 2].min() == pytest.approx(-1) and cd[0] == 200
    assert [table.GetColumnName(i) for i in range(3)] == ["Angle", "C 0", "C 360"]
    assert vtk_to_numpy(table.GetColumn(1)).tolist() == [200, 155, 110]
    assert curves.GetNumberOfLines() == 2 and curves.GetPointData().GetArray("Intensity").GetRange() == (0, 200)
    data = luminaire.GetPointData()
    assert luminaire.GetPoint(0) == (1, 2, 3) and data.GetArray("Distribution").GetValue(0) == 2
    side = 0.4 * np.sqrt(np.pi) / 2  # the square of the circle's area
    np.testing.assert_allclose(data.GetArray("SideU").GetTuple(0), (side, 0, 0), atol=1e-12)
    np.testing.assert_allclose(data.GetArray("SideV").GetTuple(0), (0, side, 0), atol=1e-12)
    assert data.GetArray("LuminousFlux").GetValue(0) == reader.GetTableFlux()
    assert luminaire.GetFieldData().GetArray("CandelaTable0").GetNumberOfTuples() == 6


def test_properties(tmp_path):
    path = write_ies(tmp_path / "a.ies", lambda p, a: 100)
    flux = read(path, Flux=50.0).GetOutputDataObject(3).GetPointData().GetArray("LuminousFlux").GetValue(0)
    assert flux == 50
    with pytest.raises(KalosError, match=r"a\.ies: .*the aim is zero or not finite; expected a direction"):
        read(path, Aim=(0, 0, 0))
    with pytest.raises(KalosError, match="photometry: FileName: not set; expected the path"):
        read("")
    with pytest.raises(KalosError, match=r"none\.ies: line 1: file: no such file, or not readable; expected a photometric"):
        read(tmp_path / "none.ies")
    with pytest.raises(KalosError, match="there are 1, but set 2 is asked for; expected one of them"):
        read(write_ldt(tmp_path / "a.ldt", lambda p, a: 100), LampSet=2)
    assert read(path).CanReadFile(str(path)) and not read(path).CanReadFile(__file__)


def test_tilt_follows_the_aim(tmp_path):
    path = write_ies(tmp_path / "a.ies", lambda p, a: 100)
    path.write_text(path.read_text().replace("TILT=NONE", "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.8 0.5"))
    flux = 200 * np.pi
    for aim, factor in (((0, 0, -1), 1), ((1, 0, -1), 0.8), ((0, 1, 0), 0.5)):
        lumens = read(path, Aim=aim).GetOutputDataObject(3).GetPointData().GetArray("LuminousFlux").GetValue(0)
        assert lumens == pytest.approx(factor * flux)
    path.write_text(path.read_text().replace("INCLUDE\n1\n3\n0 45 90\n1 0.8 0.5", "lamp.tlt"))
    with pytest.raises(KalosError, match="line 3: TILT: there is no file of that name beside this one; expected NONE"):
        read(path)
    (tmp_path / "lamp.tlt").write_text("1\n2\n0 90\n1 0.5\n")
    assert read(path).GetTableFlux() == pytest.approx(flux)
    (tmp_path / "lamp.tlt").write_text("1\n2\n90 0\n1 0.5\n")
    with pytest.raises(KalosError, match="TILT: the tilt file is damaged, line 3: tilt angle: found 0 after 90"):
        read(path)


def scene(**luminaire):
    return {"kalos": 1, "luminaires": [{"name": "lamp", "position": [0, 0, 3], "aim": [0, 0, -1], **luminaire}],
            "receivers": [{"name": "desk", "plane": {"origin": [-1, -1, 0], "u": [2, 0, 0], "v": [0, 2, 0], "resolution": [2, 2]}}]}


def read_scene(folder, *luminaires):
    description = scene()
    description["luminaires"] = [{**description["luminaires"][0], "name": f"lamp {i}", **one} for i, one in enumerate(luminaires)]
    (folder / "scene.json").write_text(json.dumps(description))
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(folder / "scene.json"))
    update(reader)
    return reader.GetLuminaires()


def test_luminaires_share_tables(tmp_path):
    write_ies(tmp_path / "a.ies", lambda p, a: 100)
    write_ies(tmp_path / "b.ies", lambda p, a: 100 - a, lumens=1)
    found = read_scene(tmp_path, {"file": "a.ies"}, {"file": "b.ies"}, {"file": "a.ies", "flux": 70, "rotation_deg": 90},
                       {"flux": 5, "distribution": "isotropic"}, {"file": "b.ies"})
    data, fields = found.GetPointData(), found.GetFieldData()
    assert vtk_to_numpy(data.GetArray("Distribution")).tolist() == [2, 3, 2, 0, 3]
    assert fields.HasArray("CandelaTable1") and not fields.HasArray("CandelaTable2")
    assert data.GetArray("LuminousFlux").GetValue(2) == 70
    np.testing.assert_allclose(data.GetArray("Up").GetTuple(2), (-1, 0, 0), atol=1e-12)
    warnings = fields.GetAbstractArray("PhotometryWarnings")
    assert warnings.GetNumberOfTuples() == 1  # told once
    assert warnings.GetValue(0) == "ies-flux" and warnings.GetValue(1).endswith("b.ies")
    assert warnings.GetValue(2).startswith("line 8: lumens per lamp: ")


@pytest.mark.parametrize("change, message", [
    ({"file": "none.ies"}, r"none\.ies: line 1: file: no such file, or not readable; expected a photometric file"),
    ({"file": 3}, r"luminaires\.lamp 0\.file: found 3; expected a string"),
    ({"file": "a.ies", "distribution": "isotropic"}, "unknown key \"distribution\"; expected name, position, aim, rotation_deg"),
    ({"file": "a.ies", "flux": 0}, "flux: found 0; expected a number above 0"),
    ({"file": "a.ies", "lamp_set": 0}, "lamp_set: found 0; expected a whole number from 1 to 20"),
    ({"file": "a.ies", "lamp_set": 1, "aim": [0, 0, 0]}, "aim: found .* expected a direction, not zero"),
])
def test_mistakes_in_scenes(tmp_path, change, message):
    write_ies(tmp_path / "a.ies", lambda p, a: 100)
    with pytest.raises(KalosError, match=message):
        read_scene(tmp_path, change)


def test_data_files_have_their_analytic_flux():
    """data/photometry/make.py states them; chords of the tables lie at most 4e-4 off."""
    for name, flux in {"downlight.ies": 2000 / 3, "panel.ies": 1100, "linear.ldt": 0.9 * 1100, "pendant.ldt": 1100}.items():
        reader = read(ROOT / "data" / "photometry" / name)
        assert codes(reader) == []
        assert reader.GetTableFlux() == pytest.approx(flux * np.pi, rel=4e-4), name


def test_pictures(tmp_path):
    """Polar curves and solid of a lamp that shines down only, and of one that shines both ways."""
    for name in ("panel.ies", "pendant.ldt"):
        draw_photometry(tmp_path / "picture.png", read(ROOT / "data" / "photometry" / name))
        picture = imread(tmp_path / "picture.png")
        assert picture.shape[:2] == (780, 1575)
        left, right = picture[150:, :780, :3], picture[150:, 790:, :3]
        blue = (np.abs(left - (0x0b / 255, 0x5d / 255, 0x8f / 255)) < 0.02).all(axis=2)
        assert blue.sum() > 500  # the curve of C 0 - 180
        assert (right.std(axis=2) > 0.1).mean() > 0.1  # the solid's colours
