# SPDX-License-Identifier: BSD-3-Clause
"""The commands as functions: kalos.solve(), study(), chart() and validate(). Their modules are imported when they are called."""
from __future__ import annotations

import os
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Union

from kalos.core.limits import checked_options
from kalos.core.options import DEFAULT_METHOD, REFERENCE_TRAJECTORIES, named_options
from kalos.errors import InputError
from kalos.pictures.look import LOOK, Look
from kalos.scenes.scene import Scene, scene_file

SceneLike = Union[Scene, str, "os.PathLike[str]"]
Say = Callable[[str], object]


def silent(line: str) -> None:
    """Ignores a line of output."""


def solve(scene: SceneLike, out: Union[str, os.PathLike[str]], *, method: str = DEFAULT_METHOD, trajectories: Optional[int] = None,
          error: Optional[float] = None, error_floor: Optional[float] = None, time: Optional[float] = None,
          delta: Optional[float] = None, epsilon: Optional[float] = None, method_options: Optional[Mapping[str, Any]] = None,
          seed: int = 1, threads: int = 0, pixel_samples: int = 16, disable: Sequence[str] = (), prepare: bool = True, report: bool = False, hdr: bool = False, all_points: bool = False,
          look: Look = LOOK, say: Say = silent) -> Dict[str, Any]:
    """Solves a scene into the folder `out`, as `kalos solve` does; returns what stands in its summary.json.

    scene: a kalos.Scene, or the path of a scene file or model. delta, epsilon: m; error_floor: lx; time: s. method_options: those of single
    methods, such as {"photons": 50} for photon-map. prepare: repair the
    surfaces first. pixel_samples: lines of sight in a pixel that sees an edge. report: write report.html. hdr: write Radiance pictures. all_points: count receivers inside solids in the
    statistics. look: range, kind of scale and colours of the pictures. say: gets the lines that the command prints. `kalos solve --help` tells more of each. Raises KalosError.
    """
    from kalos.solving.solve import solve as run

    options = checked_options(method=method, trajectories=trajectories, error=error, error_floor=error_floor, time=time, delta=delta,
                              epsilon=epsilon, method_options=method_options, seed=seed, threads=threads, disable=disable,
                              pixel_samples=pixel_samples)
    with scene_file(scene) as path:
        return run(path, out, options, say, prepare, report, hdr, all_points, look)


def study(scene: SceneLike, out: Union[str, os.PathLike[str]], sweep: Mapping[str, Sequence[Any]], *, method: str = DEFAULT_METHOD,
          trajectories: Optional[int] = None, delta: Optional[float] = None, epsilon: Optional[float] = None,
          method_options: Optional[Mapping[str, Any]] = None, seed: int = 1, threads: int = 0, reference_trajectories: int = REFERENCE_TRAJECTORIES, say: Say = silent) -> Dict[str, Any]:
    """Solves a scene with every combination of settings and measures errors and biases, as `kalos study` does.

    sweep: values of trajectories, delta (m), epsilon (m), method or seed, such as {"trajectories": [100, 1000]}; None is
    automatic. Returns what stands in study.json.
    """
    from kalos.studies.study import study as run
    from kalos.studies.sweep import combinations

    options = checked_options(method=method, trajectories=trajectories, delta=delta, epsilon=epsilon,
                              method_options=method_options, seed=seed, threads=threads)
    swept = []
    for name, values in sweep.items():
        if name not in ("trajectories", "delta", "epsilon", "method", "seed"):
            raise InputError(f"sweep: {name!r} is not allowed, expected trajectories, delta, epsilon, method or seed")
        swept.append((name, tuple(getattr(checked_options(**{name: value}), name) for value in values)))
    with scene_file(scene) as path, named_options("", "None"):
        return run(path, out, combinations(swept, options), reference_trajectories, say)


def chart(scene: SceneLike, out: Union[str, os.PathLike[str]], *, receivers: Optional[str] = None, camera: Optional[str] = None,
          methods: Optional[Sequence[str]] = None, peers: Sequence[str] = (), relative_to: str = "value", budget: float = 60.0,
          reference_trajectories: int = REFERENCE_TRAJECTORIES, seed: int = 1, threads: int = 1, say: Say = silent) -> Dict[str, Any]:
    """Measures the error of methods and peers against processor time, as `kalos chart` does; returns what stands in chart.json.

    receivers, camera: the name of the set or the camera to measure. methods: None for all. peers: other programs, out of
    mitsuba, radiance and radiance-cached. relative_to: "value" or "mean". budget: s of processor time each.
    """
    from kalos.charts.chart import chart as run

    with scene_file(scene) as path:
        return run(path, out, receivers, methods, tuple(peers), relative_to, budget, reference_trajectories, seed, threads, say,
                   camera)


def validate(*, methods: Optional[Sequence[str]] = None, trajectories: Optional[int] = None, seed: int = 1,
             data: Union[None, str, os.PathLike[str]] = None, say: Say = print) -> bool:
    """Tests methods (None: all) on scenes with a closed form, as `kalos validate` does; returns whether all pass."""
    from kalos.validation.validate import validate as run

    return bool(run(data, methods, trajectories, seed, say))
