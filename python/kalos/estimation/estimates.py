# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance and luminance of scenes in memory, from NumPy arrays or VTK data, without a file."""
from __future__ import annotations

import os
import pathlib
from typing import Any, Callable, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid

from kalos.core import arrays
from kalos.core.limits import checked_options
from kalos.core.options import DEFAULT_METHOD, named_options
from kalos.core.progress import watch
from kalos.core.sharing import shared
from kalos.errors import BAD_INPUT, InputError, Interrupted, KalosError
from kalos.estimation.results import Illuminance, Luminance
from kalos.results.fields import audit, field_value, trajectories
from kalos.scenes.checks import non_empty, numbers, units
from kalos.scenes.geometry import poly_data
from kalos.scenes.joined import Luminaires, Surfaces, joined_luminaires, joined_surfaces
from kalos.vtk import vtkKalosIlluminance, vtkKalosLuminanceImage

Progress = Union[None, bool, Callable[[float], None]]


def illuminance(surfaces: Surfaces, luminaires: Luminaires, points: ArrayLike, normals: ArrayLike, *,
                error: Optional[float] = None, error_floor: Optional[float] = None, time: Optional[float] = None,
                trajectories: Optional[int] = None, method: str = DEFAULT_METHOD, delta: Optional[float] = None,
                epsilon: Optional[float] = None, method_options: Optional[Mapping[str, Any]] = None, seed: int = 1,
                threads: int = 0, checkpoint: Union[None, str, os.PathLike] = None, progress: Progress = None) -> Illuminance:
    """Illuminance (lx) at points, with a standard error each.

    surfaces, luminaires: vtkPolyData, or lists of them, as kalos.surface(), quad(), box(), luminaire() and panel() make, or
    vtkKalosSceneReader reads; luminaires may be None where surfaces emit.
    points: (n, 3), or (rows, columns, 3) for a grid, m. normals: of the same shape, or (3,) for all; unit vectors to the
    side that is lit. NumPy arrays are shared with VTK, not copied: C-contiguous, float64 or float32.
    error: stop when every 95 % half-width is within this part of its value, such as 0.01, or below error_floor, lx; None is that
    part of a hundredth of the mean. time: stop after so many seconds.
    trajectories: at most so many; without a goal 10 000. method: as `kalos solve --method`; the default, compensated (local
    estimation, Kalos 1963, with gathering near edges), is unbiased, also at edges. delta, epsilon: m, of the methods with a
    neighbourhood (Budak et al., GraphiCon 2023); None is automatic. method_options: what single methods let one choose, as the
    command's options of these names, such as {"photons": 50} for method="photon-map". seed: the same one gives the same numbers, bit by
    bit, for any number of threads. threads: 0 for all.
    checkpoint: a file that the solve is kept in every 10 s and when it is interrupted; the same call goes on from there to bitwise
    the same numbers, and takes the file away when it is done.
    progress: True for a bar on standard error, or a function that is called with a fraction from 0 to 1; what it raises
    ends the solve and is raised again.

    Raises InputError, a ValueError, for arguments without meaning; Interrupted, a KeyboardInterrupt, on Ctrl-C: its
    attribute `partial` holds the result so far; KalosError for other failures.

    >>> import numpy as np
    >>> room = box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
    >>> lamp = luminaire((2, 2, 2.9), 3000)
    >>> desk = np.array([[1.0, 2.0, 0.75], [2.0, 2.0, 0.75]])
    >>> result = illuminance(room, lamp, desk, (0, 0, 1), error=0.003)
    >>> result.illuminance.shape, bool((1.96 * result.standard_error < 0.003 * result.illuminance).all())
    ((2,), True)
    >>> sorted(result.as_dict())[:3]
    ['direct_lx', 'illuminance_lx', 'nx']
    """
    options = checked_options(method=method, trajectories=trajectories, error=error, error_floor=error_floor, time=time, delta=delta,
                              epsilon=epsilon, method_options=method_options, seed=seed, threads=threads,
                              checkpoint=checkpoint)
    points = non_empty("points", numbers("points", points, [("n", 3), ("rows", "columns", 3)]))
    normals = units("normals", normals, [points.shape, (3,)])
    if normals.ndim == 1:
        normals = np.ascontiguousarray(np.broadcast_to(normals, points.shape))
    filter_ = vtkKalosIlluminance()
    filter_.TellWarningsOff()  # they are in the result
    filter_.SetInputData(0, receivers(points, normals))
    filter_.SetInputData(1, joined_surfaces(surfaces))
    filter_.SetInputData(2, joined_luminaires(luminaires))
    return run(filter_, options, progress, arrays.ILLUMINANCE, lambda output: read_illuminance(output, points, normals, options))


def read_illuminance(output, points, normals, options):
    """The result of a filter at points of this shape."""
    data, shape = output.GetPointData(), points.shape[:-1]
    bands = data.GetArray(arrays.ILLUMINANCE_BANDS)
    values = {key: vtk_to_numpy(data.GetArray(name)).reshape(shape)
              for key, name in (("illuminance", arrays.ILLUMINANCE), ("standard_error", arrays.ILLUMINANCE_STANDARD_ERROR),
                                ("direct", arrays.DIRECT_ILLUMINANCE))}
    flags = {key: vtk_to_numpy(data.GetArray(name)).view(bool).reshape(shape)
             for key, name in (("trusted", arrays.INTERVAL_TRUSTED), ("valid", arrays.VALID))}
    return Illuminance(points=points, normals=normals, **values, **flags,
                       bands=bands and vtk_to_numpy(bands).reshape(*shape, -1), **solved(output, options))


def luminance(surfaces: Surfaces, luminaires: Luminaires, position: ArrayLike, target: ArrayLike, *,
              up: ArrayLike = (0, 0, 1), fov_deg: float = 45, resolution: Tuple[int, int] = (256, 256), pixel_samples: int = 16,
              error: Optional[float] = None, error_floor: Optional[float] = None, time: Optional[float] = None,
              trajectories: Optional[int] = None, method: str = DEFAULT_METHOD, delta: Optional[float] = None,
              epsilon: Optional[float] = None, method_options: Optional[Mapping[str, Any]] = None, seed: int = 1,
              threads: int = 0, checkpoint: Union[None, str, os.PathLike] = None, progress: Progress = None) -> Luminance:
    """Luminance (cd/m2) seen by a camera, with a standard error per pixel, by the double local estimate.

    position, target: (3,), m. up: (3,). fov_deg: vertical field of view, degrees. resolution: columns and rows.
    pixel_samples: lines of sight in a pixel that sees an edge; others have one through their centre. Without
    trajectories and without a goal, 1024 trajectories. The other arguments, and what is raised, as for illuminance().

    >>> room = box((2, 2, 1.5), (4, 4, 3), 0.5, inwards=True)
    >>> picture = luminance(room, luminaire((2, 2, 2.9), 3000), (2, 0.1, 1.5), (2, 4, 1.5), resolution=(16, 12))
    >>> picture.luminance.shape
    (12, 16)
    """
    options = checked_options(method=method, trajectories=trajectories, error=error, error_floor=error_floor, time=time, delta=delta,
                              epsilon=epsilon, method_options=method_options, seed=seed, threads=threads,
                              checkpoint=checkpoint, pixel_samples=pixel_samples)
    filter_ = vtkKalosLuminanceImage()
    filter_.SetPixelSamples(options.pixel_samples)
    filter_.TellWarningsOff()
    filter_.SetInputData(0, joined_surfaces(surfaces))
    filter_.SetInputData(1, joined_luminaires(luminaires))
    for name, value, put in (("position", position, filter_.SetPosition), ("target", target, filter_.SetTarget),
                             ("up", up, filter_.SetUp)):
        put(numbers(name, value, [(3,)]).tolist())
    filter_.SetFieldOfView(float(numbers("fov_deg", fov_deg, [()])))
    filter_.SetResolution(numbers("resolution", resolution, [(2,)], (np.int64, np.int32)).tolist())

    def read(output):
        columns, rows, _ = output.GetDimensions()
        data = output.GetPointData()
        bands = data.GetArray(arrays.LUMINANCE_BANDS)
        values, error = (vtk_to_numpy(data.GetArray(name)).reshape(rows, columns)[::-1]
                         for name in (arrays.LUMINANCE, arrays.LUMINANCE_STANDARD_ERROR))
        return Luminance(luminance=values, standard_error=error,
                         bands=bands and vtk_to_numpy(bands).reshape(rows, columns, -1)[::-1], **solved(output, options))

    return run(filter_, options, progress, arrays.LUMINANCE, read)


def receivers(points, normals):
    """Points as vtkPolyData, a grid of them as vtkStructuredGrid, on the arrays' own memory."""
    if points.ndim == 2:
        dataset = poly_data(points)
    else:
        dataset, places = vtkStructuredGrid(), vtkPoints()
        dataset.SetDimensions(points.shape[1], points.shape[0], 1)
        places.SetData(shared(points.reshape(-1, 3)))
        dataset.SetPoints(places)
    dataset.GetPointData().SetNormals(shared(normals.reshape(-1, 3), "Normals"))
    return dataset


def run(filter_, options, progress, quantity, read):
    """Solves and returns read(output); the filter's complaints about input become InputError."""
    options.apply(filter_)
    try:
        with named_options("", "None"):
            stopped = watch(filter_, progress, quantity.lower())
    except KalosError as error:
        raise InputError(str(error)) if error.status == BAD_INPUT else error from None
    output = filter_.GetOutputDataObject(0)
    if stopped:
        raise Interrupted(read(output) if output.GetPointData().HasArray(quantity) else None)
    if options.checkpoint is not None:
        pathlib.Path(options.checkpoint).unlink(missing_ok=True)
    return read(output)


def solved(output, options):
    """How it was solved, as the results name it."""
    return {"trajectories": trajectories(output), "method": options.method, "seed": options.seed,
            "seconds": field_value(output, arrays.SOLVE_SECONDS),
            "cpu_seconds": field_value(output, arrays.SOLVE_CPU_SECONDS), "audit": audit(output),
            "vtk": output}
