# SPDX-License-Identifier: BSD-3-Clause
"""Lights and cameras of glTF models."""
import numpy as np
import pytest
from gltf import floor
from models import direct, error_of, notes, read


def test_a_point_in_candela_above_a_floor(tmp_path):
    """E = I cos / d^2, below a parent that moves and turns."""
    gltf = floor(10)
    lamp = gltf.light(type="point", intensity=900, name="lamp")
    gltf["scenes"][0]["nodes"].remove(lamp)
    gltf["nodes"][lamp]["translation"] = [0, 0, 1]
    gltf.node(children=[lamp], translation=[0, 3, 0], scale=[2, 2, 2], rotation=[0, 1, 0, 0])  # z to -z: at (0, 3, -2)
    where = np.array([(0, 2, 0), (0, 0, 0), (3, -2, 0)], float)
    distance = np.linalg.norm(where - (0, 2, 3), axis=1)
    np.testing.assert_allclose(direct(gltf.save(tmp_path), where, (0, 0, 1)), 900 * 3 / distance**3, rtol=1e-9)


def test_a_spot(tmp_path):
    """Full within the inner cone, the square of a linear fall in cos, dark outside; its flux in closed form."""
    inner, outer = 0.3, 0.6
    gltf = floor(10)
    spot = {"innerConeAngle": inner, "outerConeAngle": outer}
    down = {"translation": [0, 2, 0], "rotation": [-np.sqrt(0.5), 0, 0, np.sqrt(0.5)]}  # -z to -y
    gltf.light(down, type="spot", intensity=500, spot=spot)
    path = gltf.save(tmp_path)
    angles = np.array([0, 0.25, 0.35, 0.45, 0.55, 0.65])
    where = np.stack([2 * np.tan(angles), 0 * angles, 0 * angles], axis=1)
    share = np.clip((np.cos(angles) - np.cos(outer)) / (np.cos(inner) - np.cos(outer)), 0, 1) ** 2
    expected = 500 * share * np.cos(angles) ** 3 / 4
    np.testing.assert_allclose(direct(path, where, (0, 0, 1)), expected, atol=1e-4 * 500 / 4)
    reader = read(path)
    flux = reader.GetLuminaires().GetPointData().GetArray("LuminousFlux").GetTuple1(0)
    closed = 2 * np.pi * 500 * (1 - np.cos(inner) + (np.cos(inner) - np.cos(outer)) / 3)
    assert flux == pytest.approx(closed, rel=1e-4)
    assert "spot lights" in notes(reader)


def test_parallel_light_in_lux(tmp_path):
    """E times the cosine anywhere in the scene, within 0.2 %, and the whole of the surfaces is reached."""
    gltf = floor(10)
    tilt = 0.5  # from straight down
    gltf.light({"rotation": [-np.sin(np.pi / 4 - tilt / 2), 0, 0, np.cos(np.pi / 4 - tilt / 2)]}, type="directional", intensity=20000)
    path = gltf.save(tmp_path)
    where = np.array([(0, 0, 0), (4.9, 4.9, 0), (-4.9, 4.9, 0), (4.9, -4.9, 0)], float)
    np.testing.assert_allclose(direct(path, where, (0, 0, 1)), 20000 * np.cos(tilt), rtol=2e-3)
    toward = (0, -np.sin(tilt), np.cos(tilt))
    assert direct(path, where[:1], toward)[0] == pytest.approx(20000, rel=2e-5)
    assert "directional lights" in notes(read(path))


def test_colour_and_range_of_lights_are_said(tmp_path):
    gltf = floor()
    gltf.light({"translation": [0, 2, 0]}, type="point", intensity=100, color=[1, 0.5, 0], range=3)
    reader = read(gltf.save(tmp_path))
    flux = reader.GetLuminaires().GetPointData().GetArray("LuminousFlux").GetTuple1(0)
    assert flux == pytest.approx(4 * np.pi * 100 * (0.2126 + 0.5 * 0.7152))
    assert notes(reader)["coloured lights"] == "white" and notes(reader)["ranges of lights"] == "without end"


def test_cameras(tmp_path):
    gltf = floor()
    lens = {"yfov": np.pi / 3, "aspectRatio": 2.0, "znear": 0.1}
    gltf.node(name="view/1", camera=gltf.add("cameras", type="perspective", perspective=lens), translation=[1, 2, 3])
    gltf.node(name="plan", camera=gltf.add("cameras", type="orthographic", orthographic={}))
    reader = read(gltf.save(tmp_path))
    position, target, up, resolution = [0] * 3, [0] * 3, [0] * 3, [0] * 2
    reader.GetCameraPosition(0, position)
    reader.GetCameraTarget(0, target)
    reader.GetCameraUp(0, up)
    reader.GetCameraResolution(0, resolution)
    assert reader.GetNumberOfCameras() == 1 and reader.GetCameraName(0) == "view-1"
    np.testing.assert_allclose([position, target, up], [(1, -3, 2), (1, -2, 2), (0, 0, 1)], atol=1e-12)
    assert reader.GetCameraFieldOfView(0) == pytest.approx(60) and resolution == [512, 256]


def with_light(**light):
    def make():
        gltf = floor()
        gltf.light(**light)
        return gltf
    return make


@pytest.mark.parametrize("make, message", [
    (with_light(type="point", intensity=-1), "lights[0].intensity: found -1; expected a number of at least 0"),
    (with_light(type="laser"), 'lights[0].type: found "laser"; expected "point", "spot" or "directional"'),
    (with_light(type="point", color=[1, 1]), "lights[0].color: found [1,1]; expected three numbers"),
    (with_light(type="spot", spot={"outerConeAngle": 2}), "lights[0].spot.outerConeAngle: found 2; expected an angle above 0"),
    (with_light(type="spot", spot={"innerConeAngle": 0.6, "outerConeAngle": 0.5}), "lights[0].spot.innerConeAngle: found 0.6"),
    (with_light(node={"scale": [0, 0, 0]}, type="point"), "nodes[1]: a light or camera whose transform leaves it no direction"),
])
def test_broken_lights(tmp_path, make, message):
    assert message in error_of(tmp_path / "model.gltf", make().text())
