# SPDX-License-Identifier: BSD-3-Clause
"""Checks of array arguments: they are used without a copy, or refused by name with their shape and what is expected."""
from __future__ import annotations

import numpy as np

from kalos.errors import InputError

FLOATS = (np.float64, np.float32)
INTEGERS = (np.int64, np.int32)
UNIT_TOLERANCE = 1e-4  # relative, of the length of a normal: allows rounding of typed digits, not a missing normalisation


def refuse(name, array, what, expected):
    raise InputError(f"{name}: has shape {array.shape}{what}, expected {expected}")


def numbers(name, value, shapes, types=FLOATS) -> np.ndarray:
    """`value` as an array of one of the `shapes`, tuples of sizes and of letters that stand for any size.

    NumPy arrays of `types` are not copied, so they must be C-contiguous; other integers, lists and numbers are converted.
    Raises InputError, which is a ValueError.
    """
    wanted = " or ".join("(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")" for shape in shapes)
    given = isinstance(value, np.ndarray) and not (value.dtype.kind in "iu" and value.dtype not in types)
    array = value if given else converted(name, value, wanted, types[0])
    if not any(fits(array.shape, shape) for shape in shapes):
        refuse(name, array, "", wanted)
    if array.dtype not in types:
        refuse(name, array, f" and dtype {array.dtype}", " or ".join(np.dtype(kind).name for kind in types))
    if not array.flags.c_contiguous:
        refuse(name, array, " and is not C-contiguous", f"numpy.ascontiguousarray({name})")
    finite = np.isfinite(array)
    if not finite.all():
        place = tuple(int(i) for i in np.argwhere(~finite)[0])
        refuse(name, array, f" and is {array[place]} at {list(place)}", "finite numbers")
    return array


def converted(name, value, wanted, kind):
    try:
        array = np.asarray(value)
        if array.dtype.kind not in ("iuf" if kind is np.float64 else "iu"):
            raise ValueError
        return np.ascontiguousarray(array, kind).reshape(array.shape)
    except (ValueError, TypeError):
        raise InputError(f"{name}: is not an array of numbers, expected one with shape {wanted}") from None


def fits(shape, wanted):
    return len(shape) == len(wanted) and all(isinstance(w, str) or s == w for s, w in zip(shape, wanted))


def units(name, value, shapes) -> np.ndarray:
    """As numbers(), of vectors of length 1."""
    array = numbers(name, value, shapes)
    lengths = np.linalg.norm(array, axis=-1)
    wrong = np.argwhere(np.abs(lengths - 1) > UNIT_TOLERANCE)
    if len(wrong):
        place = tuple(int(i) for i in wrong[0])
        refuse(name, array, f" and length {lengths[place]:.6g} at {list(place)}", "unit vectors")
    return array


def within(name, array, low, below, expected) -> np.ndarray:
    """The array, when all of it lies in [low, below)."""
    wrong = np.argwhere(~((array >= low) & (array < below)))
    if len(wrong):
        place = tuple(int(i) for i in wrong[0])
        refuse(name, array, f" and is {array[place]:g} at {list(place)}", expected)
    return array


def non_empty(name, array) -> np.ndarray:
    if array.size == 0:
        refuse(name, array, "", "at least one")
    return array
