# SPDX-License-Identifier: BSD-3-Clause
"""The results of one receiver set as NumPy arrays."""
from dataclasses import dataclass
from typing import Any, Optional

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

from kalos.core import arrays
from kalos.errors import FAILED, KalosError
from kalos.results.statistics import statistics


@dataclass
class Receivers:
    """Receivers in their order: points of the data set, or centres of its cells."""

    name: str
    dataset: object  # vtkDataSet with the result arrays
    points: np.ndarray  # (n, 3) m
    normals: np.ndarray  # (n, 3)
    illuminance: np.ndarray  # lx
    standard_error: np.ndarray  # lx
    direct: np.ndarray  # lx
    trusted: np.ndarray  # bool: whether the standard error can be believed
    valid: np.ndarray  # bool: False inside a solid, below a surface or outside; statistics leave these out
    weights: np.ndarray  # areas of the cells, m2, or ones: what a mean over the set weighs by
    replicates: Optional[np.ndarray] = None  # (n, replicates) lx: independent estimates, of which illuminance is the mean
    daylight_factor: Optional[np.ndarray] = None  # %, only under a sky
    goal: np.ndarray = None  # what results.statistics.goal() counts; only where a goal for the error was set

    def statistics(self, everywhere=False):
        """The figures of statistics.statistics() over the valid receivers, or over all of them, and how many were left out."""
        chosen = np.ones_like(self.valid) if everywhere else self.valid
        found = statistics(self.illuminance[chosen], self.standard_error[chosen], self.weights[chosen],
                           None if self.replicates is None else self.replicates[chosen])
        return {**found, "points": len(chosen), "left_out": int((~chosen).sum())}

    @property
    def cells(self):
        """Whether the receivers are the cells of the data set."""
        return self.dataset.GetCellData().HasArray(arrays.ILLUMINANCE) == 1


def from_dataset(name: str, dataset: Any) -> Any:
    """Reads the output of vtkKalosIlluminance."""
    of_points, of_cells = dataset.GetPointData(), dataset.GetCellData()
    data = of_cells if of_cells.HasArray(arrays.ILLUMINANCE) else of_points
    if not data.HasArray(arrays.ILLUMINANCE):
        raise KalosError(f"{name}: the estimate holds no {arrays.ILLUMINANCE}", FAILED)
    if data is of_cells:
        points = cell_centres(dataset)
        weights = areas(dataset)
    else:
        points = np.array([dataset.GetPoint(i) for i in range(dataset.GetNumberOfPoints())], float).reshape(-1, 3)
        weights = np.ones(len(points))
    read = [vtk_to_numpy(data.GetArray(key)).astype(float)
            for key in (arrays.ILLUMINANCE, arrays.ILLUMINANCE_STANDARD_ERROR, arrays.DIRECT_ILLUMINANCE)]
    trusted, valid = (vtk_to_numpy(data.GetArray(key)) != 0 for key in (arrays.INTERVAL_TRUSTED, arrays.VALID))
    replicates = data.GetArray(arrays.ILLUMINANCE_REPLICATES)
    if replicates:  # used for the errors of means; not written to files
        replicates = vtk_to_numpy(replicates).reshape(len(points), -1)
        data.RemoveArray(arrays.ILLUMINANCE_REPLICATES)
    goal = vtk_to_numpy(data.GetArray(arrays.GOAL_STATUS)) if data.HasArray(arrays.GOAL_STATUS) else None
    daylight = vtk_to_numpy(data.GetArray(arrays.DAYLIGHT_FACTOR)) if data.HasArray(arrays.DAYLIGHT_FACTOR) else None
    return Receivers(name, dataset, points, vtk_to_numpy(data.GetNormals()).astype(float), *read, trusted, valid, weights, replicates,
                     daylight, goal)


def point_receivers(points: Any, normals: Any) -> vtkPolyData:
    """A vtkPolyData that asks for the illuminance at points (n, 3) of surfaces with unit normals (n, 3)."""
    dataset, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(np.array(points, float), deep=True))
    dataset.SetPoints(places)
    array = numpy_to_vtk(np.array(normals, float), deep=True)
    array.SetName("Normals")
    dataset.GetPointData().SetNormals(array)
    return dataset


def cell_centres(dataset):
    centres = vtkCellCenters()
    centres.SetInputData(dataset)
    centres.Update()
    return vtk_to_numpy(centres.GetOutput().GetPoints().GetData()).astype(float)


def areas(dataset):
    """Areas of the cells, or ones where a cell has no area."""
    size = vtkCellSizeFilter()
    size.SetInputData(dataset)
    size.ComputeVertexCountOff()
    size.ComputeLengthOff()
    size.ComputeVolumeOff()
    size.Update()
    area = vtk_to_numpy(size.GetOutput().GetCellData().GetArray("Area")).astype(float)
    return area if (area > 0).all() else np.ones(len(area))
