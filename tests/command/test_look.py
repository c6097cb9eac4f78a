# SPDX-License-Identifier: BSD-3-Clause
"""The look of pictures: variants compare on one scale, which may be logarithmic, in other colours and with isolines."""
import numpy as np
import pytest
from conftest import one_line
from matplotlib.colors import LogNorm, Normalize
from matplotlib.image import imread

from kalos.pictures.look import Look
from kalos.pictures.scale import colour_scale

VALUES = np.array([0.0, 1, 50, 90])


@pytest.fixture
def picture(scene, command, tmp_path):
    """The pixels of the desk's or the camera's picture at a flux, with options."""

    def draw(name, flux, *options):
        scene["luminaires"][0]["flux"] = flux
        status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, *options)
        assert status == 0, error
        return imread(tmp_path / "out" / f"{name}.png")[..., :3]

    return draw


def legend(pixels):
    return pixels[100:-100, -int(0.13 * pixels.shape[1]):]


@pytest.mark.parametrize("name, option", [("desk", "--range"), ("front", "--luminance-range")])
def test_variants_compare_on_one_scale(picture, name, option):
    free = [legend(picture(name, flux)) for flux in (1000, 3000)]
    fixed = [legend(picture(name, flux, option, "0:2000")) for flux in (1000, 3000)]
    assert free[0].shape != free[1].shape or not np.array_equal(*free)
    np.testing.assert_array_equal(*fixed)


@pytest.mark.parametrize("option", [("--log",), ("--colours", "gray"), ("--isolines",)])
def test_every_option_changes_the_picture(picture, option):
    for name in ("desk", "front"):
        plain, other = picture(name, 1000), picture(name, 1000, *option)
        assert plain.shape != other.shape or (np.abs(plain - other).max(axis=-1) > 0.1).mean() > 0.003


def test_grey_is_grey(picture):
    pixels = picture("front", 1000, "--colours", "gray")
    assert np.abs(pixels - pixels.mean(axis=-1, keepdims=True)).max() < 0.02


@pytest.mark.parametrize("ends, look, kind, expected, cut", [
    (None, Look(), Normalize, (0, 100), "neither"), (None, Look(log=True), LogNorm, (0.1, 100), "min"),
    ((0, 60), Look(), Normalize, (0, 60), "max"), ((1, 60), Look(), Normalize, (1, 60), "both"),
    ((1, 200), Look(log=True), LogNorm, (1, 200), "min"), ((0, 90), Look(), Normalize, (0, 90), "neither")])
def test_scales(ends, look, kind, expected, cut):
    scale = colour_scale(VALUES, ends, look)
    assert type(scale.norm) is kind and scale.cut == cut
    np.testing.assert_allclose((scale.norm.vmin, scale.norm.vmax), expected, rtol=1e-12)
    assert np.isfinite(scale.norm(VALUES)).all()


def test_looks_that_can_not_be(scene, command, tmp_path):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--log", "--range", "0:100")
    assert status == 2 and one_line(error) == "--range: starts at 0, expected more than 0 with --log"
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--colours", "mud")
    assert status == 2 and one_line(error) == ("--colours: 'mud' is not allowed, expected kalos or a colour map of Matplotlib, such as "
                                               "viridis")
    assert not (tmp_path / "out").exists()


def test_the_terminal_says_what_the_error_is(scene, command, tmp_path):
    _, out, _ = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 320)
    assert "± is one standard error" in out
