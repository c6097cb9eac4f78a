# SPDX-License-Identifier: BSD-3-Clause
"""Scenes under a sky: what is computed, written, and refused."""
import csv
import json
import math

import numpy as np
import pytest
from conftest import one_line

import kalos
from kalos.results.daylight import daylight_figures

PLANE = {"origin": [0, 0, 5], "u": [2, 0, 0], "v": [0, 2, 0], "resolution": [2, 2]}
SKY = {"cie": 5, "horizontal_illuminance": 10000, "sun": {"elevation_deg": 60, "azimuth_deg": 180, "normal_illuminance": 0}}


@pytest.fixture
def outdoors(scene):
    """A plane high above a floor and a wall."""
    scene["sky"], scene["north_deg"], scene["ground"] = dict(SKY), 0, {"reflectance": 0.3}
    del scene["luminaires"], scene["cameras"]
    scene["receivers"] = [{"name": "high", "plane": PLANE}]
    return scene


def solved(command, scene, out, *options):
    status, _, error = command("solve", scene.save(), "--out", out, "--trajectories", 1024, *options)
    assert status == 0, error
    return json.loads((out / "summary.json").read_text())


def rows(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def test_daylight_factors_are_100_where_nothing_hides_the_sky(outdoors, command, tmp_path):
    summary = solved(command, outdoors, tmp_path / "out", "--daylight-factor")
    for row in rows(tmp_path / "out" / "high.csv"):
        assert float(row["illuminance_lx"]) == pytest.approx(10000, rel=1e-6)
        assert float(row["daylight_factor_percent"]) == pytest.approx(100, rel=1e-6)
        assert float(row["standard_error_lx"]) < 1e-6
    assert list(rows(tmp_path / "out" / "high.csv")[0])[-1] == "daylight_factor_percent"
    found = summary["receivers"]["high"]["daylight"]
    assert found["median"] == pytest.approx(100, rel=1e-6)
    assert found["mean_direct"] == pytest.approx(100, rel=1e-6)
    assert found["en_17037"]["high"] == {"target": 1, "minimum_target": 1}


def test_figures_of_daylight_factors():
    factors = np.array([4.0, 3.0, 2.0, 1.0])
    found = daylight_figures(factors, 100 * factors, 25 * factors, np.ones(4))
    assert found["mean"] == 2.5
    assert (found["mean_direct"], found["mean_reflected"]) == (0.625, 1.875)
    assert (found["d_t"], found["d_tm"], found["median"]) == (3, 1, 3)
    assert found["en_17037"]["minimum"] == {"target": 0.5, "minimum_target": 1}
    assert found["en_17037"]["medium"] == {"target": 0, "minimum_target": 0.5}


@pytest.mark.parametrize("north, azimuth, normal, share", [
    (0, 180, (0, -1, 0), math.cos(math.radians(60))), (0, 90, (1, 0, 0), math.cos(math.radians(60))),
    (0, 0, (0, -1, 0), 0), (90, 0, (1, 0, 0), math.cos(math.radians(60))), (0, 180, (0, 0, 1), math.sin(math.radians(60)))])
def test_the_sun_stands_where_the_scene_says(outdoors, command, tmp_path, north, azimuth, normal, share):
    """Azimuth clockwise from north; north is +y, turned clockwise."""
    outdoors["north_deg"], outdoors["sky"]["horizontal_illuminance"] = north, 0
    outdoors["sky"]["sun"] = {"elevation_deg": 60, "azimuth_deg": azimuth, "normal_illuminance": 1000}
    outdoors["receivers"] = [{"name": "high", "points": "probe.csv"}]
    path = outdoors.save("x,y,z,nx,ny,nz\n5,-5,5,%g,%g,%g\n" % normal)
    status, _, error = command("solve", path, "--out", tmp_path / "out", "--trajectories", 256)
    assert status == 0, error
    assert float(rows(tmp_path / "out" / "high.csv")[0]["illuminance_lx"]) == pytest.approx(1000 * share, abs=1e-6)


def test_a_closed_room_is_told_to_be_dark(outdoors, command, tmp_path):
    outdoors["surfaces"] = [{"name": "room", "box": {"center": [1, 1, 5], "size": [3, 3, 3]}, "material": "grey"}]
    status, _, error = command("solve", outdoors.save(), "--out", tmp_path / "out", "--trajectories", 256)
    assert status == 0
    assert "no sky enters the room" in error
    assert float(rows(tmp_path / "out" / "high.csv")[0]["illuminance_lx"]) == 0


def through_a_hole(scene):
    """A room without its ceiling, and a plane low in it."""
    for name, origin, u, v in (("south", [0, 0, 0], [2, 0, 0], [0, 0, 3]), ("north", [0, 2, 0], [2, 0, 0], [0, 0, 3]),
                               ("west", [0, 0, 0], [0, 2, 0], [0, 0, 3]), ("east", [2, 0, 0], [0, 2, 0], [0, 0, 3])):
        scene["surfaces"].append({"name": name, "quad": {"origin": origin, "u": u, "v": v}, "material": "grey"})
    scene["receivers"][0]["plane"] = {**PLANE, "origin": [0, 0, 0.5]}
    return scene


def test_the_audit_names_sky_and_openings(outdoors, command, tmp_path):
    audit = {line["subject"]: line for line in solved(command, outdoors, tmp_path / "out")["audit"]}
    assert audit["sky"]["choice"] == "10000 lx on the horizontal"
    assert "955 cd/m2" in audit["sky"]["reason"]
    assert audit["openings"]["choice"] == "none needed"
    summary = solved(command, through_a_hole(outdoors), tmp_path / "inside")
    audit = {line["subject"]: line for line in summary["audit"]}
    assert audit["openings"]["choice"].startswith("1, ")
    assert "lets in 100 %" in audit["openings"]["reason"]


@pytest.mark.parametrize("change, message", [
    ({"cie": 17}, "sky.cie: found 17; expected a whole number from 1 to 16"),
    ({"perez": {"direct_normal_irradiance": 1, "diffuse_horizontal_irradiance": 1}},
     'sky: 2 of "cie", "perez" and "map" found; expected one of them'),
    ({"cie": ..., "perez": {"direct_normal_irradiance": -1, "diffuse_horizontal_irradiance": 1}},
     "sky.perez.direct_normal_irradiance: found -1; expected a number of at least 0.0"),
    ({"horizontal_illuminance": ...}, 'sky: no "horizontal_illuminance"; expected it, or "zenith_luminance"'),
    ({"zenith_luminance": 1}, 'sky: both "horizontal_illuminance" and "zenith_luminance"; expected one of them'),
    ({"cie": 12, "sun": ...}, 'sky: no "sun"; expected one, this sky is brightest about it'),
    ({"sun": {"elevation_deg": -5, "azimuth_deg": 0}},
     "sky.sun.elevation_deg: found -5; expected 0 to 90 degrees: the sun is below the horizon"),
    ({"sun": {"elevation_deg": 95, "azimuth_deg": 0}}, "sky.sun.elevation_deg: found 95; expected 0 to 90 degrees"),
    ({"cie": ..., "map": "nix.exr"}, "sky.map: no such file; expected a latitude-longitude picture, .exr or .hdr"),
    ({"cie": ..., "map": "probe.csv"},
     "sky.map: neither OpenEXR nor a Radiance picture; expected a latitude-longitude picture, .exr or .hdr")])
def test_bad_skies_are_refused(outdoors, command, tmp_path, change, message):
    outdoors["sky"].update(change)
    outdoors["sky"] = {key: value for key, value in outdoors["sky"].items() if value is not ...}
    path = outdoors.save()
    status, _, error = command("solve", path, "--out", tmp_path / "out")
    assert (status, one_line(error)) == (2, f"{path}: {message}")


def test_north_without_a_sky_is_refused(outdoors, command, tmp_path):
    del outdoors["sky"], outdoors["ground"]
    path = outdoors.save()
    status, _, error = command("solve", path, "--out", tmp_path / "out")
    assert (status, one_line(error)) == (2, f'{path}: north_deg: there is no "sky"; expected one with it')


def test_daylight_factors_need_a_sky(scene, command, tmp_path):
    path = scene.save()
    status, _, error = command("solve", path, "--out", tmp_path / "out", "--daylight-factor")
    assert (status, one_line(error)) == (2, f"{path}: sky: there is none, or it is dark; expected one that shines for daylight factors")


def test_a_map_is_a_sky(outdoors, command, tmp_path):
    """An image of an even sky of 1000 cd/m2, written by the writer of images."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    image = vtkImageData()
    image.SetDimensions(8, 4, 1)
    values = numpy_to_vtk(np.full(32, 1000.0), deep=True)
    values.SetName("Luminance")
    image.GetPointData().AddArray(values)
    writer = kalos.vtkKalosEXRWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(tmp_path / "even.exr"))
    writer.Write()
    outdoors["sky"] = {"map": "even.exr"}
    solved(command, outdoors, tmp_path / "out")
    assert float(rows(tmp_path / "out" / "high.csv")[0]["illuminance_lx"]) == pytest.approx(1000 * math.pi, rel=1e-6)


def test_scenes_in_memory_have_skies(tmp_path):
    scene = kalos.Scene()
    scene.add_material("grey", reflectance=0.5)
    scene.add("surfaces", "floor", quad={"origin": [0, 0, 0], "u": [2, 0, 0], "v": [0, 2, 0]}, material="grey")
    scene.add_plane("high", **PLANE)
    scene.set_sky(cie=16, horizontal_illuminance=8000, ground_reflectance=0.2, north_deg=30)
    scene.write(tmp_path / "scene.json")
    document = json.loads((tmp_path / "scene.json").read_text())
    assert document["sky"] == {"cie": 16, "horizontal_illuminance": 8000}
    assert (document["north_deg"], document["ground"]) == (30, {"reflectance": 0.2})
    assert kalos.Scene.read(tmp_path / "scene.json").sky == document["sky"]
    found = kalos.solve(scene, tmp_path / "out", trajectories=256, daylight_factor=True)
    assert found["receivers"]["high"]["daylight"]["mean"] == pytest.approx(100, rel=1e-6)


WINDOW = {"name": "pane", "quad": {"origin": [0, 0, 3], "u": [2, 0, 0], "v": [0, 2, 0]}, "material": "clear"}


def test_glass_dims_daylight(outdoors, command, tmp_path):
    """A pane over a plane that sees nothing else: the mean transmittance of a uniform sky."""
    outdoors["materials"]["clear"] = {"glass": {"transmittance": 0.78, "refractive_index": 1.52}}
    outdoors = through_a_hole(outdoors)
    outdoors["ground"] = {"reflectance": 0}
    outdoors["materials"]["grey"] = {"reflectance": 0}
    open_, glazed = tmp_path / "open", tmp_path / "glazed"
    solved(command, outdoors, open_)
    outdoors["surfaces"].append(WINDOW)
    solved(command, outdoors, glazed)
    for before, after in zip(rows(open_ / "high.csv"), rows(glazed / "high.csv")):
        ratio = float(after["illuminance_lx"]) / float(before["illuminance_lx"])
        assert 0.72 < ratio < 0.78  # below the normal one, as light comes aslant
    outdoors["surfaces"][-1] = {**WINDOW, "material": "opening"}
    solved(command, outdoors, glazed)
    for before, after in zip(rows(open_ / "high.csv"), rows(glazed / "high.csv")):
        assert float(after["illuminance_lx"]) == pytest.approx(float(before["illuminance_lx"]), rel=0.02)


@pytest.mark.parametrize("glass, message", [
    ({"transmittance": 1.2}, "the transmittance is out of range; expected above 0 and at most 1"),
    ({"transmittance": 0.95}, "the transmittance is 0.95, but the two sides of a refractive index of 1.52 reflect so much that 0.918347 is "
                              "the highest; expected no more"),
    ({"transmittance": 0.5, "refractive_index": 0.5}, "the refractive index is out of range; expected 1 to 4")])
def test_glass_that_cannot_be_is_refused(outdoors, command, tmp_path, glass, message):
    outdoors["materials"]["clear"] = {"glass": glass}
    path = outdoors.save()
    status, _, error = command("solve", path, "--out", tmp_path / "out")
    assert (status, one_line(error)) == (2, f"{path}: materials.clear.glass: {message}")
