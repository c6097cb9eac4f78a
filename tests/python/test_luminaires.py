# SPDX-License-Identifier: BSD-3-Clause
"""Luminaires of photometric files from Python: as a scene file has them, and in any order beside others."""
import itertools
import json
from pathlib import Path

import numpy as np
import pytest

import kalos
from kalos.estimation.filters import illuminance_filter
from kalos.core.options import Options
from kalos.results.receivers import from_dataset
from kalos.scenes.reading import read_scene

FILES = Path(__file__).resolve().parents[2] / "data" / "photometry"
PENDANT, SPOT = FILES / "pendant.ldt", FILES / "downlight.ies"
ROOM = kalos.box((2, 2, 1.5), (4, 4, 3), 0.0, inwards=True)  # black: all light is direct
DESK = np.array([[0.5, 0.7, 0.75], [2.0, 2.0, 0.75], [3.2, 1.1, 0.75]])

LAMPS = {
    "pendant": lambda: kalos.luminaire((1, 2, 2.5), file=PENDANT),
    "turned": lambda: kalos.luminaire((3, 2, 2.5), 2000, (0.3, 0, -1), file=str(PENDANT), rotation_deg=30),
    "spot": lambda: kalos.luminaire((2, 1, 2.9), file=SPOT),
    "lambertian": lambda: kalos.luminaire((2, 3, 2.9), 1000),
    "isotropic": lambda: kalos.luminaire((1, 1, 2), 500, distribution="isotropic"),
    "panel": lambda: kalos.panel((3, 3, 2.99), (0.6, 0, 0), (0, 0.6, 0), 1500),
}


def light(lamps):
    """Illuminance and its standard error; that of points is exact, of areas sampled."""
    found = kalos.illuminance(ROOM, lamps, DESK, (0, 0, 1), trajectories=8192, threads=1)
    return np.array([found.illuminance, found.standard_error])


def agree(one, several):
    """Whether one estimate is the sum of several, to 6 standard errors (false alarm below 1e-3 with 7 degrees of freedom)."""
    total, error = sum(each[0] for each in several), np.sqrt(one[1] ** 2 + sum(each[1] ** 2 for each in several))
    assert (error < 0.02 * total).all()
    np.testing.assert_array_less(np.abs(one[0] - total), 6 * error + 1e-9 * total)


@pytest.fixture(scope="module")
def alone():
    return {name: light(make()) for name, make in LAMPS.items()}


@pytest.mark.parametrize("names", [*itertools.permutations(["pendant", "spot", "lambertian"]), ("turned", "pendant"), tuple(LAMPS),
                                   tuple(reversed(LAMPS)), ("spot", "spot")], ids="-".join)
def test_light_adds_up_in_any_order(alone, names):
    agree(light([LAMPS[name]() for name in names]), [alone[name] for name in names])


def test_places_of_one_file():
    places = [(1, 2, 2.5), (3, 2, 2.5), (2, 3, 2.5)]
    together = kalos.luminaire(places, file=PENDANT)
    assert together.GetNumberOfPoints() == 3
    assert not together.GetFieldData().HasArray("CandelaTable1")  # one table serves all
    agree(light(together), [light(kalos.luminaire(place, file=PENDANT)) for place in places])
    agree(light(kalos.luminaire(places, [100, 200, 300], file=PENDANT)),
          [light(kalos.luminaire(place, flux, file=PENDANT)) for place, flux in zip(places, (100, 200, 300))])


def test_as_a_scene_file_has_it(tmp_path):
    entry = {"position": [3, 2, 2.5], "aim": [0.3, 0, -1], "flux": 2000, "file": str(PENDANT), "rotation_deg": 30}
    (tmp_path / "probe.csv").write_text("x,y,z,nx,ny,nz\n" + "".join(f"{x},{y},{z},0,0,1\n" for x, y, z in DESK))
    scene = {"kalos": 1, "materials": {"black": {"reflectance": 0}},
             "surfaces": [{"name": "room", "box": {"center": [2, 2, 1.5], "size": [4, 4, 3]}, "material": "black"}],
             "luminaires": [{"name": "lamp", **entry}], "receivers": [{"name": "probe", "points": "probe.csv"}]}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    filter_ = illuminance_filter(read_scene(tmp_path / "scene.json"), Options(trajectories=8192, threads=1))
    filter_.Update()
    found = from_dataset("probe", filter_.GetOutputDataObject(0).GetBlock(0))
    np.testing.assert_allclose(light(LAMPS["turned"]())[0], found.illuminance, rtol=1e-9)


@pytest.mark.parametrize("call, message", [
    (lambda: kalos.luminaire((0, 0, 1)), "flux: is missing, expected lumens, or a file that tells them"),
    (lambda: kalos.luminaire((0, 0, 1), file=FILES / "none.ies"), f"file: {FILES / 'none.ies'}: "),
    (lambda: kalos.luminaire((0, 0, 1), file=PENDANT, lamp_set=9), f"file: {PENDANT}: "),
    (lambda: kalos.luminaire((0, 0, 1), [1, 2], file=PENDANT), "flux: has shape (2,), expected one"),
    (lambda: kalos.luminaire((0, 0, 1), file=PENDANT, aim=(0, 0, 0)), "aim: has shape (3,) and is zero, expected a direction"),
    (lambda: kalos.luminaire((0, 0, 1), file=PENDANT, rotation_deg="x"), "rotation_deg: is not an array of numbers")])
def test_message(call, message):
    with pytest.raises(ValueError) as error:
        call()
    assert str(error.value).startswith(message)
