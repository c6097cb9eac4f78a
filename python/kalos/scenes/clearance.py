# SPDX-License-Identifier: BSD-3-Clause
"""How far points on surfaces are from concave edges and contacts.

The clearance of a surface point is its distance to the nearest point of the scene's surfaces that lies in front of it:
strictly on the side of its normal. In the middle of a wall that is another wall; at a concave edge, in a corner or beside
a box it tends to nothing; a convex edge does not count, for nothing there lies in front.
"""
import numpy as np

TOUCH = 1e-6  # of the scene's size: what is no higher above the plane of a point is in that plane


def triangles(surfaces):
    """The corners (n, 3, 3) of all faces of a vtkPolyData, polygons cut into fans."""
    found = []
    for i in range(surfaces.GetNumberOfCells()):
        ids = surfaces.GetCell(i).GetPointIds()
        corners = [surfaces.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]
        found += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    return np.array(found, float).reshape(-1, 3, 3)


def clearance(points, normals, faces):
    """For points (n, 3) with unit normals, m; infinite where nothing lies in front."""
    touch = TOUCH * np.ptp(faces.reshape(-1, 3), axis=0).max()
    nearest = np.full(len(points), np.inf)
    for corners in faces:
        reach = np.linalg.norm(corners[1:] - corners[0], axis=1).max()
        # A face whose nearest possible point is farther than what is known already cannot change anything.
        could = np.linalg.norm(points - corners[0], axis=1) - reach < nearest
        nearest[could] = np.minimum(nearest[could], distance_in_front(points[could], normals[could], corners, touch))
    return nearest


def distance_in_front(points, normals, corners, touch):
    """Distance from each point to the part of a triangle that is more than `touch` above its plane."""
    height = np.stack([((corner - points) * normals).sum(axis=1) for corner in corners]) - touch  # (3, n)
    result = np.full(len(points), np.inf)
    cuts = np.full((2, len(points), 3), np.nan)  # ends of the line along which the plane cuts the triangle
    for i in range(3):
        j = (i + 1) % 3
        start, end = np.broadcast_to(corners[i], points.shape), np.broadcast_to(corners[j], points.shape)
        crossing = (height[i] > 0) != (height[j] > 0)
        share = np.divide(height[i], height[i] - height[j], out=np.zeros(len(points)), where=crossing)[:, None]
        cut = start + share * (end - start)
        ends = np.where((height[i] > 0)[:, None], start, cut), np.where((height[j] > 0)[:, None], end, cut)
        inside = (height[i] > 0) | (height[j] > 0)
        result[inside] = np.minimum(result[inside], distance_to_segments(points, *ends)[inside])
        first = np.isnan(cuts[0, :, 0]) & crossing
        cuts[1][crossing & ~first] = cut[crossing & ~first]
        cuts[0][first] = cut[first]
    cut_through = ~np.isnan(cuts[:, :, 0]).any(axis=0)
    result[cut_through] = np.minimum(result[cut_through], distance_to_segments(
        points[cut_through], cuts[0][cut_through], cuts[1][cut_through]))

    # The foot of the perpendicular, where it falls into the part in front.
    across = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    area = np.linalg.norm(across)
    if area > 0:
        unit = across / area
        above = (points - corners[0]) @ unit
        foot = points - above[:, None] * unit
        inside = ((foot - points) * normals).sum(axis=1) > touch
        for i in range(3):
            side = np.cross(unit, corners[(i + 1) % 3] - corners[i])
            inside &= (foot - corners[i]) @ side >= 0
        result[inside] = np.minimum(result[inside], np.abs(above[inside]))
    return result


def distance_to_segments(points, starts, ends):
    along = ends - starts
    squared = (along * along).sum(axis=1)
    share = np.divide(((points - starts) * along).sum(axis=1), squared, out=np.zeros(len(points)), where=squared > 0)
    return np.linalg.norm(points - starts - np.clip(share, 0, 1)[:, None] * along, axis=1)
