# SPDX-License-Identifier: BSD-3-Clause
"""data/models/classroom.glb, a model without a scene file: its lux in closed form, and against the same room in Kalos's own words."""
import importlib.util
import json

import numpy as np
import pytest
from files import write_ies

from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.results.receivers import from_dataset
from kalos.scenes.reading import read_scene
from kalos.solving.solve import solve
from kalos.validation.cases import DATA
from kalos.validation.verdicts import allowed_deviation

MODEL = DATA / "models" / "classroom.glb"
SPECIFICATION = importlib.util.spec_from_file_location("classroom", DATA / "models" / "make.py")
made = importlib.util.module_from_spec(SPECIFICATION)
SPECIFICATION.loader.exec_module(made)


def cone(angle):
    """Intensity of the spot, cd, at radians from its axis: glTF's own formula."""
    low, high = np.cos(made.SPOT["outer"]), np.cos(made.SPOT["inner"])
    return made.SPOT["candela"] * np.clip((np.cos(angle) - low) / (high - low), 0, 1) ** 2


def in_own_words(folder):
    """The room as a scene file: quads, boxes and luminaires, one by one."""
    angles = np.linspace(0, 40, 321)
    write_ies(folder / "spot.ies", lambda plane, angle: cone(np.radians(angle)), angles=angles)
    x, y, z = made.ROOM
    quads = {"floor": ([0, 0, 0], [x, 0, 0], [0, y, 0], "floor"), "ceiling": ([0, 0, z], [0, y, 0], [x, 0, 0], "ceiling"),
             "left": ([0, 0, 0], [0, y, 0], [0, 0, z], "wall"), "right": ([x, 0, 0], [0, 0, z], [0, y, 0], "wall"),
             "front": ([0, 0, 0], [0, 0, z], [x, 0, 0], "wall"), "back": ([0, y, 0], [x, 0, 0], [0, 0, z], "wall")}
    boxes = [("board", made.BOARD, (0, 0, 0), 0)]
    boxes += [("wood", part, at, 0) for at in made.DESKS for part in made.DESK]
    boxes += [("seat", part, at, turn) for *at, turn in made.STOOLS for part in made.STOOL]
    surfaces = [{"name": name, "quad": {"origin": o, "u": u, "v": v}, "material": m} for name, (o, u, v, m) in quads.items()]
    surfaces += [{"name": f"box {k}", "material": material,
                  "box": {"center": (np.array(center) + at).tolist(), "size": list(size), "rotation_z_deg": float(turn)}}
                 for k, (material, (center, size), at, turn) in enumerate(boxes)]
    lamps = [{"name": f"pendant {k}", "position": at, "aim": [0, 0, -1], "flux": 4 * np.pi * made.CANDELA, "distribution": "isotropic"}
             for k, at in enumerate(made.PENDANTS)]
    aim = np.subtract(made.SPOT["target"], made.SPOT["position"])
    lamps.append({"name": "spot", "position": made.SPOT["position"], "aim": aim.tolist(), "file": "spot.ies"})
    plane = {"origin": [0, 0, 0.75], "u": [x, 0, 0], "v": [0, y, 0], "spacing": "EN 12464-1"}
    scene = {"kalos": 1, "materials": {name: {"reflectance": value} for name, value in made.REFLECTANCE.items()},
             "surfaces": surfaces, "luminaires": lamps, "receivers": [{"name": "workplane", "plane": plane}]}
    path = folder / "classroom.json"
    path.write_text(json.dumps(scene))
    return path


def work_plane(path, seed):
    estimator = illuminance_filter(read_scene(path), Options(trajectories=16000, seed=seed))
    update(estimator)
    return from_dataset("workplane", estimator.GetOutputDataObject(0).GetBlock(0))


@pytest.fixture(scope="module")
def model():
    return work_plane(MODEL, 3)


def test_the_script_makes_the_file():
    assert made.classroom().binary() == MODEL.read_bytes()


def test_direct_light_in_closed_form(model):
    assert len(model.points) > 50 and (model.points[:, 2] == 0.75).all()
    expected = np.zeros(len(model.points))
    axis = np.subtract(made.SPOT["target"], made.SPOT["position"])
    for at in (*made.PENDANTS, made.SPOT["position"]):
        to = model.points - at
        d = np.linalg.norm(to, axis=1)
        off = np.arccos(to @ axis / (d * np.linalg.norm(axis)))
        candela = cone(off) if at is made.SPOT["position"] else made.CANDELA
        expected += candela * -to[:, 2] / d**3
    np.testing.assert_allclose(model.direct, expected, rtol=1e-3)  # chords of the cone's table


def test_all_light_is_that_of_the_same_room_in_own_words(model, tmp_path):
    """All values at once at a false alarm of 1e-4 (Student's t, Sidak), at standard errors of a few per cent."""
    own = work_plane(in_own_words(tmp_path), 4)
    np.testing.assert_allclose(model.points, own.points, atol=1e-9)
    error = np.hypot(model.standard_error, own.standard_error)
    off = np.abs(model.illuminance - own.illuminance)
    assert (off <= allowed_deviation(len(off)) * error + 1e-3 * own.direct).all()
    assert np.mean(error / own.illuminance) < 0.02
    assert (model.illuminance > 1.1 * model.direct).all()


def test_what_is_written_and_said(tmp_path):
    """The whole command, camera and all, at the least effort, which is not the default method's."""
    summary = solve(MODEL, tmp_path, Options(method="local", trajectories=32))
    assert {path.name for path in tmp_path.iterdir()} >= {"corner.exr", "corner.png", "workplane.csv", "workplane.png"}
    said = {line["subject"]: line["choice"] for line in summary["audit"]}
    assert said["axes"] == "turned from y up to z up" and "spot lights" in said
    assert said["point luminaires"] == "7, exact"
