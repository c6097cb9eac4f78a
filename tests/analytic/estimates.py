# SPDX-License-Identifier: BSD-3-Clause
"""Scenes built in memory, estimates of them, and the comparison of two estimates."""
import json

import numpy as np

from kalos.core.options import Options
from kalos.validation.validate import solve_receivers
from kalos.validation.verdicts import FALSE_ALARM, allowed_deviation

BOX = {"center": [3.3, 1.7, 0.75], "size": [1.5, 1.5, 1.5], "rotation_z_deg": -17}
PROBES = np.array([(1.0, 1.0, 0.0, 0, 0, 1), (1.5, 3.5, 0.0, 0, 0, 1), (4.0, 4.0, 0.0, 0, 0, 1), (0.0, 2.0, 2.0, 1, 0, 0),
                   (5.0, 3.0, 1.5, -1, 0, 0), (2.0, 5.0, 2.5, 0, -1, 0), (3.3, 1.7, 1.5, 0, 0, 1), (2.0, 2.0, 5.0, 0, 0, -1),
                   (3.77, 2.58, 0.0, 0, 0, 1)])  # the last would be in the box, were it turned the other way


def room(material="grey"):
    """Six quads of a room of 5 m with a box in it, normals inwards."""
    def quad(name, origin, u, v):
        return {"name": name, "quad": {"origin": origin, "u": u, "v": v}, "material": material}

    return [quad("floor", [0, 0, 0], [5, 0, 0], [0, 5, 0]), quad("ceiling", [0, 0, 5], [0, 5, 0], [5, 0, 0]),
            quad("left", [0, 0, 0], [0, 5, 0], [0, 0, 5]), quad("right", [5, 0, 0], [0, 0, 5], [0, 5, 0]),
            quad("front", [0, 0, 0], [0, 0, 5], [5, 0, 0]), quad("back", [0, 5, 0], [5, 0, 0], [0, 0, 5]),
            {"name": "box", "box": dict(BOX), "material": material}]


def lamp(position=(2.0, 3.0, 4.0), aim=(0.3, -0.2, -1), flux=10000.0, distribution="lambertian", name="lamp"):
    return {"name": name, "position": list(position), "aim": list(aim), "flux": flux, "distribution": distribution}


def scene(surfaces, luminaires, reflectance=0.5):
    return {"kalos": 1, "materials": {"grey": {"reflectance": reflectance}}, "surfaces": surfaces, "luminaires": luminaires}


def solve(folder, description, probes=PROBES, trajectories=64000, seed=1, **options):
    """Receivers with the estimates at probes (n, 6): points and normals."""
    rows = "".join(",".join(repr(float(x)) for x in row) + "\n" for row in probes)
    (folder / "probe.csv").write_text("x,y,z,nx,ny,nz\n" + rows)
    (folder / "scene.json").write_text(json.dumps({**description, "receivers": [{"name": "probe", "points": "probe.csv"}]}))
    print(f"seed {seed}, {trajectories} trajectories")
    receivers, = solve_receivers(folder / "scene.json", Options(trajectories=trajectories, seed=seed, **options))
    return receivers


def agree(a, b, factor=1.0, false_alarm=FALSE_ALARM):
    """Asserts that two independent estimates differ by `factor` only, but for the given chance, over all points.

    Their difference has the standard error hypot(a, b); Student's t with the degrees of freedom of one is wide enough.
    """
    error = np.hypot(a.standard_error, b.standard_error * factor)
    deviation = np.abs(a.illuminance - factor * b.illuminance) / error
    assert deviation.max() <= allowed_deviation(len(deviation), false_alarm), deviation
    assert (error / a.illuminance).max() < 0.03, "too noisy to tell anything"
