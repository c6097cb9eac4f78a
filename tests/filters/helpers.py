# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the VTK layer share: errors of an algorithm, small scenes."""
import json

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.util.vtkConstants import VTK_STRING

# Errors are collected below; the executive's echo of them is noise.
vtkObject.GlobalWarningDisplayOff()


def update_error(algorithm):
    """Update and return the one error message, without VTK's file, line and address; None if there is no error.

    Global warning display off would also silence the events, so it is on meanwhile."""
    messages = []

    def collect(caller, event, message):
        messages.append(message)

    collect.CallDataType = VTK_STRING
    observers = [(o, o.AddObserver("ErrorEvent", collect)) for o in (algorithm, algorithm.GetExecutive())]
    vtkObject.GlobalWarningDisplayOn()
    try:
        algorithm.Write() if hasattr(algorithm, "Write") else algorithm.Update()
    finally:
        vtkObject.GlobalWarningDisplayOff()
        for o, tag in observers:
            o.RemoveObserver(tag)
    return messages[0].split("): ", 1)[1].strip() if messages else None


def minimal_scene():
    """The smallest scene that has one of everything; a test changes what it is about."""
    return {
        "kalos": 1,
        "materials": {"white": {"reflectance": 0.7}},
        "surfaces": [
            {"name": "floor", "quad": {"origin": [0, 0, 0], "u": [4, 0, 0], "v": [0, 3, 0]}, "material": "white"}],
        "luminaires": [
            {"name": "lamp", "position": [2, 1, 3], "aim": [0, 0, -2], "flux": 1000, "distribution": "lambertian"}],
        "receivers": [
            {"name": "desk", "plane": {"origin": [0, 0, 0.75], "u": [4, 0, 0], "v": [0, 3, 0], "resolution": [4, 3]}}],
        "cameras": [
            {"name": "front", "position": [2, -4, 1], "target": [2, 2, 1], "fov_deg": 45, "resolution": [16, 9]}],
    }


def write_scene(folder, scene):
    path = folder / "scene.json"
    if isinstance(scene, dict):
        scene = json.dumps(scene)
    path.write_bytes(scene if isinstance(scene, bytes) else scene.encode())
    return str(path)
