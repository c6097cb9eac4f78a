# SPDX-License-Identifier: BSD-3-Clause
"""What an estimate gives back: NumPy arrays on VTK's memory, with the data set they come from and the audit."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData

from kalos.estimation.exchange import marshalled, to_pandas, unmarshalled
from kalos.results.fields import warnings_of
from kalos.results.statistics import statistics
from kalos.results.text import number

if TYPE_CHECKING:  # they need not be installed
    import pandas
    import xarray


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class Result:
    """How an estimate was made. Results can be pickled and copied; a copy has a data set of its own."""

    trajectories: int
    method: str
    seed: int
    seconds: float
    cpu_seconds: float
    audit: List[Dict[str, str]]
    vtk: vtkDataSet

    @property
    def warnings(self) -> List[str]:
        """What the audit warns of, a line each."""
        return warnings_of(self.audit)

    def __repr__(self) -> str:
        lines = [f"<{type(self).__name__.lower()}: {self.facts()}>", *(f"warning: {line}" for line in self.warnings)]
        return "\n".join(lines)

    def facts(self) -> str:
        """Mean, extremes and largest error in one line."""
        values, error, valid, unit = self._values()
        figures = statistics(values[valid], error[valid])
        worst = figures["largest_relative_standard_error"]
        left_out = "" if valid.all() else f"{int((~valid).sum())} left out, "
        return (f"{' x '.join(map(str, values.shape))} values, {left_out}mean {number(figures['mean'])} {unit}, "
                f"min {number(figures['min'])}, max {number(figures['max'])}, largest standard error "
                f"{'-' if worst is None else f'{100 * worst:.2g} %'}; {self.trajectories} trajectories of {self.method}")

    def to_pandas(self) -> pandas.DataFrame:
        """as_dict() as a pandas.DataFrame; its attrs tell method, seed and trajectories."""
        return to_pandas(self)

    def as_dict(self) -> Dict[str, np.ndarray]:
        raise NotImplementedError

    def _values(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray, str]:
        raise NotImplementedError

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "vtk": marshalled(self.vtk)}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state, vtk=unmarshalled(state["vtk"]))


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class Illuminance(Result):
    """Illuminance at points; the arrays have the shape of the points without the last axis, here (...).

    points: (..., 3), m, as given. normals: (..., 3), unit vectors.
    illuminance: (...), lx. standard_error: (...), lx, from the spread of independent replicates.
    direct: (...), lx, the part that comes straight from the emitters.
    trusted: (...), bool, whether the standard error can be believed.
    valid: (...), bool, False where no light is in sight, inside a solid, below a surface or outside; statistics leave it out.
    bands: (..., b), lx, where the materials have b > 1 bands, else None.
    trajectories: how many were traced. method, seed: as asked for. seconds, cpu_seconds: s, of the solve itself.
    audit: what was modelled and why, a list of {subject, choice, reason}; `warnings` has its warnings.
    vtk: the data set, a vtkStructuredGrid of a grid of points, else vtkPolyData, with the arrays of vtkKalosIlluminance.

    The arrays of values are views of the arrays of `vtk`: they stay valid as long as any of them is held.
    """

    points: np.ndarray
    normals: np.ndarray
    illuminance: np.ndarray
    standard_error: np.ndarray
    direct: np.ndarray
    trusted: np.ndarray
    valid: np.ndarray
    bands: Optional[np.ndarray]

    def as_dict(self) -> Dict[str, np.ndarray]:
        """Columns of length n, named as in the command's tables: pandas.DataFrame(result.as_dict()) is one row a point."""
        x, y, z = self.points.reshape(-1, 3).T
        nx, ny, nz = self.normals.reshape(-1, 3).T
        return {"x": x, "y": y, "z": z, "nx": nx, "ny": ny, "nz": nz, "illuminance_lx": self.illuminance.ravel(),
                "standard_error_lx": self.standard_error.ravel(), "direct_lx": self.direct.ravel(),
                "trusted": self.trusted.ravel(), "valid": self.valid.ravel()}

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset with dimensions row and column of a grid of points, else point; units are in the attrs.

        A coordinate that changes along one dimension only has that dimension: a plane that follows the axes has x(column)
        and y(row).
        """
        from kalos.estimation.exchange import illuminance_to_xarray

        return illuminance_to_xarray(self)

    def _values(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray, str]:
        return self.illuminance, self.standard_error, self.valid, "lx"

    def _repr_png_(self) -> bytes:
        from kalos.pictures.notebook import illuminance_png  # Matplotlib is loaded when a picture is wanted

        return illuminance_png(self)


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class Luminance(Result):
    """Luminance of the pixels of an image, (rows, columns), the first row at the top.

    luminance: (rows, columns), cd/m2, 0 where nothing is seen. standard_error: (rows, columns), cd/m2.
    bands: (rows, columns, b), cd/m2, where the materials have b > 1 bands, else None.
    trajectories: how many were traced. method, seed: as asked for. seconds, cpu_seconds: s, of the solve itself.
    audit: what was modelled and why, a list of {subject, choice, reason}; `warnings` has its warnings.
    vtk: the image, a vtkImageData with row 0 at the bottom, with the arrays of vtkKalosLuminanceImage.
    """

    vtk: vtkImageData
    luminance: np.ndarray
    standard_error: np.ndarray
    bands: Optional[np.ndarray]

    def as_dict(self) -> Dict[str, np.ndarray]:
        """Columns of length rows x columns: pandas.DataFrame(result.as_dict()) is one row a pixel, top row first."""
        row, column = np.indices(self.luminance.shape)
        return {"row": row.ravel(), "column": column.ravel(), "luminance_cd_m2": self.luminance.ravel(),
                "standard_error_cd_m2": self.standard_error.ravel()}

    def to_xarray(self) -> xarray.Dataset:
        """An xarray.Dataset with dimensions row, from the top, and column; units are in the attrs."""
        from kalos.estimation.exchange import luminance_to_xarray

        return luminance_to_xarray(self)

    def _values(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray, str]:
        return self.luminance, self.standard_error, np.ones(self.luminance.shape, bool), "cd/m²"

    def _repr_png_(self) -> bytes:
        from kalos.pictures.notebook import luminance_png

        return luminance_png(self)
