# SPDX-License-Identifier: BSD-3-Clause
"""Results can be pickled and copied, tell their warnings and units, and go to pandas and xarray."""
import copy
import dataclasses
import pickle

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import kalos
from kalos.estimation.exchange import reduced
from kalos.results.text import number

UP = (0, 0, 1)


@pytest.fixture(scope="module")
def results():
    """A grid with points in a solid, single points in three bands, an image."""
    room, lamp = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True), kalos.luminaire((2, 2, 2.9), 3000)
    coloured = kalos.box((2, 2, 1.5), (4, 4, 3), [[0.6, 0.4, 0.2]], inwards=True)
    x, y = np.meshgrid([0.5, 1.0, 3.0], [0.5, 1.0])
    grid = np.stack([x, y, np.full_like(x, 0.5)], axis=-1)
    solid = kalos.box((1, 1, 0.5), (0.4, 0.4, 1), 0.5)
    return {"grid": kalos.illuminance([room, solid], lamp, grid, UP, trajectories=64),
            "points": kalos.illuminance(coloured, lamp, grid[0], UP, trajectories=64),
            "image": kalos.luminance(coloured, lamp, (2, 0.5, 1), (2, 3, 1), resolution=(4, 3), trajectories=64)}


def data_of(dataset):
    data = dataset.GetPointData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


@pytest.mark.parametrize("name", ["grid", "points", "image"])
@pytest.mark.parametrize("again", [lambda one: pickle.loads(pickle.dumps(one)), copy.deepcopy], ids=["pickle", "deepcopy"])
def test_copies_are_whole(results, name, again):
    one = results[name]
    other = again(one)
    assert type(other) is type(one) and repr(other) == repr(one)
    for field in dataclasses.fields(one):
        if field.name != "vtk":
            np.testing.assert_equal(getattr(other, field.name), getattr(one, field.name))
    assert other.vtk is not one.vtk and other.vtk.GetClassName() == one.vtk.GetClassName()
    assert other.vtk.GetBounds() == one.vtk.GetBounds()
    np.testing.assert_equal(data_of(other.vtk), data_of(one.vtk))
    assert other.vtk.GetFieldData().GetAbstractArray("Audit").GetNumberOfValues() == 3 * len(one.audit)
    other.standard_error[...] = -1  # of the copy alone
    assert (one.standard_error >= 0).all()


def test_warnings_are_told(results):
    one = results["grid"]
    np.testing.assert_array_equal(one.valid, [[True, True, True], [True, False, True]])
    assert len(one.warnings) == 1 and "nothing lit in sight: 1" in one.warnings[0]
    assert "warning: receivers with nothing lit in sight: 1" in repr(one) and "1 left out" in repr(one)
    assert one.illuminance[one.valid].min() > 0 and f"min {number(one.illuminance[one.valid].min())}" in repr(one)
    assert results["points"].warnings == [] and "\n" not in repr(results["points"]) and "left out" not in repr(results["points"])


@pytest.mark.parametrize("kind", [kalos.Illuminance, kalos.Luminance])
def test_every_field_is_documented(kind):
    for field in dataclasses.fields(kind):
        assert f"{field.name}:" in kind.__doc__ or f" {field.name}, " in kind.__doc__ or f"{field.name}, " in kind.__doc__, field.name


def test_integers_are_numbers():
    room, lamp = kalos.box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True), kalos.luminaire(np.array([2, 2, 2]), np.array([3000]))
    points = np.array([[1, 2, 1], [3, 1, 1]])
    one, other = (kalos.illuminance(room, lamp, p, UP, trajectories=64) for p in (points, points.astype(float)))
    np.testing.assert_array_equal(one.illuminance, other.illuminance)
    faces = np.array([[0, 1, 2, 3]], np.uint8)
    assert kalos.surface(np.array([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]), faces, 0.3).GetNumberOfCells() == 1


def test_pandas(results):
    pandas = pytest.importorskip("pandas")
    table = results["grid"].to_pandas()
    assert isinstance(table, pandas.DataFrame) and list(table) == list(results["grid"].as_dict())
    assert len(table) == 6 and table.attrs["method"] == "compensated" and table["valid"].sum() == 5


def test_xarray(results):
    pytest.importorskip("xarray")
    grid, points, image = (results[name].to_xarray() for name in ("grid", "points", "image"))
    assert grid.illuminance.dims == ("row", "column") and grid.illuminance.attrs == {"units": "lx"}
    assert grid.x.dims == ("column",) and grid.y.dims == ("row",) and grid.z.dims == () and grid.x.attrs == {"units": "m"}
    assert float(grid.illuminance.sel(row=1, column=2)) == results["grid"].illuminance[1, 2]
    assert grid.attrs["trajectories"] == results["grid"].trajectories and len(grid.attrs["warnings"]) == 1
    assert points.illuminance.dims == ("point",) and points.bands.dims == ("point", "band")
    assert image.luminance.attrs == {"units": "cd/m2"} and image.sizes == {"row": 3, "column": 4, "band": 3}


@pytest.mark.parametrize("values, dims", [
    (np.zeros((2, 3)), ()), (np.arange(6.0).reshape(2, 3), ("row", "column")),
    (np.tile([[1.0], [2.0]], (1, 3)), ("row",)), (np.tile([1.0, 2, 3], (2, 1)), ("column",))])
def test_dimensions_that_change_nothing_are_dropped(values, dims):
    found, kept = reduced(("row", "column"), values)
    assert found == dims and kept.ndim == len(dims)
