# SPDX-License-Identifier: BSD-3-Clause
"""One of the ranks of pvbatch fails before the solve: pvbatch_failing.py Kalos.so SOURCE_DIRECTORY script|reader."""
import sys

import paraview.simple as pv
from vtkmodules.vtkParallelCore import vtkMultiProcessController

plugin, source, what = sys.argv[1:]
pv.LoadPlugin(plugin, remote=False, ns=pv.__dict__)
failing = vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1
if failing and what == "script":
    raise ZeroDivisionError("by hand")
here = "/nowhere" if failing else f"{source}/data/cornell"
scene = pv.KalosSceneReader(FileName=f"{here}/cornell-empty.json")
plane = pv.KalosCalculationPlane(Origin=[0, 0, 0.75], U=[5, 0, 0], V=[0, 5, 0], Resolution=[6, 5])
lux = pv.KalosIlluminance(Receivers=plane, Surfaces=pv.OutputPort(scene, 0), Luminaires=pv.OutputPort(scene, 1), Trajectories=320)
lux.UpdatePipeline()
