# SPDX-License-Identifier: BSD-3-Clause
"""data/office/make.py: a real interior of more than 200 000 triangles, with luminaires of known flux."""
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkTriangleFilter

from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.results.receivers import from_dataset
from kalos.scenes.reading import read_scene

MAKE = Path(__file__).resolve().parents[2] / "data" / "office" / "make.py"


@pytest.fixture(scope="module")
def office(tmp_path_factory):
    folder = tmp_path_factory.mktemp("office")
    subprocess.run([sys.executable, MAKE, folder], check=True, capture_output=True)
    return folder


def test_mesh(office):
    """200 000 triangles and more, every body closed and outside out, the room inside out."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(read_scene(office / "office.json").GetSurfaces())
    triangles.Update()
    mesh = triangles.GetOutput()
    assert mesh.GetNumberOfCells() >= 200000
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = points[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    signed = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    room = np.prod(points.max(axis=0) - points.min(axis=0))
    furniture = room + signed.sum()  # the room counts as minus its volume
    assert 1 < furniture < 0.05 * room
    # The six walls are quads of their own: their borders are the only open edges.
    edges = vtkFeatureEdges()
    edges.SetInputData(mesh)
    edges.FeatureEdgesOff()
    edges.Update()
    assert edges.GetOutput().GetNumberOfCells() == 24


def test_both_scenes_agree(office):
    """Same flux as tables and as rectangles, but tables of another shape: the means over the desks differ by some per cent."""
    means = []
    for name in ("office.json", "office-rectangles.json"):
        scene = json.loads((office / name).read_text())
        assert len(scene["luminaires"]) == 8 and scene["receivers"][0]["plane"]["resolution"] == [96, 64]
        scene["receivers"][0]["plane"]["resolution"] = [8, 5]
        (office / "small.json").write_text(json.dumps(scene))
        reader = read_scene(office / "small.json")
        flux = vtk_to_numpy(reader.GetLuminaires().GetPointData().GetArray("LuminousFlux"))
        np.testing.assert_allclose(flux, 1100 * np.pi, rtol=4e-4)
        estimator = illuminance_filter(reader, Options(trajectories=640))
        update(estimator)
        desks = from_dataset("desks", estimator.GetOutputDataObject(0).GetBlock(0))
        assert np.median(desks.standard_error / np.maximum(desks.illuminance, 1)) < 0.05
        means.append(desks.illuminance.mean())
    assert 300 < means[0] < 600
    assert means[0] == pytest.approx(means[1], rel=0.08)
