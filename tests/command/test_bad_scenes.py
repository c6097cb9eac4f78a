# SPDX-License-Identifier: BSD-3-Clause
"""Every message about a bad scene: exit status 2, one line FILE: WHERE: what is wrong and what is expected, no output."""
import pytest
from conftest import PROBE, one_line

REFLECTANCE = "a number of at least 0 and below 1.0, or 1 to 256 such numbers, one a band"
SHAPE = "expected u and v that are neither zero nor parallel"
SIZES = "two whole numbers of at least 1, with a product of at most 100000000"

# What to change in the scene, to which value (... takes it away), and the message after the file's name.
BAD = [
    ("kalos", 2, "kalos: found 2; expected a whole number from 1 to 1"),
    ("kalos", ..., 'scene: the key "kalos" is missing'),
    ("extra", 1, 'scene: unknown key "extra"; expected kalos, materials, surfaces, luminaires, receivers, cameras, sky, '
     'north_deg, ground, maintenance_factor, $schema'),
    ("materials.grey.colour", 1, 'materials.grey: unknown key "colour"; expected reflectance, specular, roughness, mirror, '
                                 "exitance"),
    ("materials.grey.reflectance", 1, f"materials.grey.reflectance: found 1; expected {REFLECTANCE}"),
    ("materials.grey.reflectance", -0.1, f"materials.grey.reflectance: found -0.1; expected {REFLECTANCE}"),
    ("materials.grey.reflectance", "x", f'materials.grey.reflectance: found "x"; expected {REFLECTANCE}'),
    ("materials.grey.reflectance", ..., 'materials.grey: the key "reflectance" is missing'),
    ("materials.grey.exitance", -5, "materials.grey.exitance: found -5; expected a number of at least 0, or 1 to 256 such "
                                    "numbers, one a band"),
    ("surfaces.0.quad.u", [0, 0, 0], f"surfaces.floor.quad: no area; {SHAPE}"),
    ("surfaces.0.quad.u", [1, 0], "surfaces.floor.quad.u: found [1,0]; expected three numbers [x, y, z]"),
    ("surfaces.0.material", "nix", 'surfaces.floor.material: found "nix"; expected the name of one of "materials"'),
    ("surfaces.0", {"name": "f", "box": {"center": [0, 0, 0], "size": [1, 0, 1]}, "material": "grey"},
     "surfaces.f.box.size: found [1,0,1]; expected three lengths above 0 m"),
    ("surfaces.0", {"name": "f", "file": "probe.csv", "material": "grey"},
     "surfaces.f.file: unknown mesh format '.csv'; expected .obj, .ply, .stl, .off or .vtp"),
    ("surfaces.0", {"name": "f", "material": "grey"}, 'surfaces.f: 0 shapes; expected one of "quad", "box" and "file"'),
    ("luminaires.0.flux", -1, "luminaires.lamp.flux: found -1; expected a number of at least 0.0"),
    ("luminaires.0.aim", [0, 0, 0], "luminaires.lamp.aim: found [0,0,0]; expected a direction, not zero"),
    ("luminaires.0.distribution", "spot", 'luminaires.lamp.distribution: found "spot"; expected "isotropic" or "lambertian"'),
    ("receivers.0.plane.resolution", [0, 2], f"receivers.desk.plane.resolution: found [0,2]; expected {SIZES}"),
    ("receivers.0.plane.v", [1, 0, 0], "receivers.desk.plane: the calculation plane has no area; expected U and V that are "
                                       "neither zero nor parallel"),
    ("receivers.0.name", "a/b", 'receivers.a/b.name: found "a/b"; expected a name that can be a file name: 1 to 200 '
                                "characters, no slash, no dot at the start"),
    ("receivers.0.name", "wall", "receivers.wall: another receiver or camera has this name; expected a name of its own, as "
                                 "results are named after it"),
    ("receivers.0.name", "summary", "scene: a receiver set or camera is named summary; expected another name, as the results "
                                    "stand in summary.json"),
    ("receivers.1.surface", "nix", 'receivers.wall.surface: found "nix"; expected the name of one of "surfaces"'),
    ("receivers.1.edge_length", 0, "receivers.wall.edge_length: found 0; expected a number above 0.0"),
    ("cameras.0.fov_deg", 180, "cameras.front.fov_deg: found 180; expected an angle above 0 and below 180 degrees"),
    ("cameras.0.target", [1, -3, 1], "cameras.front.target: the target is the position; expected another point"),
    ("cameras.0.up", [0, 1, 0], 'cameras.front: "up" ([0, 0, 1] if absent) is parallel to the view; expected another '
                                "direction"),
    ("cameras.0.resolution", [0, 10], f"cameras.front.resolution: found [0,10]; expected {SIZES}"),
]

# What the receivers' file holds, and the message.
LINES = "expected the header x,y,z,nx,ny,nz and at least one line"
BAD_POINTS = [
    ("", f"file: no receivers; {LINES}"),
    ("x,y,z,nx,ny,nz\n", f"file: no receivers; {LINES}"),
    ("x,y,z\n1,2,3\n", "line 1: the header is not as it should be; expected x,y,z,nx,ny,nz"),
    (PROBE + "1,2,3,0,0,0\n", "line 4: the normal is zero; expected a direction"),
    (PROBE + "1,2,q,0,0,1\n", "line 4: not a receiver; expected six finite numbers x,y,z,nx,ny,nz"),
    (PROBE + "1,2,nan,0,0,1\n", "line 4: not a receiver; expected six finite numbers x,y,z,nx,ny,nz"),
]


def change(scene, path, value):
    *folders, last = (int(key) if key.isdigit() else key for key in path.split("."))
    for key in folders:
        scene = scene[key]
    if value is ...:
        del scene[last]
    else:
        scene[last] = value


def refuse(command, path, out, message):
    """The command refuses the scene with this message and leaves nothing behind."""
    before = sorted(out.parent.iterdir())
    status, _, error = command("solve", path, "--out", out, "--trajectories", 32)
    assert (status, one_line(error)) == (2, message)
    assert sorted(out.parent.iterdir()) == before


def test_the_scene_is_good_before_it_is_spoilt(scene, command, tmp_path):
    assert command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 32)[0] == 0


@pytest.mark.parametrize("where, value, message", BAD, ids=[f"{where}={value}" for where, value, _ in BAD])
def test_bad_scene(scene, command, tmp_path, where, value, message):
    change(scene, where, value)
    path = scene.save()
    refuse(command, path, tmp_path / "out", f"{path}: {message}")


@pytest.mark.parametrize("text, message", BAD_POINTS)
def test_bad_points(scene, command, tmp_path, text, message):
    refuse(command, scene.save(probe=text), tmp_path / "out", f"{tmp_path / 'probe.csv'}: {message}")


@pytest.mark.parametrize("text, message", [
    ("", "line 1, column 1: malformed JSON"), ("{", "line 1, column 2: malformed JSON"),
    ('{"kalos": NaN}', "line 1, column 11: malformed JSON"), ('{"kalos": 1, "kalos": 1}', "kalos: this key appears twice"),
    ("[]", "scene: found []; expected an object with the keys")])
def test_bad_json(command, tmp_path, text, message):
    path = tmp_path / "scene.json"
    path.write_text(text)
    status, _, error = command("solve", path, "--out", tmp_path / "out")
    assert status == 2 and one_line(error).startswith(f"{path}: {message}")


def test_missing_files(scene, command, tmp_path):
    refuse(command, tmp_path / "no.json", tmp_path / "out", f"{tmp_path}/no.json: file: no such file; expected a scene file")
    scene["surfaces"][0] = {"name": "f", "file": "no.obj", "material": "grey"}
    path = scene.save()
    refuse(command, path, tmp_path / "out", f"{path}: surfaces.f.file: no file {tmp_path}/no.obj; expected a mesh file, its "
                                            "path relative to the scene file")
    scene["surfaces"][0]["file"] = "empty.obj"
    (tmp_path / "empty.obj").write_text("")
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out")
    assert status == 2 and "empty.obj" in one_line(error)


def test_nothing_to_solve(scene, command, tmp_path):
    del scene["receivers"], scene["cameras"]
    path = scene.save()
    refuse(command, path, tmp_path / "out", f"{path}: scene: nothing to compute: no receivers and no cameras; expected at "
                                            "least one of them")


def test_binary_file(command, tmp_path):
    path = tmp_path / "scene.json"
    path.write_bytes(b"\xff\xfe\x00\x01")
    status, _, error = command("solve", path, "--out", tmp_path / "out")
    assert status == 2
    one_line(error)
