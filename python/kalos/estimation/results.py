# SPDX-License-Identifier: BSD-3-Clause
"""What an estimate gives back: NumPy arrays on VTK's memory, with the data set they come from and the audit."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Optional

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData

from kalos.results.statistics import statistics
from kalos.results.text import number


class Result:
    """What illuminance and luminance have in common: a line for print()."""

    def __repr__(self) -> str:
        return f"<{type(self).__name__.lower()}: {self.facts()}>"

    def facts(self) -> str:
        values, error, unit = self.summary_of()
        figures = statistics(values.ravel(), error.ravel())
        worst = figures["largest_relative_standard_error"]
        return (f"{' x '.join(map(str, values.shape))} values, mean {number(figures['mean'])} {unit}, "
                f"min {number(figures['min'])}, max {number(figures['max'])}, largest standard error "
                f"{'-' if worst is None else f'{100 * worst:.2g} %'}; {self.trajectories} trajectories of {self.method}")


@dataclass(frozen=True, repr=False, eq=False)
class Illuminance(Result):
    """Illuminance at points; the arrays have the shape of the points without the last axis.

    The arrays of values are views of `vtk`'s arrays: they stay valid as long as any of them is held.
    """

    points: np.ndarray  #: (..., 3) m, as given
    normals: np.ndarray  #: (..., 3)
    illuminance: np.ndarray  #: (...) lx
    standard_error: np.ndarray  #: (...) lx, from the spread of independent replicates
    direct: np.ndarray  #: (...) lx, straight from the emitters
    trusted: np.ndarray  #: (...) bool, whether the standard error can be believed
    bands: Optional[np.ndarray]  #: (..., b) lx, where the materials have b > 1 bands
    trajectories: int
    method: str
    seed: int
    seconds: float  #: s, of the solve itself
    cpu_seconds: float  #: s
    audit: List[Dict[str, str]]  #: what was modelled and why: subject, choice, reason
    vtk: vtkDataSet  #: vtkStructuredGrid of a grid of points, else vtkPolyData, with the arrays of vtkKalosIlluminance

    def as_dict(self) -> Dict[str, np.ndarray]:
        """Columns of length n, named as in the command's tables: pandas.DataFrame(result.as_dict()) is one row a point."""
        x, y, z = self.points.reshape(-1, 3).T
        nx, ny, nz = self.normals.reshape(-1, 3).T
        return {"x": x, "y": y, "z": z, "nx": nx, "ny": ny, "nz": nz, "illuminance_lx": self.illuminance.ravel(),
                "standard_error_lx": self.standard_error.ravel(), "direct_lx": self.direct.ravel(),
                "trusted": self.trusted.ravel()}

    def summary_of(self):
        return self.illuminance, self.standard_error, "lx"

    def _repr_png_(self) -> bytes:
        from kalos.pictures.notebook import illuminance_png  # Matplotlib is loaded when a picture is wanted

        return illuminance_png(self)


@dataclass(frozen=True, repr=False, eq=False)
class Luminance(Result):
    """Luminance of the pixels of an image, (rows, columns), the first row at the top."""

    luminance: np.ndarray  #: (rows, columns) cd/m2, 0 where nothing is seen
    standard_error: np.ndarray  #: (rows, columns) cd/m2
    bands: Optional[np.ndarray]  #: (rows, columns, b) cd/m2, where the materials have b > 1 bands
    trajectories: int
    method: str
    seed: int
    seconds: float  #: s, of the solve itself
    cpu_seconds: float  #: s
    audit: List[Dict[str, str]]  #: what was modelled and why: subject, choice, reason
    vtk: vtkImageData  #: the image, row 0 at the bottom, with the arrays of vtkKalosLuminanceImage

    def as_dict(self) -> Dict[str, np.ndarray]:
        """Columns of length rows x columns: pandas.DataFrame(result.as_dict()) is one row a pixel, top row first."""
        row, column = np.indices(self.luminance.shape)
        return {"row": row.ravel(), "column": column.ravel(), "luminance_cd_m2": self.luminance.ravel(),
                "standard_error_cd_m2": self.standard_error.ravel()}

    def summary_of(self):
        return self.luminance, self.standard_error, "cd/m²"

    def _repr_png_(self) -> bytes:
        from kalos.pictures.notebook import luminance_png

        return luminance_png(self)
