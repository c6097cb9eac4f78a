# SPDX-License-Identifier: BSD-3-Clause
"""What `kalos solve` writes and prints."""
import csv
import json
import os

import numpy as np
import pytest
from conftest import PROBE, launch
from matplotlib.image import imread
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import kalos

HEADER = "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,direct_lx,trusted,valid"


@pytest.fixture
def solved(scene, command, tmp_path):
    """The folder of a solved scene, and what the command printed."""
    status, out, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 3200, "--seed", 7)
    assert status == 0, error
    return tmp_path / "out", out, error


def read_csv(path):
    return np.array(list(csv.reader(path.open()))[1:], float)


def untrusted(path):
    """How many receivers of a data set are marked as not to be trusted."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return int((vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("IntervalTrusted")) == 0).sum())


def test_files(solved, tmp_path):
    folder, _, _ = solved
    assert sorted(os.listdir(folder)) == ["desk.csv", "desk.png", "desk.vtp", "front.exr", "front.png", "probe.csv",
                                          "probe.png", "probe.vtp", "summary.json", "wall.csv", "wall.png", "wall.vtp"]
    assert sorted(os.listdir(tmp_path)) == ["out", "probe.csv", "scene.json"]


def test_table_of_a_plane(solved):
    folder, _, _ = solved
    lines = (folder / "desk.csv").read_text().splitlines()
    assert lines[0] == HEADER
    table = read_csv(folder / "desk.csv")
    x, y = np.meshgrid([0.25, 0.75, 1.25, 1.75], [0.25, 0.75])  # cell centres, row by row along u
    np.testing.assert_allclose(table[:, :3], np.column_stack([x.ravel(), y.ravel(), np.full(8, 0.7)]), atol=1e-12)
    np.testing.assert_array_equal(table[:, 3:6], np.tile([0.0, 0, 1], (8, 1)))
    # Every number reads back as it was.
    assert all(repr(float(cell)) == cell for line in lines[1:] for cell in line.split(",")[:9])
    assert all(line.endswith((",1,1", ",0,1")) for line in lines[1:])
    # Direct light of the lamp: E = Phi/pi cos2/d2, but for the lift of the receivers off their surface.
    height, squared = 1.3, 1.3**2 + (table[:, 0] - 1) ** 2 + (table[:, 1] - 1) ** 2
    np.testing.assert_allclose(table[:, 8], 1000 / np.pi * height**2 / squared**2, rtol=1e-4)
    assert (table[:, 6] > table[:, 8]).all() and (table[:, 7] > 0).all()


def test_tables_hold_what_the_data_sets_hold(solved):
    folder, _, _ = solved
    for name, of_cells in (("desk", True), ("wall", True), ("probe", False)):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(folder / f"{name}.vtp"))
        reader.Update()
        data = reader.GetOutput().GetCellData() if of_cells else reader.GetOutput().GetPointData()
        table = read_csv(folder / f"{name}.csv")
        for column, array in ((6, "Illuminance"), (7, "IlluminanceStandardError"), (8, "DirectIlluminance")):
            values = data.GetArray(array)
            assert values.GetDataTypeAsString() == "double"
            np.testing.assert_array_equal(vtk_to_numpy(values), table[:, column])


def test_summary(solved):
    folder, _, _ = solved
    summary = json.loads((folder / "summary.json").read_text())
    assert sorted(summary) == ["audit", "cameras", "cpu_seconds", "kalos", "method", "observers", "receivers", "scene", "seconds", "seed",
                               "setup_seconds", "tasks", "warnings"]
    assert summary["warnings"] == {"count": 0, "codes": {}, "list": []}
    assert (summary["kalos"], summary["method"], summary["seed"]) == (kalos.__version__, "compensated", 7)
    assert summary["seconds"] > 0 and summary["cpu_seconds"] > 0 and summary["setup_seconds"] > 0
    assert all(sorted(entry) == ["choice", "reason", "subject"] for entry in summary["audit"]) and summary["audit"]
    subjects = [entry["subject"] for entry in summary["audit"]]  # receivers and a camera agree, or each says its own
    assert len(set(subjects)) == len(subjects)
    assert {"bands", "gather rays, receivers", "gather rays, camera front"} <= set(subjects)
    values = read_csv(folder / "desk.csv")[:, 6:8]
    desk = summary["receivers"]["desk"]
    lowest, highest, mean = values[:, 0].min(), values[:, 0].max(), values[:, 0].mean()
    assert (desk["min"], desk["max"]) == (lowest, highest)
    np.testing.assert_allclose([desk["mean"], desk["U0"], desk["Ud"]], [mean, lowest / mean, lowest / highest], rtol=1e-12)
    assert desk["largest_relative_standard_error"] == (values[:, 1] / values[:, 0]).max()
    assert desk["trajectories"] == 3200
    assert desk["untrusted"] == untrusted(folder / "desk.vtp")
    errors = [desk[f"{key}_standard_error"] for key in ("mean", "U0", "Ud")]
    assert 0 < errors[0] < values[:, 1].mean() and all(0 < error < 0.2 for error in errors[1:])
    assert [desk["min_standard_error"], desk["max_standard_error"]] == [values[values[:, 0].argmin(), 1], values[values[:, 0].argmax(), 1]]
    assert sorted(summary["cameras"]["front"]) == ["largest_relative_standard_error", "max", "max_standard_error", "mean",
                                                   "mean_standard_error", "min", "min_standard_error", "trajectories"]


def test_pictures_show_something(solved):
    folder, _, _ = solved
    for name in ("desk", "wall", "probe", "front"):
        picture = imread(folder / f"{name}.png")
        height, width, _ = picture.shape
        assert height > 400 and width > 600
        assert len(np.unique((picture[..., :3] * 255).astype(int).reshape(-1, 3), axis=0)) > 50
        corners = picture[[0, 0, -1, -1], [0, -1, 0, -1], :3]
        np.testing.assert_array_equal(corners, 1)  # white paper, nothing cut off at the rim


def test_image_is_read_back(solved):
    folder, _, _ = solved
    reader = kalos.vtkKalosEXRReader()
    reader.SetFileName(str(folder / "front.exr"))
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (16, 12, 1)
    luminance = vtk_to_numpy(image.GetPointData().GetArray("Luminance")).reshape(12, 16)
    figures = json.loads((folder / "summary.json").read_text())["cameras"]["front"]
    np.testing.assert_allclose([luminance.min(), luminance.mean(), luminance.max()],
                               [figures["min"], figures["mean"], figures["max"]], rtol=1e-6)
    assert image.GetPointData().HasArray("LuminanceStandardError")
    assert luminance[6, 8] > 0  # the wall, straight ahead


def test_prints_audit_table_and_paths(solved):
    folder, out, error = solved
    assert out.startswith("audit\n  ")
    assert "mean lx" in out and "mean cd/m²" in out and "solved in " in out
    for name in ("desk", "front", "probe", "wall"):
        assert f"\n  {folder / name}.png" in out
    assert "illuminance" in error and "100%" in error  # the progress, away from the results


def test_same_seed_same_numbers_whatever_the_threads(scene, command, tmp_path):
    path = scene.save()
    tables = []
    for i, (seed, threads) in enumerate(((1, 1), (1, 2), (2, 2))):
        out = tmp_path / f"out{i}"
        status, _, _ = command("solve", path, "--out", out, "--trajectories", 640, "--seed", seed, "--threads", threads)
        assert status == 0
        tables.append((out / "desk.csv").read_bytes())
    assert tables[0] == tables[1] != tables[2]


def test_stops_at_a_goal(scene, command, tmp_path):
    path = scene.save()
    assert command("solve", path, "--out", tmp_path / "a", "--error", 0.2)[0] == 0
    figures = json.loads((tmp_path / "a" / "summary.json").read_text())["receivers"]["probe"]
    assert 2 * figures["largest_relative_standard_error"] < 0.2
    assert command("solve", path, "--out", tmp_path / "b", "--time", 0.2)[0] == 0
    summary = json.loads((tmp_path / "b" / "summary.json").read_text())
    assert summary["seconds"] < 2  # two solves of 0.2 s


def test_replaces_its_files_and_keeps_others(scene, command, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    (out / "notes.txt").write_text("mine")
    (out / "desk.csv").write_text("old")
    assert command("solve", scene.save(), "--out", out, "--trajectories", 32)[0] == 0
    assert (out / "notes.txt").read_text() == "mine"
    assert (out / "desk.csv").read_text().startswith(HEADER)
    assert not [name for name in os.listdir(out) if name.startswith(".")]


def test_tells_which_values_not_to_trust(scene, command, tmp_path):
    """Plain local estimation a tenth of a millimetre from the wall, beside a receiver in the open."""
    path = scene.save(probe=PROBE.splitlines()[0] + "\n1,1.9999,0,0,0,1\n1,0.5,0,0,0,1\n")
    status, out, _ = command("solve", path, "--out", tmp_path / "a", "--method", "local", "--trajectories", 32000)
    assert status == 0 and "untrusted: receivers whose standard error" in out
    assert json.loads((tmp_path / "a" / "summary.json").read_text())["receivers"]["probe"]["untrusted"] == 1
    status, out, _ = command("solve", path, "--out", tmp_path / "b", "--trajectories", 32000)
    assert status == 0
    assert json.loads((tmp_path / "b" / "summary.json").read_text())["receivers"]["probe"]["untrusted"] == 0


def test_direct_simulation(scene, command, tmp_path):
    status, out, _ = command("solve", scene.save(), "--out", tmp_path / "out", "--method", "direct", "--trajectories", 3200)
    assert status == 0 and "result of direct" in out


def test_a_lamp_without_surfaces_obeys_the_inverse_square(scene, command, tmp_path):
    del scene["surfaces"], scene["cameras"], scene["receivers"][1]
    assert command("solve", scene.save(), "--out", tmp_path / "out")[0] == 0
    table = read_csv(tmp_path / "out" / "probe.csv")
    np.testing.assert_allclose(table[1, 6], 1000 / np.pi * 4 / (4 + 0.25) ** 2, rtol=1e-4)
    np.testing.assert_array_equal(table[:, 7], 0)


def test_command_of_the_build_tree(scene, tmp_path):
    process = launch("solve", scene.save(), "--out", "out", "--trajectories", 32, cwd=tmp_path)
    out, error = process.communicate(timeout=60)
    assert process.returncode == 0, error
    assert "  out/desk.png\n" in out and (tmp_path / "out" / "desk.png").is_file()


def test_goal_is_judged(scene, command, tmp_path):
    """Every receiver is told to have reached the error, to be dim, or to have missed it, and the audit says why."""
    path = scene.save()
    for name, more, says in (("reached", ["--error-floor", 1e4], "95 % half-widths"), ("missed", [], "all trajectories allowed")):
        out = tmp_path / name
        status, told, error = command("solve", path, "--out", out, "--error", 1e-4, "--trajectories", 640, *more)
        assert status == 0, error
        summary = json.loads((out / "summary.json").read_text())
        goal = summary["receivers"]["desk"]["goal"]
        counts = (goal["within_error"], goal["below_floor"], goal["missed"], goal["missed_receivers"])
        assert counts == ((0, 8, 0, []) if name == "reached" else (0, 0, 8, list(range(8))))
        entry = next(entry for entry in summary["audit"] if entry["subject"].startswith("error"))
        assert entry["reason"].startswith(says)
        assert ("8 receivers of desk missed the error" in told) == (name == "missed")


def test_techniques_can_be_disabled(scene, command, tmp_path):
    tables = []
    for i, more in enumerate(([], ["--disable", "stratified,picked"])):
        status, _, error = command("solve", scene.save(), "--out", tmp_path / f"out{i}", "--trajectories", 3200, *more)
        assert status == 0, error
        tables.append(read_csv(tmp_path / f"out{i}" / "desk.csv"))
    a, b = (table[:, 6] for table in tables)
    assert (a != b).all()
    # Independent seeds of noise: 8 receivers within 5 standard errors, false alarm 5e-6.
    assert (abs(a - b) < 5 * np.hypot(*(table[:, 7] for table in tables))).all()
