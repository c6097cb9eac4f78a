# SPDX-License-Identifier: BSD-3-Clause
"""Calculation planes and luminaires."""
import math

import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCellCenters

from helpers import update_error
from kalos.vtk import vtkKalosCalculationPlane, vtkKalosLuminaireSource

NAN = math.nan


def make_plane(**settings):
    plane = vtkKalosCalculationPlane()
    for name, value in settings.items():
        getattr(plane, "Set" + name)(value)
    return plane


def make_luminaire(**settings):
    luminaire = vtkKalosLuminaireSource()
    for name, value in settings.items():
        getattr(luminaire, "Set" + name)(value)
    return luminaire


def test_plane_cells_run_along_u():
    plane = make_plane(Origin=(1, 2, 3), U=(4, 0, 0), V=(0, 0, 6), Resolution=(2, 3))
    centres = vtkCellCenters()
    centres.SetInputConnection(plane.GetOutputPort())
    centres.Update()
    points = [centres.GetOutput().GetPoint(i) for i in range(6)]
    assert points == [(2, 2, 4), (4, 2, 4), (2, 2, 6), (4, 2, 6), (2, 2, 8), (4, 2, 8)]


@pytest.mark.parametrize("flip, sign", [(False, 1), (True, -1)])
def test_plane_normals_and_winding(flip, sign):
    plane = make_plane(U=(2, 0, 0), V=(1, 3, 0), Resolution=(2, 2), Flip=flip)
    plane.Update()
    data = plane.GetOutput()
    assert (vtk_to_numpy(data.GetCellData().GetNormals()) == [0, 0, sign]).all()
    for i in range(4):
        ids = data.GetCell(i).GetPointIds()
        a, b, c = (data.GetPoint(ids.GetId(k)) for k in range(3))
        z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        assert z * sign > 0


@pytest.mark.parametrize("settings, message", [
    ({"U": (0, 0, 0)}, "has no area; expected U and V"),
    ({"V": (2, 0, 0)}, "has no area; expected U and V"),
    ({"Origin": (NAN, 0, 0)}, "must be finite numbers"),
    ({"V": (0, math.inf, 0)}, "must be finite numbers"),
    ({"Resolution": (0, 4)}, "resolution is 0 x 4; expected at least 1 x 1"),
    ({"Resolution": (20000, 20000)}, "at most 100000000 cells"),
])
def test_plane_errors(settings, message):
    plane = make_plane(**settings)
    assert message in update_error(plane)
    assert plane.GetOutput().GetNumberOfCells() == 0


def arrays_of(luminaire):
    luminaire.Update()
    data = luminaire.GetOutput().GetPointData()
    names = [data.GetAbstractArray(i).GetName() for i in range(data.GetNumberOfArrays())]
    return {n: data.GetArray(n).GetTuple(0) for n in names if data.GetArray(n)}


def test_point_luminaire():
    arrays = arrays_of(make_luminaire(Position=(1, 2, 3), Aim=(0, 0, -5), Flux=800, Distribution=0))
    assert arrays == {"LuminousFlux": (800,), "Direction": (0, 0, -1), "Up": (0, 1, 0), "Distribution": (0,),
                      "SideU": (0, 0, 0), "SideV": (0, 0, 0)}


@pytest.mark.parametrize("aim, rotation, up", [
    ((0, 0, -1), 90, (-1, 0, 0)),  # counter-clockwise from above: +y turns to -x
    ((0, 0, 1), 0, (0, 1, 0)),
    ((1, 0, 0), 0, (0, 1, 0)),
    ((0, 1, 0), 0, (0, 0, 1)),
    ((0, -3, 0), 0, (0, 0, 1)),
])
def test_up(aim, rotation, up):
    arrays = arrays_of(make_luminaire(Aim=aim, RotationDegrees=rotation))
    assert arrays["Up"] == pytest.approx(up, abs=1e-12)


def test_rectangle_is_lambertian():
    arrays = arrays_of(make_luminaire(Shape=1, Distribution=0, SideU=(2, 0, 0), SideV=(0, 1, 0), Aim=(0, 0, 3)))
    assert arrays["Distribution"] == (1,)
    assert (arrays["SideU"], arrays["SideV"], arrays["Direction"]) == ((2, 0, 0), (0, 1, 0), (0, 0, 1))


@pytest.mark.parametrize("settings, message", [
    ({"Flux": -1}, "the luminous flux is negative or not finite; expected at least 0 lm"),
    ({"Flux": NAN}, "the luminous flux is negative or not finite; expected at least 0 lm"),
    ({"Aim": (0, 0, 0)}, "the aim is zero or not finite; expected a direction"),
    ({"Position": (0, NAN, 0)}, "the position is not finite; expected three numbers in metres"),
    ({"RotationDegrees": NAN}, "the rotation is not finite; expected degrees"),
    ({"Shape": 1, "SideV": (1, 0, 0)}, "the luminous rectangle has no area; expected two finite sides"),
    ({"Shape": 1, "SideV": (NAN, 0, 0)}, "the luminous rectangle has no area; expected two finite sides"),
    ({"Shape": 1, "SideV": (0.1, 1, 0)}, "are not perpendicular to each other; expected a rectangle"),
    ({"Shape": 1, "Aim": (1, 0, -1)}, "the aim is not perpendicular to the luminous rectangle"),
])
def test_luminaire_errors(settings, message):
    luminaire = make_luminaire(Name="lamp", **settings)
    error = update_error(luminaire)
    assert error.startswith("luminaire 'lamp': ") and message in error
    assert luminaire.GetOutput().GetNumberOfPoints() == 0
