# SPDX-License-Identifier: BSD-3-Clause
"""False colours: the table, ranges, scales, associations."""
import math

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet

from helpers import update_error
from kalos.vtk import vtkKalosFalseColor


def image_of(values, name="Illuminance", cells=False):
    image = vtkImageData()
    image.SetDimensions(len(values) + cells, 1 + cells, 1)
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    (image.GetCellData() if cells else image.GetPointData()).AddArray(array)
    return image


def make(data, **settings):
    false_color = vtkKalosFalseColor()
    false_color.SetInputData(data)
    for name, value in settings.items():
        getattr(false_color, "Set" + name)(value)
    return false_color


def colors_of(data):
    return vtk_to_numpy(data.GetArray("FalseColor")).tolist()


def table():
    lookup = vtkKalosFalseColor().GetLookupTable()
    return np.array([lookup.GetTableValue(i)[:3] for i in range(lookup.GetNumberOfTableValues())])


def oklab(rgb):
    """Ottosson's Oklab, written out here apart from the code it judges."""
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    lms = linear @ np.array([[0.4122214708, 0.5363325363, 0.0514459929],
                             [0.2119034982, 0.6806995451, 0.1073969566],
                             [0.0883024619, 0.2817188376, 0.6299787005]]).T
    return np.cbrt(lms) @ np.array([[0.2104542553, 0.7936177850, -0.0040720468],
                                    [1.9779984951, -2.4285922050, 0.4505937099],
                                    [0.0259040371, 0.7827717662, -0.8086757660]]).T


def test_table_is_perceptually_uniform():
    colors = oklab(table())
    assert len(colors) == 256
    # Every 15th colour, as vtkLookupTable rounds to 8 bits, which is coarse beside one step.
    steps = np.linalg.norm(np.diff(colors[::15], axis=0), axis=1)
    assert (np.diff(colors[::15, 0]) > 0).all()
    assert steps.max() / steps.min() < 1.1
    # 8-bit colours must stay distinct, or the picture shows steps that are not there.
    assert len({tuple(c) for c in np.round(255 * table()).astype(int)}) == 256


def rgb(index):
    return [int(255 * c + 0.5) for c in table()[index]]


@pytest.mark.parametrize("cells", [False, True])
def test_linear_range(cells):
    false_color = make(image_of([0, 50, 100], cells=cells))
    assert update_error(false_color) is None
    output = false_color.GetOutputDataObject(0)
    colors = colors_of(output.GetCellData() if cells else output.GetPointData())
    assert [colors[0], colors[2]] == [rgb(0), rgb(255)]
    assert colors[1] in (rgb(127), rgb(128))
    assert false_color.GetUsedRange() == (0, 100)
    assert output.IsA("vtkImageData")


def test_logarithmic_range_and_zero():
    false_color = make(image_of([0, 1, 10, 100]), Scale=1)
    false_color.Update()
    colors = colors_of(false_color.GetOutputDataObject(0).GetPointData())
    assert false_color.GetUsedRange() == (1, 100)
    assert colors[0] == colors[1] == rgb(0) and colors[3] == rgb(255)
    assert colors[2] in (rgb(127), rgb(128))


def test_logarithmic_range_spans_four_decades_at_most():
    false_color = make(image_of([1e-9, 100]), Scale=1)
    false_color.Update()
    assert false_color.GetUsedRange() == pytest.approx((0.01, 100))


def test_given_range_clamps_and_nan_is_grey():
    false_color = make(image_of([-5, 10, 20, 99, math.nan, math.inf]), AutomaticRange=False, Range=(10, 20))
    false_color.Update()
    colors = colors_of(false_color.GetOutputDataObject(0).GetPointData())
    assert colors == [rgb(0), rgb(0), rgb(255), rgb(255), [128] * 3, rgb(255)]


@pytest.mark.parametrize("values, scale, used", [
    ([5, 5], 0, (0, 5)), ([0, 0], 0, (0, 1)), ([-2, -2], 0, (-2, 0)), ([math.nan], 0, (0, 1)),
    ([5, 5], 1, (0.5, 5)), ([0, 0], 1, (1, 10)), ([1, math.inf, 3], 0, (1, 3))])
def test_ranges_without_extent(values, scale, used):
    false_color = make(image_of(values), Scale=scale)
    assert update_error(false_color) is None
    assert false_color.GetUsedRange() == pytest.approx(used)


@pytest.mark.parametrize("name, unit", [
    ("Illuminance", "lx"), ("DirectIlluminance", "lx"), ("IlluminanceStandardError", "lx"), ("Luminance", "cd/m²"),
    ("LuminanceStandardError", "cd/m²"), ("Exitance", "lm/m²"), ("Temperature", "")])
def test_unit_label(name, unit):
    false_color = make(image_of([1, 2], name), ArrayName=name)
    false_color.Update()
    assert false_color.GetUnitLabel() == unit


def test_default_array_and_untouched_input():
    data = image_of([1, 2], "Luminance")
    false_color = make(data)
    false_color.Update()
    assert false_color.GetUnitLabel() == "cd/m²"
    assert false_color.GetOutputDataObject(0).GetPointData().GetNumberOfArrays() == 2
    assert data.GetPointData().GetNumberOfArrays() == 1


def test_blocks_share_a_range():
    blocks = vtkMultiBlockDataSet()
    for i, values in enumerate(([0, 1], [3, 4])):
        blocks.SetBlock(i, image_of(values))
    blocks.SetBlock(2, image_of([1], "Other"))
    false_color = make(blocks)
    assert update_error(false_color) is None
    output = false_color.GetOutputDataObject(0)
    assert false_color.GetUsedRange() == (0, 4)
    assert colors_of(output.GetBlock(0).GetPointData())[0] == rgb(0)
    assert colors_of(output.GetBlock(1).GetPointData())[1] == rgb(255)
    assert output.GetBlock(2).GetPointData().GetArray("FalseColor") is None
    assert blocks.GetBlock(0).GetPointData().GetArray("FalseColor") is None


@pytest.mark.parametrize("settings, message", [
    ({"ArrayName": "Lux"}, "no array Lux; expected it in point or cell data"),
    ({"AutomaticRange": False, "Range": (2, 2)}, "the range is 2 to 2; expected two finite numbers, the second larger"),
    ({"AutomaticRange": False, "Range": (0, math.inf)}, "the range is 0 to inf; expected two finite numbers, the second larger"),
    ({"AutomaticRange": False, "Range": (0, 2), "Scale": 1},
     "the range is 0 to 2; expected two finite numbers, the second larger, both above 0 on the logarithmic scale"),
])
def test_errors(settings, message):
    false_color = make(image_of([1, 2]), **settings)
    assert update_error(false_color) == message
    assert false_color.GetOutputDataObject(0).GetNumberOfPoints() == 0


def test_arrays_that_cannot_be_coloured():
    assert update_error(make(image_of([1, 2], "Other"))) == (
        "no array Illuminance or Luminance; expected it in point or cell data")
    assert update_error(make(image_of([[1, 2, 3]], "Luminance"))) == "the array Luminance has 3 components; expected 1"
