# SPDX-License-Identifier: BSD-3-Clause
"""The estimating filters: their inputs, outputs and every error message."""
import math

import numpy as np
import pytest
from helpers import update_error
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_OBJECT
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData

from kalos.core.options import TECHNIQUES
from kalos.vtk import vtkKalosCalculationPlane, vtkKalosIlluminance, vtkKalosLuminaireSource, vtkKalosLuminanceImage

NAN = math.nan
BOX = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (0, 0, 3), (4, 0, 3), (4, 4, 3), (0, 4, 3)]
FACES = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]


def surfaces(points=BOX, **arrays):
    """A closed room of six quads with these cell arrays; Reflectance 0.5 unless given as None."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.SetPolys(vtkCellArray())
    for p in points:
        data.GetPoints().InsertNextPoint(p)
    for face in FACES:
        data.GetPolys().InsertNextCell(4, face)
    for name, values in {"Reflectance": 0.5, **arrays}.items():
        if values is not None:
            values = np.broadcast_to(np.asarray(values, float), (6, *np.shape(values)[1:])).copy()
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            data.GetCellData().AddArray(array)
    return data


def probe(normal=(0, 0, 1), points=((1, 1, 1), (3, 2, 1))):
    """Point receivers with point normals, or without."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for p in points:
        data.GetPoints().InsertNextPoint(p)
    if normal is not None:
        normals = numpy_to_vtk(np.tile(np.asarray(normal, float), (len(points), 1)), deep=True)
        data.GetPointData().SetNormals(normals)
    return data


def lamp(**settings):
    source = vtkKalosLuminaireSource()
    source.SetPosition(2, 2, 2.9)
    source.SetFlux(1000)
    for name, value in settings.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def shortened(data, name=None):
    """With one value less in the array of that name, or in the normals."""
    of_points, of_cells = data.GetPointData(), data.GetCellData()
    array = (of_points.GetArray(name) or of_cells.GetArray(name)) if name else of_points.GetNormals()
    array.SetNumberOfTuples(array.GetNumberOfTuples() - 1)
    return data


def estimator(receivers=None, room=None, lights=None, **settings):
    filter = vtkKalosIlluminance()
    filter.SetInputData(0, receivers if receivers is not None else probe())
    filter.SetInputData(1, room if room is not None else surfaces())
    filter.SetInputData(2, lights if lights is not None else lamp())
    for name, value in {"Trajectories": 320, **settings}.items():
        getattr(filter, "Set" + name)(value)
    return filter


def test_point_normals_give_point_data_and_cell_normals_cell_data():
    plane = vtkKalosCalculationPlane()
    plane.SetOrigin(0, 0, 0.75)
    plane.SetU(4, 0, 0)
    plane.SetV(0, 4, 0)
    plane.SetResolution(3, 2)
    plane.Update()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, plane.GetOutput())
    blocks.SetBlock(1, probe())
    filter = estimator(blocks)
    assert update_error(filter) is None
    output = filter.GetOutputDataObject(0)
    assert output.IsA("vtkMultiBlockDataSet")
    cells, points = output.GetBlock(0).GetCellData(), output.GetBlock(1).GetPointData()
    for data, count in ((cells, 6), (points, 2)):
        for name in ("Illuminance", "IlluminanceStandardError", "DirectIlluminance", "LargestScoreShare", "IntervalTrusted"):
            assert data.GetArray(name).GetNumberOfTuples() == count
        assert not data.HasArray("KernelCorrection") and not data.HasArray("IlluminanceBands")
        assert vtk_to_numpy(data.GetArray("Illuminance")).min() > vtk_to_numpy(data.GetArray("DirectIlluminance")).min() > 0
    fields = output.GetFieldData()
    assert fields.GetArray("Trajectories").GetValue(0) == 320
    assert fields.GetAbstractArray("Audit").GetNumberOfComponents() == 3
    assert not plane.GetOutput().GetCellData().HasArray("Illuminance"), "the input is left alone"


def test_altered_kernels_report_their_correction():
    filter = estimator(Method=vtkKalosIlluminance.CLAMPED, Delta=2)
    assert update_error(filter) is None
    correction = vtk_to_numpy(filter.GetOutputDataObject(0).GetPointData().GetArray("KernelCorrection"))
    assert correction.min() < 0 and correction.max() <= 0, "a clamp only removes"


def test_bands_are_weighed_to_the_photometric_total():
    filter = estimator(room=surfaces(Reflectance=[[0.8, 0.5, 0.1]]))
    assert update_error(filter) is None
    data = filter.GetOutputDataObject(0).GetPointData()
    bands = vtk_to_numpy(data.GetArray("IlluminanceBands"))
    assert (np.diff(bands) < 0).all(), "red is reflected most"
    np.testing.assert_allclose(vtk_to_numpy(data.GetArray("Illuminance")), bands @ [0.2126, 0.7152, 0.0722], rtol=1e-6)


def test_progress_rises_and_abort_stops():
    told = []

    def watch(caller, event):
        told.append(caller.GetProgress())
        if len(told) == 3:
            caller.SetAbortExecute(1)

    filter = estimator(Trajectories=0, Seconds=30)
    filter.AddObserver("ProgressEvent", watch)
    filter.Update()
    assert told == sorted(told)
    output = filter.GetOutputDataObject(0)
    assert output.GetFieldData().GetAbstractArray("SolveSeconds").GetValue(0) < 15
    audit = output.GetFieldData().GetAbstractArray("Audit")
    assert "stopped" in [audit.GetValue(i) for i in range(0, audit.GetNumberOfValues(), 3)]
    assert output.GetPointData().HasArray("Illuminance"), "the rounds that were complete"


def test_intermediate_results_lead_to_the_last_one():
    shown = []

    def keep(caller, event, result):
        data = result.GetPointData()
        shown.append((result.GetFieldData().GetArray("Trajectories").GetValue(0),
                      vtk_to_numpy(data.GetArray("Illuminance")).copy()))

    keep.CallDataType = VTK_OBJECT
    filter = estimator(Trajectories=3200, IntermediateResults=True)
    filter.AddObserver("UpdateDataEvent", keep)
    assert update_error(filter) is None
    trajectories = [count for count, _ in shown]
    assert trajectories[0] == 8 and trajectories[-1] == 3200 and len(trajectories) > 8
    result = vtk_to_numpy(filter.GetOutputDataObject(0).GetPointData().GetArray("Illuminance"))
    assert (shown[-1][1] == result).all() and not (shown[0][1] == result).any()


def test_image_has_the_arrays_and_the_size():
    image = vtkKalosLuminanceImage()
    image.SetInputData(0, surfaces())
    image.SetInputData(1, lamp())
    image.SetPosition(2, 0.5, 1.5)
    image.SetTarget(2, 3, 1.5)
    image.SetResolution(6, 4)
    image.SetTrajectories(320)
    assert update_error(image) is None
    output = image.GetOutputDataObject(0)
    assert output.GetDimensions() == (6, 4, 1)
    luminance = vtk_to_numpy(output.GetPointData().GetArray("Luminance"))
    assert luminance.min() > 0 and output.GetPointData().HasArray("LuminanceStandardError")
    trusted = vtk_to_numpy(output.GetPointData().GetArray("IntervalTrusted"))
    assert len(trusted) == len(luminance) and set(trusted) <= {0, 1} and trusted.mean() > 0.5


def test_image_shows_itself_while_it_is_refined():
    shown = []

    def keep(caller, event, result):
        shown.append(vtk_to_numpy(result.GetPointData().GetArray("Luminance")).copy())

    keep.CallDataType = VTK_OBJECT
    image = vtkKalosLuminanceImage()
    image.SetInputData(0, surfaces())
    image.SetInputData(1, lamp())
    image.SetPosition(2, 0.5, 1.5)
    image.SetTarget(2, 3, 1.5)
    image.SetResolution(6, 4)
    image.SetTrajectories(320)
    image.IntermediateResultsOn()
    image.AddObserver("UpdateDataEvent", keep)
    assert update_error(image) is None
    result = vtk_to_numpy(image.GetOutputDataObject(0).GetPointData().GetArray("Luminance"))
    assert len(shown) > 3 and (shown[-1] == result).all() and not (shown[0] == result).any()


def test_a_kept_scene_serves_other_receivers_and_notices_changes():
    room = surfaces()
    filter = estimator(room=room, Trajectories=320, KeepScene=True)
    illuminance = []
    for change in (lambda: None, lambda: filter.SetSeed(2), lambda: filter.SetSeed(1),
                   lambda: (room.GetCellData().GetArray("Reflectance").Fill(0.1),
                            room.GetCellData().GetArray("Reflectance").Modified())):
        change()
        assert update_error(filter) is None
        data = filter.GetOutputDataObject(0).GetPointData()
        illuminance.append(vtk_to_numpy(data.GetArray("Illuminance")).copy())
    first, other_seed, again, darker = illuminance
    assert (first == again).all() and (first != other_seed).any()
    assert (darker < first).all()


@pytest.mark.parametrize("change, message", [
    (dict(receivers=probe(None)), "receivers: have no normals, expected point normals or cell normals"),
    (dict(receivers=probe((0, 0, 0))), "receivers: normal 0 has no direction, expected a unit vector"),
    (dict(receivers=probe(points=[(NAN, 0, 0)])), "receiver 0: coordinates must be finite"),
    (dict(room=surfaces(Reflectance=None)), "surfaces: the cell array Reflectance is missing"),
    (dict(room=surfaces(Reflectance=1)), "Reflectance of cell 0: is 1.000000, expected a number in [0, 1)"),
    (dict(room=surfaces(Reflectance=NAN)), "Reflectance of cell 0: is nan, expected a number in [0, 1)"),
    (dict(room=surfaces(Reflectance=[[0.1] * 17])), "Reflectance: has 17 components, expected at most 16"),
    (dict(room=surfaces(Reflectance=[[0.1] * 3], Exitance=[[1.0] * 2])), "Exitance: has 2 components, expected 1 or 3"),
    (dict(room=surfaces(Exitance=-1)), "Exitance of cell 0: is -1.000000, expected a number in [0, infinity)"),
    (dict(room=surfaces(Specular=0.5)), "Reflectance of cell 0: with Specular and Mirror must sum to less than 1"),
    (dict(room=surfaces(Specular=2)), "Specular of cell 0: is 2.000000, expected a number from 0 to 1"),
    (dict(room=surfaces(Specular=0.1, Roughness=0)),
     "Roughness of cell 0: is 0, expected a number in (0, 1]; use Mirror for a perfect mirror"),
    (dict(room=surfaces([(0, 0, 0)] * 8)),
     "surfaces: polygons worth 12 triangles have no area or cross themselves, expected simple polygons"),
    (dict(room=vtkPolyData(), lights=vtkPolyData()),
     "surfaces: no triangles and no luminaires, there is nothing to estimate"),
    (dict(room=shortened(surfaces(), "Reflectance")), "Reflectance: has 5 tuples, expected one for each of the 6 surface cells"),
    (dict(lights=shortened(lamp(), "LuminousFlux")), "LuminousFlux: has 0 tuples, expected one for each of the 1 luminaires"),
    (dict(receivers=shortened(probe())),
     "an array without a name: has 1 tuples, expected one for each of the 2 receiver points"),
    (dict(lights=probe()), "luminaires: the point array LuminousFlux is missing"),
    (dict(Method=99), "method: does not exist"),
    (dict(Trajectories=-1), "trajectories: must be 0 (automatic) or more"),
    (dict(RelativeError=1), "error: must lie in [0, 1)"),
    (dict(DisabledTechniques="picked,walls"), "disable: 'walls' is not a technique, expected some of " + ", ".join(TECHNIQUES)),
    (dict(Seconds=-1), "time: must be 0 (no limit) or more seconds"),
    (dict(Threads=-1), "threads: must be 0 (all) or more"),
    (dict(Delta=-1), "delta: is -1.000000 m, expected 0 (automatic) up to the size of the scene, 4.000000 m"),
    (dict(Epsilon=5), "epsilon: is 5.000000 m, expected 0 (automatic) up to the size of the scene, 4.000000 m"),
])
def test_bad_input_is_refused(change, message):
    filter = estimator(**change)
    assert update_error(filter) == message
    assert filter.GetOutputDataObject(0).GetNumberOfPoints() == 0
