# SPDX-License-Identifier: BSD-3-Clause
"""What a study solves over and over: the first camera of a scene, or its receivers when it has none."""
import hashlib
from dataclasses import dataclass, replace

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.core.progress import run
from kalos.estimation.filters import illuminance_filter, luminance_filter
from kalos.results.fields import field_value, trajectories
from kalos.results.receivers import from_dataset
from kalos.scenes.clearance import clearance, triangles
from kalos.scenes.reading import camera_names, read_scene, receiver_names
from kalos.scenes.sight import camera_rays, first_hits


@dataclass
class Estimate:
    values: np.ndarray  # cd/m2 of pixels, row 0 at the bottom; lx of receivers
    standard_error: np.ndarray
    trusted: np.ndarray  # bool, or None where the filter does not tell
    trajectories: int
    seconds: float
    cpu_seconds: float
    rays: float = None
    direct: np.ndarray = None  # lx, straight from the emitters, where the filter tells
    audit: tuple = ()  # what was modelled and why
    mean_error: float = None  # standard error of the mean over all values, over that mean, where the filter tells


class Subject:
    """The camera or the receivers of a scene file, and how far each value is from a concave edge."""

    def __init__(self, path):
        self.reader = read_scene(path)
        cameras = camera_names(self.reader)
        self.is_image = bool(cameras)
        self.name = cameras[0] if cameras else ", ".join(receiver_names(self.reader))
        self.quantity, self.unit = ("luminance", "cd/m²") if cameras else ("illuminance", "lx")
        self.receivers = []  # after the first solve, where it is not an image
        self.resolution = None

    def solve(self, options, label):
        """An estimate of all values with these options."""
        if self.is_image:
            filter_ = luminance_filter(self.reader, 0, replace(options, pixel_samples=1))  # a place each, near an edge or not
            output = run(filter_, label)
            self.resolution = output.GetDimensions()[:2]
            data = output.GetPointData()
            values, error = (vtk_to_numpy(data.GetArray(name)).astype(float)
                             for name in (arrays.LUMINANCE, arrays.LUMINANCE_STANDARD_ERROR))
            flags = data.GetArray(arrays.INTERVAL_TRUSTED)
            trusted = None if flags is None else vtk_to_numpy(flags) != 0
        else:
            output = run(illuminance_filter(self.reader, options), label)
            self.receivers = [from_dataset(name, output.GetBlock(i)) for i, name in enumerate(receiver_names(self.reader))]
            values, error, trusted = (np.concatenate([getattr(one, name) for one in self.receivers])
                                      for name in ("illuminance", "standard_error", "trusted"))
        return Estimate(values, error, trusted, trajectories(output), field_value(output, arrays.SOLVE_SECONDS),
                        field_value(output, arrays.SOLVE_CPU_SECONDS))

    def clearances(self):
        """The clearance of each value's point (m), not a number where a pixel sees nothing. After a solve."""
        faces = triangles(self.reader.GetOutputDataObject(0))
        if self.is_image:
            position, target, up = ([0.0, 0.0, 0.0] for _ in range(3))
            self.reader.GetCameraPosition(0, position)
            self.reader.GetCameraTarget(0, target)
            self.reader.GetCameraUp(0, up)
            rays = camera_rays(position, target, up, self.reader.GetCameraFieldOfView(0), self.resolution)
            points, normals = first_hits(position, rays, faces)
        else:
            points, normals = (np.concatenate([getattr(one, name) for one in self.receivers]) for name in ("points", "normals"))
        result = np.full(len(points), np.nan)
        seen = np.isfinite(points[:, 0])
        result[seen] = clearance(points[seen], normals[seen], faces)
        return result

    def digest(self, *more):
        """A hash of everything the values depend on: the scene as it was read, the camera, and `more`."""
        text = hashlib.sha256(repr(more).encode())
        blocks = self.reader.GetOutputDataObject(2)
        datasets = [self.reader.GetOutputDataObject(0), self.reader.GetOutputDataObject(1)]
        datasets += [] if self.is_image else [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]
        for dataset in datasets:
            for i in range(dataset.GetNumberOfPoints()):
                text.update(repr(dataset.GetPoint(i)).encode())
            for i in range(dataset.GetNumberOfCells()):
                ids = dataset.GetCell(i).GetPointIds()
                text.update(repr([ids.GetId(k) for k in range(ids.GetNumberOfIds())]).encode())
            for data in (dataset.GetPointData(), dataset.GetCellData()):
                for i in range(data.GetNumberOfArrays()):
                    array = data.GetArray(i)
                    if array is not None:  # names do not shine
                        text.update(data.GetArrayName(i).encode() + vtk_to_numpy(array).tobytes())
        if self.is_image:
            filter_ = luminance_filter(self.reader, 0, None)
            text.update(repr([filter_.GetPosition(), filter_.GetTarget(), filter_.GetUp(), filter_.GetFieldOfView(),
                              filter_.GetResolution()]).encode())
        return text.hexdigest()[:16]
