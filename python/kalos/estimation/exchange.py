# SPDX-License-Identifier: BSD-3-Clause
"""Results handed on: as bytes to pickle, and to pandas and xarray, where these are installed."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCharArray
from vtkmodules.vtkParallelCore import vtkCommunicator


def marshalled(dataset):
    """A VTK data object as its class and bytes."""
    buffer = vtkCharArray()
    if not vtkCommunicator.MarshalDataObject(dataset, buffer):
        raise TypeError(f"{dataset.GetClassName()} cannot be pickled")
    return type(dataset), vtk_to_numpy(buffer).tobytes()


def unmarshalled(state):
    """The VTK data object that was marshalled(). VTK makes its own class of images, which is copied into the right one."""
    kind, data = state
    buffer = vtkCharArray()
    buffer.SetNumberOfValues(len(data))
    vtk_to_numpy(buffer).view(np.uint8)[:] = np.frombuffer(data, np.uint8)
    dataset = kind()
    dataset.ShallowCopy(vtkCommunicator.UnMarshalDataObject(buffer))
    return dataset


def provenance(result):
    return {"method": result.method, "seed": result.seed, "trajectories": result.trajectories}


def to_pandas(result):
    import pandas

    table = pandas.DataFrame({name: np.array(column) for name, column in result.as_dict().items()})
    table.attrs.update(provenance(result))
    return table


def illuminance_to_xarray(result):
    dims = ("row", "column") if result.points.ndim == 3 else ("point",)
    found = {name: (dims, np.array(getattr(result, name)), {"units": "lx"}) for name in ("illuminance", "standard_error", "direct")}
    found.update({name: (dims, np.array(getattr(result, name))) for name in ("trusted", "valid")})
    if result.bands is not None:
        found["bands"] = ((*dims, "band"), np.array(result.bands), {"units": "lx"})
    coords = {}
    for axis, name in enumerate("xyz"):
        coords[name] = (*reduced(dims, result.points[..., axis]), {"units": "m"})
        coords[f"n{name}"] = reduced(dims, result.normals[..., axis])
    return dataset(result, found, coords)


def luminance_to_xarray(result):
    dims, unit = ("row", "column"), {"units": "cd/m2"}
    found = {name: (dims, np.array(getattr(result, name)), unit) for name in ("luminance", "standard_error")}
    if result.bands is not None:
        found["bands"] = ((*dims, "band"), np.array(result.bands), unit)
    return dataset(result, found, {})


def dataset(result, found, coords):
    import xarray

    return xarray.Dataset(found, coords, {**provenance(result), "warnings": result.warnings})


def reduced(dims, values):
    """Dimensions and values without those dimensions that nothing changes along; the one of a list of points stays."""
    for axis in reversed(range(values.ndim if len(dims) > 1 else 0)):
        first = values.take([0], axis)
        if np.array_equal(np.broadcast_to(first, values.shape), values):
            values, dims = first.squeeze(axis), dims[:axis] + dims[axis + 1:]
    return dims, np.array(values)
