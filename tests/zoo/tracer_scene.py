# SPDX-License-Identifier: BSD-3-Clause
"""A scene as the tracer sees it: triangles in a tree of boxes, materials, lamps. It reads the scene itself, not by Kalos."""
from typing import NamedTuple

import numpy as np

from kalos.scenes.lobes import TABLE, lobe_albedo

LEAF = 4  # triangles
MOST_GLOSSY = 64  # triangles on which highlights of points are estimated apart
ISOTROPIC, LAMBERTIAN, RECTANGLE, TRIANGLE = range(4)  # kinds of lamps


class Arrays(NamedTuple):
    """What the compiled functions take."""

    corner: np.ndarray  # (n, 3) of a triangle
    side_u: np.ndarray
    side_v: np.ndarray
    normal: np.ndarray  # unit
    exitance: np.ndarray
    reflectance: np.ndarray
    specular: np.ndarray
    alpha: np.ndarray
    mirror: np.ndarray
    gloss: np.ndarray  # row of `albedo`, -1 without a lobe
    emitter: np.ndarray  # lamp that a triangle is, or -1
    apart: bool  # whether highlights of lamps are estimated apart (tracer_highlights.py)
    albedo: np.ndarray  # of the lobe over the cosine
    mean_albedo: np.ndarray
    low: np.ndarray  # boxes of the tree
    high: np.ndarray
    first: np.ndarray  # first triangle of a leaf, or left child; the right one follows
    count: np.ndarray  # of triangles; 0: not a leaf
    lamp_kind: np.ndarray
    lamp_place: np.ndarray
    lamp_axis: np.ndarray
    lamp_u: np.ndarray
    lamp_v: np.ndarray
    lamp_area: np.ndarray
    lamp_flux: np.ndarray
    lamp_sum: np.ndarray  # cumulative shares of the flux
    lamp_total: float  # lm


def polygons(surface, files):
    """The faces of a surface of a scene file, each a list of corners."""
    if "quad" in surface:
        origin, u, v = (np.array(surface["quad"][key], float) for key in ("origin", "u", "v"))
        return [[origin, origin + u, origin + u + v, origin + v]]
    if "box" in surface:
        return box_faces(surface["box"])
    lines = [text.split() for text in files[surface["file"]].splitlines()]
    vertices = [np.array(one[1:4], float) for one in lines if one and one[0] == "v"]
    return [[vertices[int(i) - 1] for i in one[1:]] for one in lines if one and one[0] == "f"]


def box_faces(given):
    size, turn = np.array(given["size"], float), np.radians(given.get("rotation_z_deg", 0))
    axes = np.array([[np.cos(turn), np.sin(turn), 0], [-np.sin(turn), np.cos(turn), 0], [0, 0, 1]]) * size[:, None] / 2
    faces = []
    for k in range(3):
        for sign in (1, -1):
            u, v, middle = axes[(k + 1) % 3], sign * axes[(k + 2) % 3], np.array(given["center"], float) + sign * axes[k]
            faces.append([middle - u - v, middle + u - v, middle + u + v, middle - u + v])
    return faces


def band(value, index):
    return float(value[index]) if isinstance(value, list) else float(value)


def bands(scene):
    """How many numbers a reflectance has."""
    lists = [one[key] for one in scene["materials"].values() for key in ("reflectance", "exitance") if isinstance(one.get(key), list)]
    return len(lists[0]) if lists else 1


def read(scene, files, index=0):
    """The arrays of one band of a scene."""
    corners, rows = [], []
    for surface in scene["surfaces"]:
        material = scene["materials"][surface["material"]]
        row = [band(material.get("exitance", 0), index), band(material["reflectance"], index), material.get("specular", 0),
               max(1e-4, material.get("roughness", 0) ** 2), material.get("mirror", 0)]
        for face in polygons(surface, files):
            for second, third in zip(face[1:], face[2:]):
                if np.linalg.norm(np.cross(second - face[0], third - face[0])) > 0:
                    corners.append([face[0], second, third])
                    rows.append(row)
    order, boxes = tree(np.array(corners))
    corners, rows = np.array(corners)[order], np.array(rows)[order]
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(u, v)
    area = np.linalg.norm(across, axis=1) / 2
    normal = across / (2 * area[:, None])
    lobes, gloss = np.unique(rows[:, 2:4], axis=0, return_inverse=True)
    albedo = np.array([lobe_albedo(*one) for one in lobes])
    shares = np.linspace(0, 1, TABLE)
    mean = [2 * np.trapz(one * shares, shares) for one in albedo]
    lamps, emitter = all_lamps(scene, corners[:, 0], u, v, normal, area, rows[:, 0])
    apart = bool(0 < (rows[:, 2] > 0).sum() <= MOST_GLOSSY and (lamps[0] <= LAMBERTIAN).all())
    return Arrays(corners[:, 0].copy(), u, v, normal, *(rows[:, k].copy() for k in range(5)), np.where(rows[:, 2] > 0, gloss.ravel(), -1),
                  emitter, apart, albedo, np.array(mean), *boxes, *lamps)


def tree(corners):
    """Order of the triangles and the boxes about them: split at the middle of the longest side."""
    low, high, middle = corners.min(axis=1), corners.max(axis=1), corners.mean(axis=1)
    order, lows, highs, first, count = [], [None], [None], [0], [0]
    todo = [(0, np.arange(len(corners)))]
    while todo:
        node, chosen = todo.pop()
        lows[node], highs[node] = low[chosen].min(axis=0), high[chosen].max(axis=0)
        if len(chosen) <= LEAF:
            first[node], count[node] = len(order), len(chosen)
            order.extend(chosen)
            continue
        axis = np.argmax(np.ptp(middle[chosen], axis=0))
        sorted_ = chosen[np.argsort(middle[chosen, axis], kind="stable")]
        first[node] = len(lows)
        for half in (sorted_[:len(chosen) // 2], sorted_[len(chosen) // 2:]):
            todo.append((len(lows), half))
            for column, empty in ((lows, None), (highs, None), (first, 0), (count, 0)):
                column.append(empty)
    return np.array(order), (np.array(lows), np.array(highs), np.array(first), np.array(count))


def all_lamps(scene, corner, u, v, normal, area, exitance):
    """Columns of luminaires and emitting triangles, and which lamp each triangle is."""
    rows = []
    for one in scene["luminaires"]:
        axis = np.array(one["aim"], float) / np.linalg.norm(one["aim"])
        if "rectangle" in one:
            side_u, side_v = (np.array(one["rectangle"][key], float) for key in "uv")
            place = np.array(one["rectangle"]["center"], float) - (side_u + side_v) / 2
            rows.append((RECTANGLE, place, axis, side_u, side_v, np.linalg.norm(np.cross(side_u, side_v)), one["flux"]))
        else:
            kind = ISOTROPIC if one["distribution"] == "isotropic" else LAMBERTIAN
            rows.append((kind, np.array(one["position"], float), axis, np.zeros(3), np.zeros(3), 1.0, one["flux"]))
    emitter = np.full(len(corner), -1)
    for i in np.flatnonzero(exitance > 0):
        emitter[i] = len(rows)
        rows.append((TRIANGLE, corner[i], normal[i], u[i], v[i], area[i], exitance[i] * area[i]))
    columns = [np.array(column) for column in zip(*rows)]
    flux = columns[-1].astype(float)
    return [*columns[:-1], flux, np.cumsum(flux) / flux.sum(), float(flux.sum())], emitter
