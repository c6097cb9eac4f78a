#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads every model (OBJ, glTF) under some folders as a scene and counts what was refused and what was noted; by hand.

    PYTHONPATH=build/python tests/filters/real_models.py FOLDER...

Archives of Sweet Home 3D (.sh3f: Debian's sweethome3d-furniture) are looked into. A model that is refused, or that has no
faces, makes the exit status 1.
"""
import argparse
import re
import sys
import tempfile
import zipfile
from collections import Counter
from pathlib import Path

from kalos.vtk import vtkKalosSceneReader
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkObject

SUFFIXES = {".obj", ".gltf", ".glb"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    options = parser.parse_args()
    vtkObject.GlobalWarningDisplayOff()
    models, refused, noted = 0, Counter(), Counter()
    with tempfile.TemporaryDirectory() as unpacked:
        for archive in sorted(path for folder in options.folders for path in folder.rglob("*.sh3f")):
            zipfile.ZipFile(archive).extractall(Path(unpacked) / archive.stem)
        for path in sorted(path for folder in (*options.folders, Path(unpacked)) for path in folder.rglob("*")
                           if path.suffix.lower() in SUFFIXES):
            models += 1
            error, subjects = read(path)
            noted.update(subjects)
            if error:
                refused[re.sub(r"[\d.]+", "#", error)] += 1
                print(f"refused: {path}: {error}", flush=True)
    print(f"{models} models, {models - sum(refused.values())} read, {sum(refused.values())} refused")
    for title, counts in (("models with a note of", noted), ("refused for", refused)):
        for what, count in counts.most_common():
            print(f"{count:5} {title} {what}")
    return 1 if refused or not models else 0


def read(path):
    """Why a model is refused, or None, and the subjects of what was noted."""
    reader = vtkKalosSceneReader()
    reader.SetFileName(str(path))
    messages = []

    def collect(caller, event, message):
        messages.append(message.split("): ", 1)[-1].strip().replace(f"{path}: ", ""))

    collect.CallDataType = VTK_STRING
    reader.AddObserver("ErrorEvent", collect)
    vtkObject.GlobalWarningDisplayOn()
    reader.Update()
    vtkObject.GlobalWarningDisplayOff()
    surfaces = reader.GetSurfaces()
    if messages or surfaces.GetNumberOfCells() == 0:
        return messages[0] if messages else "no faces", []
    notes = surfaces.GetFieldData().GetAbstractArray("SceneNotes")
    return None, {notes.GetValue(i) for i in range(0, notes.GetNumberOfValues(), 3)} if notes else []


sys.exit(main())
