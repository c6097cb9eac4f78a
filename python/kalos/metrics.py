# SPDX-License-Identifier: BSD-3-Clause
"""Cylindrical and semi-cylindrical illuminance: what upright faces and bodies receive (EN 12464-1, CIE 136).

Both are means of the vertical illuminance over directions about the vertical, here over ORIENTATIONS evenly spaced ones (half
of them for a half cylinder): a single small source is hit to 0.2 %, light from everywhere far better. The orientations of a
place share their trajectories; the standard error of a mean is the spread of the means of independent replicates.
"""
import numpy as np

from kalos.errors import InputError, update
from kalos.estimation.filters import illuminance_filter
from kalos.results.receivers import from_dataset, point_receivers
from kalos.results.statistics import error_of

ORIENTATIONS = 36


def cylindrical(reader, points, options):
    """Mean vertical illuminance at points (n, 3), m: (lx (n,), standard errors (n,)).

    `reader` is a vtkKalosSceneReader that has read the scene; `options` are kalos.estimator.Options.
    """
    points = places(points)
    turns = np.tile(2 * np.pi * (np.arange(ORIENTATIONS) + 0.5) / ORIENTATIONS, (len(points), 1))
    return means(reader, points, turns, options)


def semicylindrical(reader, points, directions, options):
    """Mean illuminance of the half cylinder that looks into horizontal directions (n, 3) or (3,); as cylindrical()."""
    points = places(points)
    facing = np.broadcast_to(np.asarray(directions, float), points.shape)
    flat = np.hypot(facing[:, 0], facing[:, 1])
    if not (np.isfinite(facing).all() and (flat > 0).all()):
        raise InputError(f"directions: {np.asarray(directions).tolist()} has no horizontal part, expected directions to look into")
    half = ORIENTATIONS // 2
    turns = np.arctan2(facing[:, 1], facing[:, 0])[:, None] + np.pi * ((np.arange(half) + 0.5) / half - 0.5)
    return means(reader, points, turns, options)


def places(points):
    points = np.asarray(points, float)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) == 0 or not np.isfinite(points).all():
        raise InputError(f"points: an array of shape {points.shape}, expected finite coordinates (n, 3) in metres")
    return points


def means(reader, points, turns, options):
    """Vertical illuminance of every point at its angles `turns` (n, k), averaged over them."""
    normals = np.stack([np.cos(turns), np.sin(turns), np.zeros_like(turns)], axis=-1)
    estimator = illuminance_filter(reader, options)
    estimator.SetInputDataObject(0, point_receivers(np.repeat(points, turns.shape[1], axis=0), normals.reshape(-1, 3)))
    update(estimator)
    found = from_dataset("points", estimator.GetOutputDataObject(0))
    replicates = found.replicates.reshape(*turns.shape, -1).mean(axis=1)
    return found.illuminance.reshape(turns.shape).mean(axis=1), np.array([error_of(one) for one in replicates])
