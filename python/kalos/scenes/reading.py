# SPDX-License-Identifier: BSD-3-Clause
"""Reads scene files and models, and lists what is in them."""
import json
import os
from pathlib import Path
from typing import Any

from kalos.core import arrays
from kalos.errors import update
from kalos.scenes.model_file import MODELS, ModelFile
from kalos.vtk import vtkKalosSceneReader


def read_scene(path: Any) -> Any:
    """A vtkKalosSceneReader that has read the scene or model file: ports 0 surfaces, 1 luminaires, 2 receivers, and the cameras."""
    reader = vtkKalosSceneReader()
    reader.SetFileName(os.fspath(path))
    if isinstance(path, ModelFile):
        reader.SetModelUnit(path.unit)
        reader.SetModelUp(path.up)
    update(reader)
    return reader


def described(path, section):
    """What a scene file says of its luminaires or receivers, by name; a model's own are not described."""
    if Path(path).suffix.lower() in MODELS:
        return {}
    return {one["name"]: one for one in json.loads(Path(path).read_text(encoding="utf-8-sig")).get(section, [])}


def maintenance(path):
    """The maintenance factor of a scene file."""
    return 1.0 if Path(path).suffix.lower() in MODELS else json.loads(Path(path).read_text(encoding="utf-8-sig")).get("maintenance_factor", 1.0)


def photometry_warnings(reader):
    """The warnings of the scene's photometric files: a list of {code, file, message}."""
    table = reader.GetLuminaires().GetFieldData().GetAbstractArray(arrays.PHOTOMETRY_WARNINGS)
    cells = [table.GetValue(i) for i in range(table.GetNumberOfValues())]
    return [dict(zip(("code", "file", "message"), cells[i:i + 3])) for i in range(0, len(cells), 3)]


def receiver_names(reader):
    blocks = reader.GetReceivers()
    return [blocks.GetMetaData(i).Get(blocks.NAME()) for i in range(blocks.GetNumberOfBlocks())]


def camera_names(reader):
    return [reader.GetCameraName(i) for i in range(reader.GetNumberOfCameras())]
