# SPDX-License-Identifier: BSD-3-Clause
"""Every mistake that a scene file can hold, and the line that names it."""
import pytest

from helpers import minimal_scene, update_error, write_scene
from kalos.vtk import vtkKalosSceneReader


def error_of(folder, scene):
    """The message after `FILE: `; the outputs must be empty."""
    reader = vtkKalosSceneReader()
    path = write_scene(folder, scene)
    reader.SetFileName(path)
    error = update_error(reader)
    assert error is not None, "no error"
    assert "\n" not in error
    assert reader.GetSurfaces().GetNumberOfCells() == 0
    assert reader.GetReceivers().GetNumberOfBlocks() == 0
    folder_text = str(folder) + "/"
    return error.replace(path + ": ", "", 1).replace(folder_text, "")


def changed(path, value):
    """The minimal scene with one member set, or removed (value `...`); `path` as in materials.white.reflectance."""
    scene = minimal_scene()
    at = scene
    *parents, last = path.split(".")
    for key in parents:
        at = at[int(key)] if isinstance(at, list) else at[key]
    if value is ...:
        del at[last]
    else:
        at[last] = value
    return scene


FRACTION = "expected a number of at least 0 and below 1"
BANDS = "expected a number of at least 0 and below 1.0, or 1 to 256 such numbers, one a band"
PIXELS = "expected two whole numbers of at least 1, with a product of at most 100000000"
SUM = "materials.white: reflectance + specular + mirror reach 1; expected a sum below 1"
S, L, R, C = "surfaces.0.", "luminaires.0.", "receivers.0.", "cameras.0."

CASES = [
    # The file as a whole
    ("kalos", ..., 'scene: the key "kalos" is missing'),
    ("kalos", 2, "kalos: found 2; expected a whole number from 1 to 1"),
    ("kalos", "1", 'kalos: found "1"; expected a whole number from 1 to 1'),
    ("lamps", [], 'scene: unknown key "lamps"; expected kalos, materials, surfaces, luminaires, receivers, cameras'),
    ("surfaces", {}, "surfaces: found {}; expected an array"),
    ("materials", [], "materials: found []; expected an object"),
    # Materials
    ("materials.white", 0.7, "materials.white: found 0.7; expected an object with the keys reflectance"),
    ("materials.white.reflectance", 1, "materials.white.reflectance: found 1; " + BANDS),
    ("materials.white.reflectance", -0.1, "materials.white.reflectance: found -0.1; " + BANDS),
    ("materials.white.reflectance", "0.7", 'materials.white.reflectance: found "0.7"; ' + BANDS),
    ("materials.white.reflectance", None, "materials.white.reflectance: found null; " + BANDS),
    ("materials.white.reflectance", [], "materials.white.reflectance: found []; " + BANDS),
    ("materials.white.reflectance", [0.5, 1.5, 0], "materials.white.reflectance: found [0.5,1.5,0]; " + BANDS),
    ("materials.white.reflectance", [0.5] * 257, "or 1 to 256 such numbers"),
    ("materials.white.reflectance", ..., 'materials.white: the key "reflectance" is missing'),
    ("materials.white.reflectence", 0.7, 'materials.white: unknown key "reflectence"; expected reflectance, specular'),
    ("materials.white.specular", 1, "materials.white.specular: found 1; " + FRACTION),
    ("materials.white.specular", 0.04, 'materials.white: "specular" without "roughness"; expected both'),
    ("materials.white.roughness", 0, "materials.white.roughness: found 0; expected a number above 0 and at most 1"),
    ("materials.white.mirror", -1, "materials.white.mirror: found -1; " + FRACTION),
    ("materials.white.mirror", 0.3, SUM),
    ("materials.white.exitance", -5, "materials.white.exitance: found -5; expected a number of at least 0, or"),
    # Surfaces
    (S + "name", ..., 'surfaces[0]: the key "name" is missing'),
    (S + "name", 7, "surfaces[0].name: found 7; expected a string"),
    (S + "name", "a/b", 'surfaces.a/b.name: found "a/b"; expected a name that can be a file name'),
    (S + "name", "", "expected a name that can be a file name"),
    (S + "colour", 1, 'surfaces.floor: unknown key "colour"; expected name, quad, box, file, material, scale, up'),
    (S + "material", "wite", 'surfaces.floor.material: found "wite"; expected the name of one of "materials"'),
    (S + "material", ..., 'surfaces.floor: the key "material" is missing'),
    (S + "quad", ..., 'surfaces.floor: 0 shapes; expected one of "quad", "box" and "file"'),
    (S + "file", "a.obj", 'surfaces.floor: 2 shapes; expected one of "quad", "box" and "file"'),
    (S + "quad.w", [0, 0, 1], 'surfaces.floor.quad: unknown key "w"; expected origin, u, v'),
    (S + "quad.u", [1, 2], "surfaces.floor.quad.u: found [1,2]; expected three numbers [x, y, z]"),
    (S + "quad.u", [1, 2, "3"], "expected three numbers [x, y, z]"),
    (S + "quad.v", [8, 0, 0], "surfaces.floor.quad: no area; expected u and v that are neither zero nor parallel"),
    (S + "quad.v", [0, 0, 0], "surfaces.floor.quad: no area; expected u and v that are neither zero nor parallel"),
    # Luminaires
    (L + "flux", -1, "luminaires.lamp.flux: found -1; expected a number of at least 0.0"),
    (L + "flux", [1], "luminaires.lamp.flux: found [1]; expected a number"),
    (L + "flux", ..., 'luminaires.lamp: the key "flux" is missing'),
    (L + "lumens", 1, 'luminaires.lamp: unknown key "lumens"; expected name, position, rectangle, aim, rotation_deg, flux'),
    (L + "aim", [0, 0, 0], "luminaires.lamp.aim: found [0,0,0]; expected a direction, not zero"),
    (L + "aim", ..., 'luminaires.lamp: the key "aim" is missing'),
    (L + "position", ..., 'luminaires.lamp: expected either "position" or "rectangle"'),
    (L + "rectangle", {}, 'luminaires.lamp: expected either "position" or "rectangle"'),
    (L + "distribution", "spot", 'luminaires.lamp.distribution: found "spot"; expected "isotropic" or "lambertian"'),
    (L + "file", "a.ies", 'luminaires.lamp: unknown key "distribution"; expected name, position, aim, rotation_deg, flux'),
    # Receivers
    (R + "plane", ..., 'receivers.desk: 0 kinds of receiver; expected one of "plane", "points", "surface" and "observer"'),
    (R + "points", "a.csv", 'receivers.desk: 2 kinds of receiver; expected one of "plane", "points", "surface" and "observer"'),
    (R + "plane.resolution", [0, 3], "receivers.desk.plane.resolution: found [0,3]; " + PIXELS),
    (R + "plane.resolution", [2.5, 3], "receivers.desk.plane.resolution: found [2.5,3]; " + PIXELS),
    (R + "plane.resolution", 3, "receivers.desk.plane.resolution: found 3; " + PIXELS),
    (R + "plane.resolution", [20000, 20000], PIXELS),
    (R + "plane.resolution", [1e300, 1e300], PIXELS),
    (R + "plane.v", [1, 0, 0], "receivers.desk.plane: the calculation plane has no area; expected U and V"),
    (R + "plane.flip", 1, "receivers.desk.plane.flip: found 1; expected true or false"),
    (R + "plane.n", 1, 'receivers.desk.plane: unknown key "n"; expected origin, u, v, resolution, spacing'),
    (R + "plane.spacing", "EN 12464-1", 'receivers.desk.plane.spacing: "resolution" is given as well; expected one of them'),
    (R + "plane", {"origin": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "spacing": "DIN"},
     'receivers.desk.plane.spacing: found "DIN"; expected "EN 12464-1"'),
    (R + "plane", {"origin": [0, 0, 0], "u": [1e6, 0, 0], "v": [0, 1e-3, 0], "spacing": "EN 12464-1"},
     "receivers.desk.plane: too long or too narrow for the grid of EN 12464-1; expected a"),
    (R + "height", 1, 'receivers.desk: unknown key "height"; expected name, plane, flip'),
    # Cameras
    (C + "fov_deg", 0, "cameras.front.fov_deg: found 0; expected an angle above 0 and below 180 degrees"),
    (C + "fov_deg", 180, "cameras.front.fov_deg: found 180; expected an angle above 0 and below 180 degrees"),
    (C + "target", [2, -4, 1], "cameras.front.target: the target is the position; expected another point"),
    (C + "up", [0, 6, 0], 'cameras.front: "up" ([0, 0, 1] if absent) is parallel to the view; expected another'),
    (C + "up", [0, 0, 0], "cameras.front.up: found [0,0,0]; expected a direction, not zero"),
    (C + "resolution", [16, 0], "cameras.front.resolution: found [16,0]; " + PIXELS),
    (C + "zoom", 2, 'cameras.front: unknown key "zoom"; expected name, position, target, up, fov_deg, resolution'),
    (C + "name", "desk", "cameras.desk: another receiver or camera has this name; expected a name of its own"),
]


@pytest.mark.parametrize("path, value, message", CASES)
def test_one_mistake(tmp_path, path, value, message):
    error = error_of(tmp_path, changed(path, value))
    assert message in error
    if message.split(" ")[0].endswith(":"):
        assert error.startswith(message)


@pytest.mark.parametrize("text, message", [
    ("", "line 1, column 1: malformed JSON: "),
    ('{\n  "kalos": 1,\n  "materials" {}\n}', "line 3, column 15: malformed JSON: "),
    ('{"kalos": NaN}', "line 1, column 11: malformed JSON: "),
    ('{"kalos": 1} {}', "malformed JSON: "),
    ('{"kalos": 1e999}', "scene: a number is too large: "),
    ('{"kalos": 1, "kalos": 1}', "kalos: this key appears twice; expected once"),
    ('{"kalos": 1, "materials": {"a": {"reflectance": 0}, "a": {}}}', "materials.a: this key appears twice"),
    ("[" * 100000, "nested deeper than 32 levels; expected a scene"),
    ('{"kalos":' * 50, "nested deeper than 32 levels; expected a scene"),
    ("[]", "scene: found []; expected an object with the keys kalos"),
    (b"\xff\xfe{", "malformed JSON: "),
    (b'{"kalos": 1, "surfaces": [{"name": "a\\nb"}]}', 'surfaces.a?b.name: found "a\\nb"; expected a name that can be'),
])
def test_malformed_json(tmp_path, text, message):
    assert message in error_of(tmp_path, text)


def test_missing_file():
    reader = vtkKalosSceneReader()
    assert update_error(reader) == "scene: FileName: not set; expected the path of a scene file"
    reader.SetFileName("/nowhere/scene.json")
    assert update_error(reader) == "/nowhere/scene.json: file: no such file; expected a scene file"


def test_file_too_large(tmp_path):
    path = tmp_path / "scene.json"
    with path.open("wb") as file:
        file.truncate((1 << 26) + 1)
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(path))
    assert update_error(reader) == f"{path}: file: larger than 64 MiB; expected a scene file"


def test_empty_scenes(tmp_path):
    scene = minimal_scene()
    scene["surfaces"] = scene["luminaires"] = []
    assert error_of(tmp_path, scene).startswith("scene: empty: no surfaces and no luminaires; expected")
    scene = minimal_scene()
    del scene["receivers"], scene["cameras"]
    assert error_of(tmp_path, scene).startswith("scene: nothing to compute: no receivers and no cameras; expected")


@pytest.mark.parametrize("section, message", [
    ("surfaces", "surfaces.floor: another surface has this name"),
    ("luminaires", "luminaires.lamp: another luminaire has this name"),
    ("receivers", "receivers.desk: another receiver or camera has this name"),
    ("cameras", "cameras.front: another receiver or camera has this name"),
])
def test_names_are_unique(tmp_path, section, message):
    scene = minimal_scene()
    scene[section] *= 2
    assert error_of(tmp_path, scene).startswith(message)


def test_bands_must_agree(tmp_path):
    scene = minimal_scene()
    scene["materials"] = {"white": {"reflectance": [0.1, 0.2]}, "red": {"reflectance": [0.1, 0.2, 0.3]}}
    scene["surfaces"].append(dict(scene["surfaces"][0], name="wall", material="red"))
    error = error_of(tmp_path, scene)
    assert error.startswith("surfaces.wall.material: 3 bands where an earlier material has 2; expected 1 or the same")


@pytest.mark.parametrize("box, message", [
    ({"center": [0, 0, 0], "size": [1, 0, 1]}, "surfaces.b.box.size: found [1,0,1]; expected three lengths above 0 m"),
    ({"center": [0, 0, 0]}, 'surfaces.b.box: the key "size" is missing'),
    ({"center": [0, 0, 0], "size": [1, 1, 1], "turn": 1}, 'surfaces.b.box: unknown key "turn"; expected center, size'),
    ({"center": [0, 0, 0], "size": [1, 1, 1], "rotation_z_deg": "1"}, "box.rotation_z_deg: found \"1\"; expected a number"),
])
def test_box_mistakes(tmp_path, box, message):
    scene = minimal_scene()
    scene["surfaces"] = [{"name": "b", "box": box, "material": "white"}]
    assert message in error_of(tmp_path, scene)


@pytest.mark.parametrize("change, message", [
    ({"rectangle": {"center": [0, 0, 3], "u": [1, 0, 0], "v": [2, 0, 0]}}, "luminaires.p: the luminous rectangle has no area"),
    ({"aim": [1, 0, 0]}, "luminaires.p: the aim is not perpendicular to the luminous rectangle"),
    ({"distribution": "isotropic"}, 'luminaires.p.distribution: found "isotropic"; expected "lambertian"'),
    ({"rectangle": {"center": [0, 0, 3]}}, 'luminaires.p.rectangle: the key "u" is missing'),
    ({"rectangle": {"width": 1}}, 'luminaires.p.rectangle: unknown key "width"; expected center, u, v'),
])
def test_rectangle_mistakes(tmp_path, change, message):
    scene = minimal_scene()
    panel = {"name": "p", "rectangle": {"center": [0, 0, 3], "u": [1, 0, 0], "v": [0, 1, 0]}, "aim": [0, 0, -1], "flux": 1}
    scene["luminaires"] = [dict(panel, **change)]
    assert error_of(tmp_path, scene).startswith(message)


@pytest.mark.parametrize("change, message", [
    ({"surface": "roof"}, 'receivers.w.surface: found "roof"; expected the name of one of "surfaces"'),
    ({"edge_length": 0}, "receivers.w.edge_length: found 0; expected a number above 0.0"),
    ({"edge_length": 1e-6}, "receivers.w.edge_length: found 1e-06; expected a longer edge: at most 5000000 receivers"),
    ({"edge_length": 1e-320}, "receivers.w.edge_length: found "),
    ({"flip": "yes"}, 'receivers.w.flip: found "yes"; expected true or false'),
    ({"step": 1}, 'receivers.w: unknown key "step"; expected name, surface, edge_length, flip'),
])
def test_surface_receiver_mistakes(tmp_path, change, message):
    scene = minimal_scene()
    scene["receivers"] = [dict({"name": "w", "surface": "floor", "edge_length": 1}, **change)]
    assert error_of(tmp_path, scene).startswith(message)


def test_too_many_receivers(tmp_path):
    scene = minimal_scene()
    plane = scene["receivers"][0]["plane"]
    scene["receivers"].append({"name": "second", "plane": dict(plane, resolution=[5000, 1000])})
    error = error_of(tmp_path, scene)
    assert error.startswith("receivers.second.plane: found {") and error.endswith(
        "; expected at most 4999988 receivers, as all sets of a scene together may have 5000000")


def test_flip_given_twice(tmp_path):
    scene = minimal_scene()
    scene["receivers"][0]["flip"] = scene["receivers"][0]["plane"]["flip"] = True
    assert error_of(tmp_path, scene) == 'receivers.desk.flip: "flip" is given twice; expected once'


@pytest.mark.parametrize("text, message", [
    (None, "receivers.p.points: no file p.csv; expected a CSV file, its path relative to the scene file"),
    ("", "p.csv: file: no receivers; expected the header x,y,z,nx,ny,nz and at least one line"),
    ("x,y,z\n1,2,3\n", "p.csv: line 1: the header is not as it should be; expected x,y,z,nx,ny,nz"),
    ("x,y,z,nx,ny,nz\n", "p.csv: file: no receivers; expected the header"),
    ("x,y,z,nx,ny,nz\n1,2,3,0,0,1\n1,2,3,0,0\n", "p.csv: line 3: not a receiver; expected six finite numbers"),
    ("x,y,z,nx,ny,nz\n1,2,3,0,0,1,4\n", "p.csv: line 2: not a receiver; expected six finite numbers"),
    ("x,y,z,nx,ny,nz\n1,2,nan,0,0,1\n", "p.csv: line 2: not a receiver; expected six finite numbers"),
    ("x,y,z,nx,ny,nz\n1,2,1e999,0,0,1\n", "p.csv: line 2: not a receiver; expected six finite numbers"),
    ("x,y,z,nx,ny,nz\n1;2;3;0;0;1\n", "p.csv: line 2: not a receiver; expected six finite numbers"),
    ("x,y,z,nx,ny,nz\n1,2,3,0,0,0\n", "p.csv: line 2: the normal is zero; expected a direction"),
    ("x,y,z,nx,ny,nz\n" + " " * 1025, "p.csv: line 2: longer than 1024 bytes; expected x,y,z,nx,ny,nz"),
    ("x,y,z,nx,ny,nz" * 9999, "p.csv: line 1: longer than 1024 bytes; expected"),
])
def test_probe_mistakes(tmp_path, text, message):
    scene = minimal_scene()
    scene["receivers"] = [{"name": "p", "points": "p.csv"}]
    if text is not None:
        (tmp_path / "p.csv").write_text(text)
    # Errors inside the CSV file name it as FILE.
    assert error_of(tmp_path, scene).startswith(message)
