# SPDX-License-Identifier: BSD-3-Clause
"""An output folder that receives all its files at the end, or none; and the files of VTK in it."""
import contextlib
import json
import os
import shutil
import tempfile
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from kalos.errors import KalosError, update


@contextlib.contextmanager
def staged(folder):
    """Yields a temporary folder beside `folder` (inside, when it exists); its files move in when the block succeeds.

    Moving within one file system replaces each file at once, so that a reader never meets half of one. A folder that
    cannot be written is a KalosError before the block is entered.
    """
    folder = Path(folder)
    made = []
    try:
        for missing in reversed([p for p in (folder, *folder.parents) if not p.exists()]):
            missing.mkdir()
            made.append(missing)
        staging = Path(tempfile.mkdtemp(prefix=".kalos-", dir=folder))
    except OSError as error:
        remove(made)
        raise KalosError(f"{folder}: --out: cannot be written ({error.strerror}), expected a folder to write into") from None
    done = False
    try:
        yield staging
        for file in sorted(staging.iterdir()):
            os.replace(file, folder / file.name)
        done = True
    except OSError as error:
        raise KalosError(f"{folder}: --out: cannot be written ({error.strerror}), expected a folder to write into") from None
    finally:
        shutil.rmtree(staging, ignore_errors=True)
        if not done:
            remove(made)


def remove(folders):
    """Takes the new, still empty folders away again."""
    for folder in reversed(folders):
        with contextlib.suppress(OSError):
            folder.rmdir()


def write_vtp(path, dataset):
    """A vtkPolyData as a file that every VTK reads."""
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()  # raw appended data: VTK 9.2 cannot read it with expat 2.5.0-1+deb12u2 and later
    writer.SetInputData(dataset)
    update(writer, writer.Write)


def write_json(path, content):
    path.write_text(json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
