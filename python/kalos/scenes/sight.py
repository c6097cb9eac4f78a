# SPDX-License-Identifier: BSD-3-Clause
"""What the pixels of a camera see: the first surface on each line of sight."""
import numpy as np

SEAM = 1e-9  # faces are enlarged by this share of a side, so that no ray passes between two of them


def camera_rays(position, target, up, field_of_view, resolution):
    """Unit directions (rows x columns, 3) through the centres of the pixels, row 0 at the bottom."""
    forward = np.subtract(target, position) / np.linalg.norm(np.subtract(target, position))
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    columns, rows = resolution
    half = np.tan(np.radians(field_of_view) / 2)
    x = (2 * (np.arange(columns) + 0.5) / columns - 1) * half * columns / rows
    y = (2 * (np.arange(rows) + 0.5) / rows - 1) * half
    direction = (forward + x[None, :, None] * right + y[:, None, None] * np.cross(right, forward)).reshape(-1, 3)
    return direction / np.linalg.norm(direction, axis=1)[:, None]


def first_faces(origin, directions, faces):
    """What rays from one point meet first: the distance, infinite where they meet nothing, and which of the faces, else -1."""
    nearest, index = np.full(len(directions), np.inf), np.full(len(directions), -1)
    for k, corners in enumerate(faces):
        u, v = corners[1] - corners[0], corners[2] - corners[0]
        normal = np.cross(u, v)
        # Moeller and Trumbore's test, with the origin in common.
        to = np.asarray(origin, float) - corners[0]
        determinant = -(directions @ normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            distance = (to @ normal) / determinant
            a = (directions @ np.cross(v, to)) / determinant
            b = -(directions @ np.cross(u, to)) / determinant
            hit = (distance > 0) & (distance < nearest) & (a >= -SEAM) & (b >= -SEAM) & (a + b <= 1 + SEAM)
        nearest[hit] = distance[hit]
        index[hit] = k
    return nearest, index


def normals_towards(directions, faces, index):
    """Unit normals of the faces that rays have met, on the side that they come from; not a number where they met none."""
    normals = np.full((len(directions), 3), np.nan)
    met = index >= 0
    corners = faces[index[met]]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    side = -np.sign(np.einsum("ij,ij->i", directions[met], across))
    normals[met] = (side / np.linalg.norm(across, axis=1))[:, None] * across
    return normals


def first_hits(origin, directions, faces):
    """Points that rays from one point meet first, and normals towards it; not a number where they meet nothing."""
    nearest, index = first_faces(origin, directions, faces)
    points = np.asarray(origin, float) + np.where(index >= 0, nearest, np.nan)[:, None] * directions
    return points, normals_towards(directions, faces, index)
