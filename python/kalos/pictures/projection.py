# SPDX-License-Identifier: BSD-3-Clause
"""How receivers that lie in a plane are laid on paper."""
from dataclasses import dataclass

import numpy as np

AXES = "xyz"


@dataclass
class Frame:
    """Two directions in space that become right and up on paper; coordinates are kept where they follow an axis."""

    origin: np.ndarray
    right: np.ndarray
    up: np.ndarray
    right_label: str
    up_label: str
    right_inverted: bool  # the coordinate falls to the right

    def project(self, points):
        offset = points - self.origin
        return np.column_stack([offset @ self.right, offset @ self.up])


def flat_frame(points, normals):
    """The frame of receivers in one plane, None for any others.

    Horizontal planes are drawn as a plan, seen from above with x to the right and y up; walls are seen from the side
    their normals point to, z up.
    """
    normal = normals[0]
    size = np.ptp(points, axis=0).max()
    if np.abs(normals - normal).max() > 1e-6 or np.abs((points - points[0]) @ normal).max() > 1e-6 * max(size, 1e-6):
        return None
    if abs(normal[2]) > 1 - 1e-6:
        right, up = np.array([1.0, 0, 0]), np.array([0, 1.0, 0])
    else:
        up = np.array([0, 0, 1.0]) - normal[2] * normal
        up /= np.linalg.norm(up)
        right = np.cross(up, normal)
    return named(points, right, up)


def named(points, right, up):
    """Coordinates of space where a direction is an axis of it, else metres from the corner."""
    origin = np.zeros(3)
    labels = []
    inverted = False
    for direction, fallback in ((right, "along, m"), (up, "up, m")):
        axis = int(np.argmax(np.abs(direction)))
        if abs(direction[axis]) > 1 - 1e-9:
            labels.append(f"{AXES[axis]}, m")
            if direction is right and direction[axis] < 0:
                inverted = True
        else:
            labels.append(fallback)
            origin = origin + direction * np.min(points @ direction)
    return Frame(origin, -right if inverted else right, up, *labels, inverted)
