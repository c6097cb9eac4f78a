# SPDX-License-Identifier: BSD-3-Clause
"""kalos solve prepares its surfaces: defects that would change the light are repaired, sound scenes are left alone."""
import csv
import json

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIDES = [(1, 3, 2, 0), (6, 7, 5, 4), (4, 5, 1, 0), (3, 7, 6, 2), (2, 6, 4, 0), (5, 7, 3, 1)]  # seen from inside


def cube(crooked=()):
    """A room with corners of its own for every side; crooked ones are shifted a little."""
    lines = []
    for number, side in enumerate(SIDES):
        shift = 1e-7 if number in crooked else 0
        lines += [f"usemtl {'left' if number == 0 else 'right'}"]
        lines += ["v %.9g %.9g %.9g" % tuple(c + shift for c in CUBE[i]) for i in side] + ["f -4 -3 -2 -1"]
    return "\n".join(lines)


@pytest.fixture
def furnace(tmp_path):
    """Writes a white furnace of 200 lx over a room in OBJ; two materials, that only a mix-up would not add up."""

    def save(text):
        (tmp_path / "room.obj").write_text(text)
        (tmp_path / "probe.csv").write_text("x,y,z,nx,ny,nz\n0.5,0.5,0,0,0,1\n0.001,0.5,0,0,0,1\n")
        scene = {"kalos": 1, "materials": {"left": {"reflectance": 0.5, "exitance": 100},
                                           "right": {"reflectance": [0.5], "exitance": [100]}},
                 "surfaces": [{"name": "room", "file": "room.obj", "material": "left"}],
                 "receivers": [{"name": "probe", "points": "probe.csv"}]}
        (tmp_path / "scene.json").write_text(json.dumps(scene))
        return tmp_path / "scene.json"

    return save


def solve(command, scene, out, *options):
    status, printed, error = command("solve", scene, "--out", out, "--trajectories", 3200, *options)
    assert status == 0, error
    summary = json.loads((out / "summary.json").read_text())
    audit = {entry["subject"]: entry["choice"] for entry in summary["audit"]}
    assert all(subject in printed for subject in audit)
    return np.array(list(csv.reader((out / "probe.csv").open()))[1:], float), audit


def test_a_sound_scene_gives_the_same_numbers(furnace, command, tmp_path):
    scene = furnace(cube())
    with_it, audit = solve(command, scene, tmp_path / "with")
    without, off = solve(command, scene, tmp_path / "without", "--no-prepare")
    np.testing.assert_array_equal(with_it, without)
    assert audit["repair"] == "nothing to do"
    assert audit["singular edges"] == "12 concave (12 m), 0 contact (0 m), 0 non-manifold (0 m)"
    assert audit["receivers"] == "0.001 m from a singular edge or more"
    assert off["preparation"] == "off" and "singular edges" not in off
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "with" / "probe.vtp"))
    reader.Update()
    distances = reader.GetOutput().GetPointData().GetArray("EdgeDistance")
    assert [distances.GetValue(i) for i in range(2)] == pytest.approx([0.5, 0.001])


def test_receivers_gather_at_singular_edges_and_nowhere_else(furnace, command, tmp_path):
    """In a cube of 1 m a wall counts within 0.08 of the square root of 6 m²."""
    scene = furnace(cube())
    text = json.loads(scene.read_text())
    text["receivers"].append({"name": "walls", "surface": "room", "edge_length": 0.06})
    scene.write_text(json.dumps(text))
    status, printed, error = command("solve", scene, "--out", tmp_path / "out", "--trajectories", 3200,
                                     "--disable", "paths")
    assert status == 0, error
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "out" / "walls.vtp"))
    reader.Update()
    data = reader.GetOutput().GetCellData()
    distance, angle, rays = (vtk_to_numpy(data.GetArray(name)) for name in ("EdgeDistance", "EdgeAngle", "GatherRays"))
    near = distance < 0.08 * np.sqrt(6)
    assert 200 < near.sum() < len(near) - 200
    np.testing.assert_array_equal(rays > 0, near)
    np.testing.assert_allclose(angle, 90)
    line, = (entry for entry in json.loads((tmp_path / "out" / "summary.json").read_text())["audit"]
             if entry["subject"] == "gather rays")
    assert line["choice"] == f"at {near.sum() + 1} of {len(near) + 2} receivers"
    assert f"{near.sum() + 1} receivers at singular edges, 0 in gaps" in line["reason"]
    spared = float(line["reason"].split(" spared")[0].split()[-1])
    vertices = 1 + 1 / (1 - 0.5)  # of a trajectory: a start, and collisions; a pilot measures them to some percent
    assert spared == pytest.approx(3200 * 0.016 * np.sqrt(vertices) * (len(near) + 1 - near.sum()), rel=0.05)


def test_a_gap_is_told_from_an_edge(furnace, command, tmp_path):
    """A shelf over the probe in the middle of the floor, 5 cm above it and far from every edge."""
    scene = furnace(cube())
    text = json.loads(scene.read_text())
    text["surfaces"].append({"name": "shelf", "quad": {"origin": [0.4, 0.4, 0.05], "u": [0.2, 0, 0], "v": [0, 0.2, 0]},
                             "material": "left"})
    scene.write_text(json.dumps(text))
    _, audit = solve(command, scene, tmp_path / "out", "--disable", "paths")
    assert audit["gather rays"] == "at 2 of 2 receivers"
    reason = [entry["reason"] for entry in json.loads((tmp_path / "out" / "summary.json").read_text())["audit"]
              if entry["subject"] == "gather rays"]
    assert "1 receivers at singular edges, 1 in gaps" in reason[0]


def test_defects_are_repaired(furnace, command, tmp_path):
    # A side shifted by a ten-millionth closes up again.
    scene = furnace(cube(crooked=(3,)))
    table, audit = solve(command, scene, tmp_path / "out")
    assert audit["repair"] == "4 points moved"
    assert (np.abs(table[:, 6] - 200) < 10 * table[:, 7] + 1e-9).all()  # false alarm below 1e-4 with 7 degrees of freedom
    assert (table[:, 7] < 4).all()


def test_doubled_sides_shine_once(furnace, command, tmp_path):
    # The same sides in the same sense again: light that would count twice.
    lines = cube().splitlines()
    scene = furnace("\n".join(lines + lines[:6]))
    table, audit = solve(command, scene, tmp_path / "out")
    assert audit["repair"] == "2 duplicate triangles dropped"
    assert (np.abs(table[:, 6] - 200) < 10 * table[:, 7] + 1e-9).all()
    # Unrepaired as well: of luminous faces in one place one shines.
    table, _ = solve(command, scene, tmp_path / "unrepaired", "--no-prepare", "--disable", "paths", "--trajectories", 25600)
    assert (np.abs(table[:, 6] - 200) < 10 * table[:, 7] + 1e-9).all()


def test_what_stays_unrepaired_is_named(furnace, command, tmp_path):
    lines = cube().splitlines()
    scene = furnace("\n".join(lines + ["usemtl right"] + lines[1:6]))
    scene.write_text(scene.read_text().replace("[0.5]", "[0.4]"))
    _, audit = solve(command, scene, tmp_path / "out")
    assert audit["not repaired"] == "2 cells"
