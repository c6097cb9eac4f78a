# SPDX-License-Identifier: BSD-3-Clause
"""The zoo says what it should: its truths fit its rooms, sound errors pass, small ones are found out."""
import numpy as np
import pytest

import kalos  # noqa: F401  finds VTK
from catalogue import ROOMS
from closed import mirror_box
from kalos.scenes.reading import read_scene
from measure import Solves, judge, solve
from room import TRUTHS
from run import hard, verdict
from tracer_scene import LAMBERTIAN, lobe_albedo, read

BY_NAME = {room.name: room for room in ROOMS}
SLOW = ("mirrors-0.9",)  # its truth takes seconds
PLACES, SEEDS = 20, 6
PLAIN = Solves(np.ones((SEEDS, PLACES)), np.full((SEEDS, PLACES), 0.01), np.ones((SEEDS, PLACES), bool), 7, np.ones(SEEDS))


def test_every_room_has_a_name_and_a_truth():
    assert len(BY_NAME) == len(ROOMS) >= 40
    assert {path.stem for path in TRUTHS.glob("*.csv")} == {room.name for room in ROOMS if not room.exact}
    assert {room for room, _ in hard()} <= set(BY_NAME)


@pytest.mark.parametrize("name", sorted(set(BY_NAME) - set(SLOW)))
def test_room_and_truth_fit(name, tmp_path):
    room = BY_NAME[name]
    reader = read_scene(room.write(tmp_path))
    assert reader.GetReceivers().GetBlock(0).GetNumberOfPoints() == len(room.receivers)
    assert np.allclose(np.linalg.norm(room.receivers[:, 3:], axis=1), 1)
    truth, error = room.truth()
    assert (truth > 0).all() and (error >= 0).all()
    assert np.sqrt(np.mean((error / truth) ** 2)) < 0.03


def test_a_table_of_other_receivers_is_refused():
    room = BY_NAME["office"]
    with pytest.raises(ValueError, match="office: truths/office.csv is of other receivers, expected those of the room"):
        type(room)(**{**vars(room), "receivers": room.receivers + 0.01}).truth()


def test_images_of_one_reflection():
    """In two mirrors at x = 0 and 2 the first images stand at -x0 and 4 - x0."""
    receiver, share = np.array([[1.0, 1.0, 0.0, 0, 0, 1]]), 0.8
    found = mirror_box(4 * np.pi, (0.5, 1.0, 1.0), (2, 3, 4), (share, 0, 0), 1)(receiver)
    expected = sum(weight / (1 + (x - 1) ** 2) ** 1.5 for x, weight in ((0.5, 1), (-0.5, share), (3.5, share)))
    assert found == pytest.approx([expected], rel=1e-12)


def test_the_tracer_reads_boxes_outwards():
    """Emitting boxes, which are turned: the normals of all triangles point away from the middle, the areas add up."""
    scene = {"materials": {"glow": {"reflectance": 0.5, "exitance": 2.0}}, "luminaires": [],
             "surfaces": [{"name": "box", "box": {"center": [1, 2, 3], "size": [1, 2, 3], "rotation_z_deg": 30}, "material": "glow"}]}
    arrays = read(scene, {})
    middle = arrays.corner + (arrays.side_u + arrays.side_v) / 3
    assert (((middle - [1, 2, 3]) * arrays.normal).sum(axis=1) > 0.4).all()
    assert arrays.lamp_flux.sum() == pytest.approx(2 * 22) and (arrays.lamp_kind > LAMBERTIAN).all()


def test_albedo_of_smooth_lobes_is_fresnels():
    mu = np.linspace(0, 1, 129)[32:]
    assert lobe_albedo(0.04, 1e-3)[32:] == pytest.approx(0.04 + 0.96 * (1 - mu) ** 5, rel=1e-3)


def test_a_sound_method_passes(tmp_path):
    """Of 84 true intervals with shared trajectories less than 75 % hold once in many thousand times."""
    room = BY_NAME["pendant-30cm"]
    truth, noise = room.truth()
    found = judge(room.name, "compensated", solve(room, tmp_path, "compensated", SEEDS, 1024), truth, noise)
    assert found.holds > 0.75 and not found.sure_below
    assert abs(found.mean_off) < 0.02 and found.rms < 0.05 and found.seconds > 0


def test_small_errors_are_found_out():
    """Of errors that are a third of what they should be, half of the intervals hold."""
    noise = np.random.default_rng(1).normal(size=(SEEDS, PLACES))
    honest = judge("room", "method", Solves(1 + 0.01 * noise, PLAIN.errors, PLAIN.trusted, 7, PLAIN.seconds), np.ones(PLACES), 0)
    bold = judge("room", "method", Solves(1 + 0.03 * noise, PLAIN.errors, PLAIN.trusted, 7, PLAIN.seconds), np.ones(PLACES), 0)
    assert honest.holds > 0.93 and not honest.sure_below
    assert bold.holds < 0.7 and bold.sure_below
    assert verdict([honest, bold], set()) == ["room, method: unflagged intervals hold in "
                                              f"{100 * bold.unflagged_holds:.0f} %, expected 90 or a line in hard.txt"]
    assert verdict([bold], {("room", "method")}) == []
    assert verdict([honest], {("room", "method")}) == ["room, method: stands in hard.txt, but its intervals hold; expected no such line"]


def test_flagged_values_are_told_apart():
    values, trusted = PLAIN.values.copy(), PLAIN.trusted.copy()
    values[:, 0] = 2.0  # far off, and flagged: deserved
    trusted[:, :2] = False  # the second is right: not deserved
    found = judge("room", "method", Solves(values, PLAIN.errors, trusted, 7, PLAIN.seconds), np.ones(PLACES), 0)
    assert (found.holds, found.unflagged_holds, found.flagged_holds) == (0.95, 1.0, 0.5)
    assert (found.flagged, found.deserved, found.mean_off) == (0.1, 0.5, pytest.approx(0.05))
    assert found.largest == pytest.approx(100, rel=1e-3) and not found.sure_below
