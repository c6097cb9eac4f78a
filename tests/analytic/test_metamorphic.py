# SPDX-License-Identifier: BSD-3-Clause
"""Changes of a scene whose effect is known although the illuminance is not.

Two estimates with different seeds are independent; a sound one fails a test with probability 1e-4.
"""
import numpy as np
import pytest
from estimates import BOX, PROBES, agree, lamp, room, scene, solve


@pytest.fixture(scope="module")
def original(tmp_path_factory):
    return solve(tmp_path_factory.mktemp("original"), scene(room(), [lamp()]), seed=1)


def transformed(points=lambda p: p, vectors=lambda v: v, mirror=False, surfaces=None):
    """The room, its lamp and its probes, moved; a mirrored quad swaps its sides to keep its normal inwards."""
    moved = []
    for surface in surfaces or room():
        quad = surface["quad"]
        sides = [vectors(np.array(quad[side], float)).tolist() for side in ("u", "v")]
        sides = sides[::-1] if mirror else sides
        origin = points(np.array(quad["origin"], float)).tolist()
        moved.append({**surface, "quad": {"origin": origin, "u": sides[0], "v": sides[1]}})
    light = lamp()
    light["position"] = points(np.array(light["position"])).tolist()
    light["aim"] = vectors(np.array(light["aim"])).tolist()
    normals = np.array([vectors(n) / np.linalg.norm(vectors(n)) for n in PROBES[:, 3:]])
    probes = np.column_stack([[points(p) for p in PROBES[:, :3]], normals])
    return scene(moved, [light]), probes


def walls():
    """The room with its box as six quads too, so that everything can be moved at will."""
    angle = np.radians(BOX["rotation_z_deg"])
    u = np.array([np.cos(angle), np.sin(angle), 0])
    v = np.array([-np.sin(angle), np.cos(angle), 0])
    w = np.array([0, 0, 1.0])
    faces = []
    for name, a, b, c in (("x", u, v, w), ("y", v, w, u), ("z", w, u, v)):
        for side in (1, -1):
            first, second = (b, c) if side > 0 else (c, b)
            origin = np.array(BOX["center"]) + 0.75 * (side * a - first - second)
            quad = {"origin": origin.tolist(), "u": (1.5 * first).tolist(), "v": (1.5 * second).tolist()}
            faces.append({"name": f"box {name}{side}", "quad": quad, "material": "grey"})
    return room()[:-1] + faces


def rotation():
    """About an oblique axis by 40 degrees."""
    axis = np.array([1, 2, 3]) / np.sqrt(14)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(0.7) * cross + (1 - np.cos(0.7)) * cross @ cross


def test_box_as_six_quads(original, tmp_path):
    agree(solve(tmp_path, scene(walls(), [lamp()]), seed=2), original)


def test_rotate(original, tmp_path):
    turn = rotation()
    description, probes = transformed(lambda p: turn @ p, lambda v: turn @ v, surfaces=walls())
    agree(solve(tmp_path, description, probes, seed=3), original)


def test_mirror(original, tmp_path):
    def flip(x):
        return x * [-1, 1, 1]

    description, probes = transformed(flip, flip, mirror=True, surfaces=walls())
    agree(solve(tmp_path, description, probes, seed=4), original)


def test_a_kilometre_away(original, tmp_path):
    description, probes = transformed(lambda p: p + [1000.0, -700, 300], surfaces=walls())
    agree(solve(tmp_path, description, probes, seed=5), original)


@pytest.mark.parametrize("scale", [0.01, 100])
def test_scale(original, tmp_path, scale):
    description, probes = transformed(lambda p: scale * p, lambda v: scale * v, surfaces=walls())
    agree(original, solve(tmp_path, description, probes, seed=6), factor=scale**2)


def test_split_the_lamp(original, tmp_path):
    halves = [lamp(flux=4000, name="a"), lamp(flux=6000, name="b")]
    agree(solve(tmp_path, scene(room(), halves), seed=7), original)


def test_superpose(original, tmp_path):
    other = lamp(position=(1, 1, 3), aim=(0, 0, -1), flux=3000, distribution="isotropic", name="other")
    both = solve(tmp_path, scene(room(), [lamp(), other]), seed=8)
    alone = solve(tmp_path, scene(room(), [other]), seed=9)
    alone.illuminance = alone.illuminance + original.illuminance
    alone.standard_error = np.hypot(alone.standard_error, original.standard_error)
    agree(both, alone)


def test_tessellate_otherwise(original, tmp_path):
    """The floor as four quads of different sizes."""
    pieces = [([0, 0, 0], [2, 0, 0], [0, 3, 0]), ([2, 0, 0], [3, 0, 0], [0, 3, 0]), ([0, 3, 0], [2, 0, 0], [0, 2, 0]),
              ([2, 3, 0], [3, 0, 0], [0, 2, 0])]
    floor = [{"name": f"floor {i}", "quad": {"origin": o, "u": u, "v": v}, "material": "grey"}
             for i, (o, u, v) in enumerate(pieces)]
    agree(solve(tmp_path, scene(floor + room()[1:], [lamp()]), seed=10), original)


def test_reciprocity(tmp_path):
    """A Lambertian lamp at A gives B what the same lamp at B gives A, with all reflections."""
    a, b = np.array([1.0, 1.0, 1.0]), np.array([4.0, 3.5, 3.0])
    up, tilted = np.array([0, 0, 1.0]), np.array([-0.6, 0, 0.8])

    def at(source, aim, receiver, normal, seed):
        probes = np.concatenate([receiver, normal])[None]
        return solve(tmp_path, scene(room(), [lamp(source, aim)]), probes, trajectories=256000, seed=seed)

    agree(at(a, up, b, tilted, 11), at(b, tilted, a, up, 12))


def test_threads_do_not_change_a_bit(tmp_path):
    one, two = (solve(tmp_path, scene(room(), [lamp()]), trajectories=3200, threads=threads) for threads in (1, 2))
    np.testing.assert_array_equal(one.illuminance, two.illuminance)
    np.testing.assert_array_equal(one.standard_error, two.standard_error)


def test_a_small_rectangle_is_a_point(tmp_path):
    """100 lm from a point and from a square of 1 cm, 5 m away: the same lux within the noise and 1e-5 of size."""
    probes = np.array([(0.0, 0, 0, 0, 0, 1), (2.0, 1, 0, 0, 0, 1)])
    floor = [{"name": "floor", "quad": {"origin": [-5, -5, 0], "u": [10, 0, 0], "v": [0, 10, 0]}, "material": "grey"}]
    point = solve(tmp_path, scene(floor, [lamp((0, 0, 5), (0, 0, -1), 100)]), probes)
    panel = {"name": "panel", "rectangle": {"center": [0, 0, 5], "u": [0.01, 0, 0], "v": [0, 0.01, 0]}, "aim": [0, 0, -1],
             "flux": 100}
    square = solve(tmp_path, scene(floor, [panel]), probes)
    np.testing.assert_allclose(square.illuminance, point.illuminance, rtol=2e-5)
