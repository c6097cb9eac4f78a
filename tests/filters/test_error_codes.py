# SPDX-License-Identifier: BSD-3-Clause
"""GetErrorCode() of filters that fail: UserError for bad input; NoError again when they succeed."""
import pytest
from test_estimation import lamp, probe, surfaces
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from kalos.vtk import vtkKalosGlareRating, vtkKalosIlluminance, vtkKalosLuminanceImage


def estimate(cls, *inputs, **settings):
    filter_ = cls()
    filter_.AddObserver("ErrorEvent", lambda *_: None)
    filter_.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    for name, value in settings.items():
        getattr(filter_, "Set" + name)(value)
    for port, data in enumerate(inputs):
        filter_.SetInputData(port, data)
    filter_.Update()
    return filter_


def illuminance(*inputs, **settings):
    return estimate(vtkKalosIlluminance, *inputs, Trajectories=64, **settings)


def image(*inputs, **settings):
    return estimate(vtkKalosLuminanceImage, *inputs, Trajectories=64, Resolution=(4, 4), Position=(1, 1, 1), Target=(2, 1, 1), **settings)


BAD = {
    "no reflectance": lambda: illuminance(probe(), surfaces(Reflectance=None), lamp()),
    "a reflectance of 1": lambda: illuminance(probe(), surfaces(Reflectance=1.0), lamp()),
    "no normals": lambda: illuminance(probe(normal=None), surfaces(), lamp()),
    "a normal without direction": lambda: illuminance(probe(normal=(0, 0, 0)), surfaces(), lamp()),
    "a neighbourhood too wide": lambda: illuminance(probe(), surfaces(), lamp(), Method=vtkKalosIlluminance.CLAMPED, Delta=100.0),
    "a checkpoint that cannot be": lambda: illuminance(probe(), surfaces(), lamp(), CheckpointFile="/dev/null/none"),
    "an image without reflectance": lambda: image(surfaces(Reflectance=None), lamp()),
    "an image with a wrong name": lambda: image(surfaces(), lamp(), DisabledTechniques="walls"),
    "observers without results": lambda: estimate(vtkKalosGlareRating, probe(), surfaces(), lamp()),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input(case):
    assert BAD[case]().GetErrorCode() == vtkErrorCode.UserError


def test_success_after_failure():
    filter_ = BAD["no reflectance"]()
    filter_.SetInputData(1, surfaces())
    filter_.Update()
    assert filter_.GetErrorCode() == vtkErrorCode.NoError


@pytest.mark.parametrize("told", [True, False])
@pytest.mark.parametrize("cls", [vtkKalosIlluminance, vtkKalosLuminanceImage])
def test_warnings_of_the_audit_are_events(cls, told):
    """As VTK's and ParaView's output windows show them: here of a white floor on a black one."""
    floors = vtkAppendPolyData()
    for reflectance in (0.0, 0.7):
        floors.AddInputData(surfaces(Reflectance=reflectance))
    floors.Update()
    filter_ = cls()
    filter_.SetTellWarnings(told)
    filter_.SetTrajectories(64)
    if cls is vtkKalosIlluminance:
        filter_.SetInputData(0, probe())
        filter_.SetInputData(1, floors.GetOutput())
        filter_.SetInputData(2, lamp())
    else:
        filter_.SetInputData(0, floors.GetOutput())
        filter_.SetInputData(1, lamp())
    found = []

    def collect(caller, event, message):
        found.append(message)

    collect.CallDataType = VTK_STRING
    filter_.AddObserver("WarningEvent", collect)
    vtkObject.GlobalWarningDisplayOn()
    filter_.Update()
    vtkObject.GlobalWarningDisplayOff()
    assert any("lies on" in text for text in found) == told
