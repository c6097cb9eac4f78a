# SPDX-License-Identifier: BSD-3-Clause
"""White furnace at 1 mm from edges of every kind that is found, after preparation and after remeshing."""
import math

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkCommonCore import mutable, vtkPoints

from helpers import update_error
from kalos.vtk import vtkKalosIlluminance, vtkKalosSingularEdges, vtkKalosSurfaceRemesh, vtkKalosSurfaceRepair
from test_mesh_preparation import CUBE, SIDES, make, surface

RHO, E = 0.6, 250.0
NEAR = 1e-3  # m
KINDS = {"concave": vtkKalosSingularEdges.CONCAVE, "convex": vtkKalosSingularEdges.CONVEX,
         "non-manifold": vtkKalosSingularEdges.NON_MANIFOLD, "contact": vtkKalosSingularEdges.CONTACT}


class Solid:
    """A box turned about the vertical."""

    def __init__(self, centre, size, degrees=0.0):
        self.centre, self.size = np.array(centre, float), np.array(size, float)
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        self.axes = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])

    def corners(self):
        return self.centre + ((np.array(CUBE) - 0.5) * self.size) @ self.axes

    def holds(self, point):
        return (abs(self.axes @ (point - self.centre)) < self.size / 2).all()


ROOM = Solid((2, 2, 1.5), (4, 4, 3))
BOXES = [Solid((1, 1.1, 0.4), (0.8, 0.8, 0.8), 25),  # stands on the floor
         Solid((1.05, 1.05, 0.95), (0.4, 0.3, 0.3), 60),  # stands on the first
         Solid((2.9, 1, 0.3), (0.7, 0.9, 1.3), -20),  # goes through the floor
         Solid((2.4, 2.9, 1.8), (0.6, 0.6, 0.6)), Solid((3.0, 3.5, 1.8), (0.6, 0.6, 0.6))]  # share an edge, in the air


def furnace():
    points, polygons = [], []
    for solid in (ROOM, *BOXES):
        sides = [side[::-1] for side in SIDES] if solid is ROOM else SIDES
        polygons += [tuple(i + len(points) for i in side) for side in sides]
        points += [tuple(corner) for corner in solid.corners()]
    n = len(polygons)
    return surface(points, polygons, Reflectance=np.full(n, RHO), Exitance=np.full(n, (1 - RHO) * E))


def places(curve, surfaces, locator):
    """Points at NEAR from the middle of a curve on the surfaces beside it, with normals, where light can get."""
    points = [np.array(curve.GetPoints().GetPoint(i)) for i in range(curve.GetNumberOfPoints())]
    middle = len(points) // 2
    place, along = 0.5 * (points[middle - 1] + points[middle]), points[middle] - points[middle - 1]
    along /= np.linalg.norm(along)
    u = np.cross(along, (0.3, 0.5, 0.8))
    u /= np.linalg.norm(u)
    v = np.cross(along, u)
    found, last = [], -1.0
    for angle in np.linspace(0, 2 * math.pi, 7200, endpoint=False):
        candidate = place + NEAR * (math.cos(angle) * u + math.sin(angle) * v)
        foot, cell, part, squared = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
        locator.FindClosestPoint(candidate, foot, cell, part, squared)
        if squared > 1e-12 or angle - last < 0.05:
            continue
        last = angle
        corners = [np.array(surfaces.GetPoint(surfaces.GetCell(int(cell)).GetPointId(k))) for k in range(3)]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        above = np.array(foot) + 1e-4 * normal
        if ROOM.holds(above) and not any(box.holds(above) for box in BOXES):
            found.append((foot, normal))
    return found


@pytest.mark.parametrize("edge_length", [None, 0.2])
def test_one_millimetre_from_every_kind_of_edge(edge_length):
    """At most 150 receivers; Student with 7 degrees of freedom and Šidák for all of both: |t| < 12, false alarm 1e-3."""
    repair = make(vtkKalosSurfaceRepair, furnace())
    assert update_error(repair) is None
    surfaces = repair.GetOutput()
    if edge_length:
        remesh = make(vtkKalosSurfaceRemesh, surfaces, EdgeLength=edge_length)
        assert update_error(remesh) is None
        surfaces = remesh.GetOutput()
        assert surfaces.GetNumberOfCells() > 2000
    edges = make(vtkKalosSingularEdges, surfaces, ConvexEdges=True)
    assert update_error(edges) is None
    curves = edges.GetOutput()
    kinds = vtk_to_numpy(curves.GetCellData().GetArray("EdgeClass"))

    locator = vtkStaticCellLocator()
    locator.SetDataSet(surfaces)
    locator.BuildLocator()
    points, normals, kind_of = [], [], []
    for name, kind in KINDS.items():
        for i in np.flatnonzero(kinds == kind)[:12]:
            for place, normal in places(curves.GetCell(int(i)), surfaces, locator):
                points.append(place)
                normals.append(normal)
                kind_of.append(name)
    counts = {name: kind_of.count(name) for name in KINDS}
    assert counts["concave"] == 24 and counts["contact"] >= 20 and counts["non-manifold"] == 4 and counts["convex"] >= 16
    assert len(points) <= 150

    receivers = vtkPolyData()
    places_ = vtkPoints()
    places_.SetDataTypeToDouble()
    for point in points:
        places_.InsertNextPoint(point)
    receivers.SetPoints(places_)
    receivers.GetPointData().SetNormals(numpy_to_vtk(np.array(normals), deep=True))
    estimate = vtkKalosIlluminance()
    estimate.SetInputData(0, receivers)
    estimate.SetInputData(1, surfaces)
    estimate.SetTrajectories(16384)
    estimate.SetSeed(11)
    estimate.SetDisabledTechniques("paths")  # in a furnace these would do, and know no edges
    assert update_error(estimate) is None
    data = estimate.GetOutputDataObject(0).GetPointData()
    value, error = (vtk_to_numpy(data.GetArray(name)) for name in ("Illuminance", "IlluminanceStandardError"))
    for i in np.flatnonzero(~(abs(value - E) < 12 * error)):
        pytest.fail(f"{kind_of[i]} at {points[i]}: {value[i]:.2f} ± {error[i]:.2f} lx, expected {E} lx; seed 11")
    assert error.max() < 0.03 * E
    assert abs(value.mean() - E) < 0.01 * E
