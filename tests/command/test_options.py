# SPDX-License-Identifier: BSD-3-Clause
"""Every message about a bad option or output folder: exit status 2 and one line, before anything is solved."""
import pytest
from conftest import launch, one_line

from kalos.core.options import METHODS, TECHNIQUES

COUNT = "expected a whole number from 1 to 9223372036854775807"
LENGTH = "expected auto, or a length > 0 in metres"

ENDS = "expected LOW:HIGH, such as 0:500, with 0 <= LOW < HIGH"
BAD = [
    ("--trajectories", "-5", COUNT), ("--trajectories", "0", COUNT), ("--trajectories", "1.5", COUNT),
    ("--trajectories", "9223372036854775808", COUNT),
    ("--delta", "nan", LENGTH), ("--delta", "-1", LENGTH), ("--delta", "0", LENGTH), ("--epsilon", "inf", LENGTH),
    ("--epsilon", "wide", LENGTH), ("--epsilon", "-0.1", LENGTH), ("--epsilon", "0", LENGTH), ("--epsilon", "nan", LENGTH),
    ("--error", "0", "expected a relative error > 0 and < 1, such as 0.01"),
    ("--error", "1", "expected a relative error > 0 and < 1, such as 0.01"),
    ("--error-floor", "-1", "expected a half-width of 0 lx or more"),
    ("--range", "5", ENDS), ("--range", "5:5", ENDS), ("--luminance-range", "0:nan", ENDS),
    ("--disable", "picked,walls", f"expected some of {', '.join(TECHNIQUES)}"),
    ("--photons", "0", COUNT),
    ("--time", "-1", "expected a time > 0, in seconds"),
    ("--seed", "-1", "expected a whole number from 0 to 2147483647"),
    ("--threads", "many", "expected a whole number from 0 (all) to 1024"),
]


@pytest.mark.parametrize("option, value, expected", BAD)
def test_bad_value(scene, command, tmp_path, option, value, expected):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", option, value)
    assert status == 2
    wrong = value.rpartition(",")[2]
    assert one_line(error) == f"{option}: '{wrong}' is not allowed, {expected}; kalos solve --help tells more"
    assert not (tmp_path / "out").exists()


def test_unknown_method(scene, command, tmp_path):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--method", "magic")
    assert status == 2 and one_line(error).startswith("--method: invalid choice: 'magic' (choose from 'compensated', ")


@pytest.mark.parametrize("option, methods", [(("--photons", "50"), "photon-map"), (("--cone-filter",), "photon-map"),
                                             (("--final-gather",), "photon-map")])
def test_option_of_another_method(scene, command, tmp_path, option, methods):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--method", "local", *option)
    assert status == 2
    assert one_line(error) == f"{option[0]}: has no effect on local, expected --method {methods}"
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("option", ["--delta", "--epsilon"])
def test_length_larger_than_the_scene(scene, command, tmp_path, option):
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", option, "2.5", "--method", "sphere-exact")
    assert status == 2
    assert one_line(error) == f"{option}: is 2.5 m, expected auto, or a length up to the size of the scene, 2 m"
    assert not (tmp_path / "out").exists()


def test_automatic_lengths_are_the_default(scene, command, tmp_path):
    path = scene.save()
    tables = []
    for i, lengths in enumerate(((), ("--delta", "auto", "--epsilon", "auto"), ("--delta", 0.9, "--epsilon", 0.9))):
        out = tmp_path / f"out{i}"
        status, _, _ = command("solve", path, "--out", out, "--trajectories", 640, "--method", "sphere-exact", *lengths)
        assert status == 0
        tables.append((out / "wall.csv").read_bytes())
    assert tables[0] == tables[1] != tables[2]


@pytest.mark.parametrize("method", METHODS)
def test_every_method_runs_or_says_that_it_is_not_there(scene, command, tmp_path, method):
    out = tmp_path / "out"
    status, _, error = command("solve", scene.save(), "--out", out, "--method", method, "--trajectories", 640)
    if status:
        assert status == 2 and one_line(error).startswith("--method: ")
    assert out.exists() == (status == 0)


@pytest.mark.parametrize("arguments, message", [
    ((), "missing COMMAND; kalos --help tells more"),
    (("solve",), "missing SCENE, --out; kalos solve --help tells more"),
    (("solve", "a.json"), "missing --out; kalos solve --help tells more"),
    (("solve", "a.json", "--out"), "--out: expected one argument; kalos solve --help tells more"),
    (("solve", "a.json", "--out", "b", "--bogus"), "unrecognized arguments: --bogus; kalos --help tells more")])
def test_bad_usage(command, arguments, message):
    status, _, error = command(*arguments)
    assert (status, one_line(error)) == (2, message)


def test_unknown_command(command):
    status, _, error = command("slove")
    assert status == 2 and one_line(error).startswith("COMMAND: invalid choice: 'slove'")


@pytest.mark.parametrize("below", ["", "/deeper"])
def test_output_folder_is_a_file(scene, command, tmp_path, below):
    (tmp_path / "taken").write_text("precious")
    out = f"{tmp_path}/taken{below}"
    status, _, error = command("solve", scene.save(), "--out", out)
    assert status == 2
    assert one_line(error) == f"{out}: --out: cannot be written (Not a directory), expected a folder to write into"
    assert (tmp_path / "taken").read_text() == "precious"


def test_output_folder_on_a_file_system_that_refuses(scene, command):
    status, _, error = command("solve", scene.save(), "--out", "/proc/kalos/out")
    assert status == 2
    assert one_line(error).startswith("/proc/kalos/out: --out: cannot be written (")


def test_help_and_version_from_the_build_tree():
    process = launch("--help")
    out, error = process.communicate(timeout=60)
    assert process.returncode == 0 and not error
    assert "solve" in out and "validate" in out
    process = launch("--version")
    assert process.communicate(timeout=60)[0].startswith("kalos 0.")


def test_help_of_solve_names_every_option(command):
    status, out, _ = command("solve", "--help")
    assert status == 0
    for option in ("--out", "--method", "--trajectories", "--delta", "--epsilon", "--error", "--time", "--seed", "--threads"):
        assert option in out
