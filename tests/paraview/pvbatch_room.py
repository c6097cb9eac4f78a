# SPDX-License-Identifier: BSD-3-Clause
"""A solve by all ranks of pvbatch, or of a pvserver at localhost:PORT; the first or the client writes the values it fetched.

    pvbatch_room.py Kalos.so SOURCE_DIRECTORY FILE [PORT]
"""
import sys

import numpy as np
import paraview.simple as pv
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

plugin, source, path, *port = sys.argv[1:]
if port:
    pv.Connect("127.0.0.1", int(port[0]))
    pv.LoadPlugin(plugin, remote=True, ns=pv.__dict__)
pv.LoadPlugin(plugin, remote=False, ns=pv.__dict__)
scene = pv.KalosSceneReader(FileName=f"{source}/data/cornell/cornell-empty.json")
plane = pv.KalosCalculationPlane(Origin=[0, 0, 0.75], U=[5, 0, 0], V=[0, 5, 0], Resolution=[6, 5])
ports = {"Surfaces": pv.OutputPort(scene, 0), "Luminaires": pv.OutputPort(scene, 1)}
lux = pv.KalosIlluminance(Receivers=plane, Trajectories=320, Threads=1, **ports)
view = pv.KalosLuminanceImage(Trajectories=320, Threads=1, Resolution=[9, 8], Position=[2.5, -6, 2.5], Target=[2.5, 2.5, 2.5],
                              **ports)
lux.UpdatePipeline()
view.UpdatePipeline()
values, pixels = servermanager.Fetch(lux), servermanager.Fetch(view)
if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0:
    audit = values.GetFieldData().GetAbstractArray("Audit")
    np.savez(path, lux=vtk_to_numpy(values.GetCellData().GetArray("Illuminance")),
             luminance=vtk_to_numpy(pixels.GetPointData().GetArray("Luminance")),
             ranks=[audit.GetValue(i) for i in range(audit.GetNumberOfValues()) if "processes" in audit.GetValue(i)])
