# SPDX-License-Identifier: BSD-3-Clause
"""Pipelines put together by hand, as a VTK user would."""
import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import kalos
from kalos.errors import KalosError, update


def floor(reflectance=0.5, side=10):
    source = vtkPlaneSource()
    source.SetOrigin(0, 0, 0)
    source.SetPoint1(side, 0, 0)
    source.SetPoint2(0, side, 0)
    source.Update()
    surface = source.GetOutput()
    array = numpy_to_vtk(np.array([float(reflectance)]), deep=True)
    array.SetName("Reflectance")
    surface.GetCellData().AddArray(array)
    return surface


def plane(z=1.0, flip=False):
    source = kalos.vtkKalosCalculationPlane()
    source.SetOrigin(4, 4, z)
    source.SetU(2, 0, 0)
    source.SetV(0, 2, 0)
    source.SetResolution(3, 3)
    source.SetFlip(flip)
    source.Update()
    return source.GetOutput()


def estimator(receivers, surfaces, flux=1000.0, trajectories=640):
    lamp = kalos.vtkKalosLuminaireSource()
    lamp.SetPosition(5, 5, 3)
    lamp.SetFlux(flux)
    light = kalos.vtkKalosIlluminance()
    light.SetInputData(0, receivers)
    light.SetInputData(1, surfaces)
    light.SetInputConnection(2, lamp.GetOutputPort())
    light.SetTrajectories(trajectories)
    return light


def values(dataset, name="Illuminance"):
    return vtk_to_numpy(dataset.GetCellData().GetArray(name))


def test_plane_lamp_and_floor():
    light = estimator(plane(), floor())
    update(light)
    result = light.GetOutputDataObject(0)
    assert result.GetClassName() == "vtkPolyData"
    assert values(result).shape == (9,)
    assert values(result)[4] == values(result).max()  # under the lamp
    assert result.GetFieldData().HasArray("Audit")


def test_blocks_are_solved_together_and_keep_their_order():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, plane(1.0))
    blocks.SetBlock(1, plane(2.0))
    light = estimator(blocks, floor())
    update(light)
    result = light.GetOutputDataObject(0)
    single = estimator(plane(2.0), floor())
    update(single)
    np.testing.assert_array_equal(values(result.GetBlock(1)), values(single.GetOutputDataObject(0)))
    assert values(result.GetBlock(0)).max() < values(result.GetBlock(1)).max()


def test_input_stays_as_it_was():
    receivers = plane()
    update(estimator(receivers, floor()))
    assert not receivers.GetCellData().HasArray("Illuminance")


def test_seeds_repeat_and_differ():
    solved = []
    for seed in (1, 1, 2):
        light = estimator(plane(flip=True), floor())
        light.SetSeed(seed)
        update(light)
        solved.append(values(light.GetOutputDataObject(0)).tolist())
    assert solved[0] == solved[1] != solved[2]


def test_progress_is_reported():
    light = estimator(plane(), floor(), trajectories=4000000)
    seen = []
    light.AddObserver("ProgressEvent", lambda caller, event: seen.append(caller.GetProgress()))
    update(light)
    inner = [fraction for fraction in seen if 0 < fraction < 1]  # VTK itself reports 0 and 1 around each request
    assert len(inner) >= 3 and seen[-1] == 1
    assert np.diff(inner).min() > -0.05  # threads finish their parts out of order


def test_abort_is_obeyed():
    light = estimator(plane(), floor(), trajectories=10**12)
    light.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
    light.Update()
    result = light.GetOutputDataObject(0)
    assert not (result.GetCellData().HasArray("Illuminance") and result.GetNumberOfCells())


def no_normals():
    dataset = plane()
    dataset.GetCellData().SetNormals(None)
    dataset.GetCellData().RemoveArray("Normals")
    return dataset


@pytest.mark.parametrize("light, message", [
    (lambda: estimator(no_normals(), floor()), "normals"),
    (lambda: estimator(plane(), floor(reflectance=1.0)), "eflectance"),
    (lambda: estimator(plane(), floor(reflectance=float("nan"))), "eflectance")])
def test_bad_input_is_an_error_event_and_no_output(light, message, capfd):
    filter_ = light()
    with pytest.raises(KalosError, match=message) as error:
        update(filter_)
    assert error.value.status == 2 and "\n" not in str(error.value)
    assert filter_.GetOutputDataObject(0).GetNumberOfCells() == 0
    assert capfd.readouterr().err == ""  # an error event, nothing on the screen
