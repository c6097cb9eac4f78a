# SPDX-License-Identifier: BSD-3-Clause
"""The options of an estimate and how they reach the VTK filters."""
import contextlib
import dataclasses
import os
import re
from dataclasses import dataclass

from kalos.errors import KalosError

DEFAULT_METHOD = "compensated"
REFERENCE_METHOD = "compensated"  # unbiased everywhere: what studies take for the truth
REFERENCE_TRAJECTORIES = 100000
REFERENCE_SEED = 2**31 - 1  # one that no study is likely to use, so that reference and estimate are independent

# As vtkKalosIlluminance::Method numbers them.
METHODS = {"compensated": 5, "gathered": 6, "local": 0, "sphere-published": 1, "sphere-exact": 2, "disc": 3, "clamped": 4,
           "direct": 7, "paths": 8, "photon-map": 9,
           "radiosity": 10, "bidirectional": 11}


# Options of single methods, and the methods that they are for.
OWN_OPTIONS = {"photons": ("photon-map",), "cone_filter": ("photon-map",), "final_gather": ("photon-map", "radiosity"),
               "elements": ("radiosity",), "connections": ("bidirectional",)}
ELEMENTS = ("linear", "constant")

# Names for vtkKalosIlluminance::DisabledTechniques; none adds bias.
TECHNIQUES = ("stratified", "picked", "convex", "near", "paths", "neighbours", "effort", "highlights", "exact-direct")


@dataclass(frozen=True)
class Options:
    """What the command's options say; None means automatic or off."""

    method: str = DEFAULT_METHOD
    trajectories: int = None  # at most; automatic: 10 000, without limit when there is a goal
    delta: float = None  # m
    epsilon: float = None  # m
    error: float = None  # goal: relative 95 % half-width at every receiver
    error_floor: float = None  # lx, half-width that is small enough for any value; automatic: for a hundredth of the mean
    photons: int = None  # photon-map: the nearest so many; automatic: those within a radius
    cone_filter: bool = False  # photon-map: photons count less the farther they are
    final_gather: bool = False  # photon-map, radiosity: read where rays from the receivers end
    elements: str = None  # radiosity: one of ELEMENTS; automatic: linear
    connections: int = None  # bidirectional: 1 local estimates, 2 double ones, ...; automatic: all
    pixel_samples: int = 16  # lines of sight in a pixel that sees an edge
    time: float = None  # goal: s
    seed: int = 1
    threads: int = 0  # 0 for all
    disable: tuple = ()  # names of TECHNIQUES
    checkpoint: str = None  # file that the solve is kept in

    def for_another_method(self):
        """The first option that only other methods have, and these methods; None where all have an effect."""
        for name, methods in OWN_OPTIONS.items():
            if getattr(self, name) and self.method not in methods:
                return name, methods
        return None

    def of_camera(self, name):
        """The same for a camera, which has a checkpoint of its own."""
        return self if self.checkpoint is None else dataclasses.replace(self, checkpoint=f"{self.checkpoint}.{name}")

    def apply(self, estimator):
        """Sets them on vtkKalosIlluminance or vtkKalosLuminanceImage."""
        estimator.SetMethod(METHODS[self.method])
        estimator.SetTrajectories(self.trajectories or 0)
        estimator.SetDelta(self.delta or 0)
        estimator.SetEpsilon(self.epsilon or 0)
        estimator.SetPhotons(self.photons or 0)
        estimator.SetConeFilter(bool(self.cone_filter))
        estimator.SetFinalGather(bool(self.final_gather))
        estimator.SetLinearElements(self.elements != "constant")
        estimator.SetConnections(self.connections or 0)
        estimator.SetRelativeError(self.error or 0)
        estimator.SetErrorFloor(-1 if self.error_floor is None else self.error_floor)
        estimator.SetDisabledTechniques(",".join(self.disable))
        estimator.SetSeconds(self.time or 0)
        estimator.SetSeed(self.seed)
        estimator.SetThreads(self.threads)
        estimator.SetCheckpointFile(None if self.checkpoint is None else os.fspath(self.checkpoint))


@contextlib.contextmanager
def named_options(prefix="--", automatic="auto"):
    """Within, an estimator's complaint about a setting becomes one about the command's option of that name.

    The filters say `delta: is 7.5 m, expected 0 (automatic) up to ...`; the command knows automatic as `auto`, Python
    as None.
    """
    try:
        yield
    except KalosError as error:
        name, separator, rest = str(error).partition(": ")
        if not separator or name not in Options.__dataclass_fields__:
            raise
        rest = re.sub(r"(\.\d*?)0+(?= m\b)", lambda match: match[1].rstrip("."), rest)
        raise KalosError(f"{prefix}{name}: {rest.replace('expected 0 (automatic)', f'expected {automatic}, or a length')}",
                         error.status) from None
