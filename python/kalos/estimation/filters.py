# SPDX-License-Identifier: BSD-3-Clause
"""The filters that estimate a scene that a vtkKalosSceneReader has read."""
from kalos.vtk import vtkKalosIlluminance, vtkKalosLuminanceImage


def illuminance_filter(reader, options):
    """The filter that estimates all receiver sets of the scene."""
    estimator = vtkKalosIlluminance()
    estimator.TellWarningsOff()  # who asks reads them in the audit
    estimator.KeepReplicatesOn()  # for the errors of means and ratios
    estimator.SetInputConnection(0, reader.GetOutputPort(2))
    estimator.SetInputConnection(1, reader.GetOutputPort(0))
    estimator.SetInputConnection(2, reader.GetOutputPort(1))
    if options:
        options.apply(estimator)
    return estimator


def luminance_filter(reader, index, options):
    """The filter that estimates what camera `index` of the scene sees."""
    estimator = vtkKalosLuminanceImage()
    estimator.TellWarningsOff()
    estimator.SetInputConnection(0, reader.GetOutputPort(0))
    estimator.SetInputConnection(1, reader.GetOutputPort(1))
    for get, put in ((reader.GetCameraPosition, estimator.SetPosition), (reader.GetCameraTarget, estimator.SetTarget),
                     (reader.GetCameraUp, estimator.SetUp)):
        vector = [0.0, 0.0, 0.0]
        get(index, vector)
        put(vector)
    resolution = [0, 0]
    reader.GetCameraResolution(index, resolution)
    estimator.SetResolution(resolution)
    estimator.SetFieldOfView(reader.GetCameraFieldOfView(index))
    if options:
        options.of_camera(reader.GetCameraName(index)).apply(estimator)
        estimator.SetPixelSamples(options.pixel_samples)
    return estimator
