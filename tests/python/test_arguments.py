# SPDX-License-Identifier: BSD-3-Clause
"""Every array and option that cannot be used is a ValueError with its name, its shape and what is expected."""
import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk

import kalos
from kalos.errors import KalosError

UP = (0.0, 0.0, 1.0)
POINTS = np.array([[1.0, 1, 0], [2, 1, 0], [2, 2, 0]])


def estimate(points=POINTS, normals=UP, surfaces=None, luminaires=None, **options):
    surfaces = surfaces if surfaces is not None else kalos.quad((0, 0, 0), (4, 0, 0), (0, 4, 0), 0.5)
    return kalos.illuminance(surfaces, luminaires or kalos.luminaire((2, 2, 3), 100), points, normals, **options)


def mesh(vertices=((0, 0, 0), (1, 0, 0), (0, 1, 0)), faces=((0, 1, 2),), reflectance=0.5, **material):
    return kalos.surface(vertices, faces, reflectance, **material)


def with_nan():
    points = POINTS.copy()
    points[2, 1] = np.nan
    return points


def from_file():
    """A luminaire that refers to a candela table, as the reader of photometric files makes it."""
    lamp = kalos.luminaire((1, 1, 1), 5)
    lamp.GetPointData().GetArray("Distribution").SetValue(0, 2)
    return lamp


def distributed(number):
    """A luminaire whose Distribution is this number, of an array that can hold any."""
    lamp = kalos.luminaire((2, 2, 3), 5)
    array = numpy_to_vtk(np.array([number], float), deep=True)
    array.SetName("Distribution")
    lamp.GetPointData().AddArray(array)
    return lamp


NORMALS = np.tile(UP, (3, 1))
KINDS = "expected 0 (isotropic), 1 (Lambertian) or 2 and more (candela tables)"


@pytest.mark.parametrize("call, message", [
    (lambda: estimate(POINTS[:, :2].copy()), "points: has shape (3, 2), expected (n, 3) or (rows, columns, 3)"),
    (lambda: estimate(POINTS[0]), "points: has shape (3,), expected (n, 3) or (rows, columns, 3)"),
    (lambda: estimate(np.zeros((0, 3))), "points: has shape (0, 3), expected at least one"),
    (lambda: estimate(POINTS > 0), "points: has shape (3, 3) and dtype bool, expected float64 or float32"),
    (lambda: estimate(POINTS.astype(">f8")), "points: has shape (3, 3) and dtype >f8, expected float64 or float32"),
    (lambda: estimate(np.asfortranarray(POINTS)),
     "points: has shape (3, 3) and is not C-contiguous, expected numpy.ascontiguousarray(points)"),
    (lambda: estimate(with_nan()), "points: has shape (3, 3) and is nan at [2, 1], expected finite numbers"),
    (lambda: estimate("desk"), "points: is not an array of numbers, expected one with shape (n, 3) or (rows, columns, 3)"),
    (lambda: estimate([[0, 0, 0], [1, 1]]),
     "points: is not an array of numbers, expected one with shape (n, 3) or (rows, columns, 3)"),
    (lambda: estimate(normals=NORMALS[:2]), "normals: has shape (2, 3), expected (3, 3) or (3,)"),
    (lambda: estimate(normals=NORMALS * [1, 1, 2]), "normals: has shape (3, 3) and length 2 at [0], expected unit vectors"),
    (lambda: estimate(normals=(0, 0, 0)), "normals: has shape (3,) and length 0 at [], expected unit vectors"),
    (lambda: estimate(luminaires=distributed(np.nan)), f"Distribution of luminaire 0: is nan, {KINDS}"),
    (lambda: estimate(luminaires=distributed(-1)), f"Distribution of luminaire 0: is -1, {KINDS}"),
    (lambda: estimate(luminaires=distributed(1e300)), f"Distribution of luminaire 0: is 1e+300, {KINDS}"),
    (lambda: estimate(luminaires=distributed(0.5)), f"Distribution of luminaire 0: is 0.5, {KINDS}"),
    (lambda: estimate(surfaces=5), "surfaces: item 0 is of int, expected vtkPolyData or a list of them"),
    (lambda: estimate(luminaires=[None]), "luminaires: item 0 is of NoneType, expected vtkPolyData or a list of them"),
    (lambda: estimate(luminaires=[kalos.luminaire((1, 1, 1), 5), from_file()]),
     "luminaires: item 1 refers to a candela table that it does not have, expected the field data arrays CandelaTable0 and CandelaPoles"),
    (lambda: estimate(surfaces=[mesh(), kalos.luminaire((1, 1, 1), 5)]),
     "surfaces: item 1 has no array Reflectance, expected what kalos.surface() or kalos.luminaire() makes"),
    (lambda: estimate(surfaces=[mesh(reflectance=[[0.1, 0.2, 0.3]]), mesh(reflectance=[[0.1, 0.2]])]),
     "surfaces: item 1 has 2 components of Reflectance, expected 1 or 3"),
    (lambda: mesh(vertices=[[0, 0], [1, 0], [0, 1]]), "vertices: has shape (3, 2), expected (n, 3)"),
    (lambda: mesh(faces=[[0, 1, 3]]), "faces: has shape (1, 3) and is 3 at [0, 2], expected indices of the 3 vertices"),
    (lambda: mesh(faces=[[0, 1]]), "faces: has shape (1, 2), expected (m, k) with k >= 3 corners"),
    (lambda: mesh(faces=np.zeros((0, 3), int)), "faces: has shape (0, 3), expected at least one"),
    (lambda: mesh(faces=np.array([[0.0, 1, 2]])), "faces: has shape (1, 3) and dtype float64, expected int64 or int32"),
    (lambda: mesh(reflectance=1), "reflectance: has shape () and is 1 at [], expected numbers in [0, 1)"),
    (lambda: mesh(reflectance=[0.5, 0.5]), "reflectance: has shape (2,), expected one"),
    (lambda: mesh(exitance=-1), "exitance: has shape () and is -1 at [], expected lm/m2 >= 0"),
    (lambda: mesh(specular=1.5), "specular: has shape () and is 1.5 at [], expected numbers in [0, 1)"),
    (lambda: mesh(roughness=0), "roughness: has shape () and is 0 at [], expected numbers in (0, 1]"),
    (lambda: mesh(mirror=-0.5), "mirror: has shape () and is -0.5 at [], expected numbers in [0, 1)"),
    (lambda: kalos.quad((0, 0, 0), (1, 0, 0), (2, 0, 0), 0.5),
     "v: has shape (3,) and spans no area with u, expected a side that is not parallel to u"),
    (lambda: kalos.box((0, 0, 0), (1, 1, 0), 0.5), "size: has shape (3,) and is 0 at [2], expected lengths > 0 in metres"),
    (lambda: kalos.luminaire((0, 0, 0), -5), "flux: has shape () and is -5 at [], expected lumens >= 0"),
    (lambda: kalos.luminaire(POINTS, [5.0, 5.0]), "flux: has shape (2,), expected 3 of them, one each"),
    (lambda: kalos.luminaire((0, 0, 0), 5, aim=(0, 0, 0)), "aim: has shape (3,) and is zero, expected a direction"),
    (lambda: kalos.luminaire((0, 0, 0), 5, distribution="spot"), "distribution: is 'spot', expected one of isotropic, lambertian"),
    (lambda: kalos.panel((0, 0, 0), (1, 0, 0), (1, 0, 0), 5), "v: has shape (3,) and spans no area with u, expected a side at a "
     "right angle to u"),
    (lambda: kalos.panel((0, 0, 0), (1, 0, 0), (1, 1, 0), 5), "v: has shape (3,) and is not at a right angle to u, expected a "
     "rectangle"),
    (lambda: kalos.panel((0, 0, 0), (1, 0, 0), (0, 1, 0), 5, aim=(0, 1, 1)),
     "aim: has shape (3,) and is not at a right angle to u and v, expected u x v or its opposite"),
    (lambda: kalos.luminance(mesh(), None, (0, 0), (0, 0, 1)), "position: has shape (2,), expected (3,)"),
    (lambda: kalos.luminance(mesh(exitance=1), None, (0, 0, 1), (0, 0, 1)), "camera: position and target must differ"),
    (lambda: estimate(error=2), "error: '2' is not allowed, expected a relative error > 0 and < 1, such as 0.01"),
    (lambda: estimate(trajectories=1.5), "trajectories: '1.5' is not allowed, expected a whole number from 1 to "
     "9223372036854775807"),
    (lambda: estimate(method="magic"), "method: 'magic' is not allowed, expected one of compensated, gathered, local, "
     "sphere-published, sphere-exact, disc, clamped, direct, paths, photon-map"),
    (lambda: estimate(method_options={"photons": 5}), "method_options: photons has no effect on compensated, expected method "
     "photon-map"),
    (lambda: estimate(method="photon-map", method_options={"photons": 0}), "photons: '0' is not allowed, expected a whole number "
     "from 1 to 9223372036854775807"),
    (lambda: estimate(method="photon-map", method_options={"cone_filter": 2}), "cone_filter: '2' is not allowed, expected True or "
     "False"),
    (lambda: estimate(method_options={"k": 5}), "method_options: 'k' is not there, expected some of photons, cone_filter, "
     "final_gather"),
    (lambda: estimate(delta=-1), "delta: '-1' is not allowed, expected auto, or a length > 0 in metres"),
    (lambda: estimate(mesh(), surfaces=mesh(reflectance=0.5, mirror=0.6)),
     "points: is not an array of numbers, expected one with shape (n, 3) or (rows, columns, 3)"),
    (lambda: estimate(surfaces=mesh(reflectance=0.5, mirror=0.6)),
     "Reflectance of cell 0: with Specular and Mirror must sum to less than 1")])
def test_message(call, message):
    with pytest.raises(ValueError) as error:
        call()
    assert str(error.value) == message
    assert isinstance(error.value, KalosError) and error.value.status == 2


def test_lengths_that_only_the_scene_can_refuse_name_the_option():
    with pytest.raises(ValueError, match=r"^delta: is 99 m, expected None, or a length up to"):
        estimate(method="sphere-exact", delta=99)


def test_lists_are_converted():
    result = estimate([[1, 1, 0], [2, 1, 0]], [[0, 0, 1], [0, 0, 1]], trajectories=64)
    assert result.illuminance.shape == (2,)
