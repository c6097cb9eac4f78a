# SPDX-License-Identifier: BSD-3-Clause
"""A solve that would not fit in memory is refused, with the required and the available bytes."""
import re
import resource
import time

import pytest
from conftest import launch, one_line


def refusal(scene, tmp_path, limit):
    """The message of a solve under `ulimit -v`, with its two figures in GB."""
    path = scene.save()
    started = time.monotonic()
    process = launch("solve", path, "--out", tmp_path / "out", "--trajectories", 32,
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    _, error = process.communicate(timeout=60)
    assert process.returncode == 2 and time.monotonic() - started < 30
    message = one_line(error)
    found = re.fullmatch(re.escape(str(path)) + r": memory: about ([\d.e+]+) GB needed for 4 triangles, (\d+) receivers, 1 luminaires, "
                         r"(\d+) pixels, and ([\d.]+) GB are allowed by ulimit -v; expected a smaller scene, or more memory", message)
    assert found, message
    assert not (tmp_path / "out").exists()
    return [float(figure) for figure in found.groups()]


def test_too_many_receivers(scene, tmp_path):
    scene["receivers"][0]["plane"]["resolution"] = [2000, 2000]
    needed, receivers, _, there = refusal(scene, tmp_path, 4 * 1024**3)
    assert receivers == pytest.approx(4e6, rel=1e-3) and needed > there > 0.5 and needed == pytest.approx(receivers * 2e-6, rel=1)


def test_too_many_pixels(scene, tmp_path):
    scene["cameras"][0]["resolution"] = [10000, 10000]
    needed, _, pixels, there = refusal(scene, tmp_path, 4 * 1024**3)
    assert pixels == 1e8 and needed > 50 and there < 4.3


def test_what_is_predicted_suffices(scene, tmp_path):
    """A solve runs where the shell allows what it is predicted to need."""
    scene["receivers"][0]["plane"]["resolution"] = [100, 100]
    limit = 4 * 1024**3
    process = launch("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 32,
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    _, error = process.communicate(timeout=120)
    assert process.returncode == 0, error
