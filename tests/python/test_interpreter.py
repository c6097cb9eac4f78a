# SPDX-License-Identifier: BSD-3-Clause
"""The wrong interpreter says so in one line: which Python and VTK are needed, which were found."""
import subprocess
import sys
from pathlib import Path

import pytest

import kalos
from kalos import _build, _interpreter

PACKAGE = Path(kalos.__file__).absolute().parents[1]
STUB = "class vtkVersion:\n    GetVTKMajorVersion = staticmethod(lambda: {})\n    GetVTKMinorVersion = staticmethod(lambda: {})\n"


def last_line(tmp_path, core):
    """What a Python says whose vtkmodules hold only this vtkCommonCore; None for no vtkmodules at all."""
    if core is not None:
        (tmp_path / "vtkmodules").mkdir()
        (tmp_path / "vtkmodules" / "__init__.py").write_text("")
        (tmp_path / "vtkmodules" / "vtkCommonCore.py").write_text(core)
    program = (f"import sys; sys.path[:] = [{str(tmp_path)!r}, {str(PACKAGE)!r}] + [p for p in sys.path if 'dist-packages' not in p "
               "and 'site-packages' not in p]; import kalos")
    ran = subprocess.run([sys.executable, "-I", "-c", program], capture_output=True, text=True, check=False)
    assert ran.returncode == 1
    line = ran.stderr.strip().splitlines()[-1]
    start = f"ImportError: kalos needs Python {_build.PYTHON} with the VTK {_build.VTK} that it was built for, and "
    assert line.startswith(start) and line.endswith("; expected the system's python3 or pvpython")
    return line


def test_no_vtk(tmp_path):
    assert "it has no usable vtkmodules (No module named 'vtkmodules')" in last_line(tmp_path, None)


def test_another_version(tmp_path):
    assert f"its VTK is 9.99, of vtkmodules.vtkCommonCore in {tmp_path}/vtkmodules" in last_line(tmp_path, STUB.format(9, 99))


def test_another_build(tmp_path):
    line = last_line(tmp_path, STUB.format(*_build.VTK.split(".")))
    assert f"its VTK {_build.VTK} in {tmp_path}/vtkmodules is of another build (" in line


def test_another_python(monkeypatch):
    monkeypatch.setattr(_interpreter, "PYTHON", "3.2")
    with pytest.raises(ImportError, match=f"kalos needs Python 3.2 .* does not fit: this is Python {_build.PYTHON}; expected"):
        _interpreter.check()


def test_the_right_one():
    assert _interpreter.check() is None
    assert _build.VTK.count(".") == 1 and _build.PYTHON.count(".") == 1
