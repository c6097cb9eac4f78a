# SPDX-License-Identifier: BSD-3-Clause
"""Updates without the interpreter's lock, so that other Python threads continue."""
import ctypes
import functools

from kalos.errors import failed, plain, warn

CALLBACK = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_double, ctypes.c_char_p)
PROGRESS, ERROR = 0, 1


@functools.lru_cache(maxsize=None)
def library():
    """The library of the estimating filters, with the function of UnblockedUpdate.cxx."""
    from kalos.vtk import vtkKalosFiltersEstimation

    found = ctypes.CDLL(vtkKalosFiltersEstimation.__file__)
    found.kalosUpdateUnblocked.argtypes = (ctypes.c_void_p, CALLBACK)
    found.kalosUpdateUnblocked.restype = None
    return found


def update_unblocked(algorithm, progress):
    """As kalos.errors.update() for a vtkKalosEstimatorAlgorithm; progress(fraction) is called as it goes on, and must not raise."""
    messages = []

    def event(kind, fraction, text):
        if kind == PROGRESS:
            progress(fraction)
        else:
            (messages.append if kind == ERROR else warn)(plain(decoded(text)))

    address = int(algorithm.__this__.split("_")[1], 16)
    library().kalosUpdateUnblocked(address, CALLBACK(event))
    failed(algorithm, messages)


def decoded(text):
    """None for what is not UTF-8, as VTK's wrapping has it."""
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError:
        return None
