#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes sphere-2.obj and sphere-3.obj beside itself: a unit sphere of 320 and of 1280 triangles, normals inwards.

An icosahedron, each triangle split in four per level, its vertices pushed out to the radius.
"""
from pathlib import Path

import numpy as np


def icosphere(level):
    """Vertices (n, 3) on the unit sphere and triangles (m, 3), seen counter-clockwise from the inside."""
    golden = (1 + 5**0.5) / 2
    ends = [(a, b * golden) for a in (-1, 1) for b in (-1, 1)]
    vertices = [(0, a, b) for a, b in ends] + [(a, b, 0) for a, b in ends] + [(b, 0, a) for a, b in ends]
    vertices = [np.array(v) / np.linalg.norm(v) for v in vertices]
    triangles = [(i, j, k) for i in range(12) for j in range(i + 1, 12) for k in range(j + 1, 12)
                 if all(np.linalg.norm(vertices[a] - vertices[b]) < 1.1 for a, b in ((i, j), (j, k), (k, i)))]
    triangles = [inwards(vertices, t) for t in triangles]
    for _ in range(level):
        triangles = split(vertices, triangles)
    return np.array(vertices), np.array(triangles)


def inwards(vertices, triangle):
    """The triangle, turned if need be so that its normal points to the centre."""
    a, b, c = (vertices[i] for i in triangle)
    return triangle if np.dot(np.cross(b - a, c - a), a) < 0 else triangle[::-1]


def split(vertices, triangles):
    """Four triangles for each; appends the new vertices."""
    middles = {}

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            point = vertices[i] + vertices[j]
            vertices.append(point / np.linalg.norm(point))
            middles[key] = len(vertices) - 1
        return middles[key]

    result = []
    for i, j, k in triangles:
        ij, jk, ki = middle(i, j), middle(j, k), middle(k, i)
        result += [(i, ij, ki), (j, jk, ij), (k, ki, jk), (ij, jk, ki)]
    return result


def write(path, level):
    vertices, triangles = icosphere(level)
    lines = [f"# Unit sphere, {len(triangles)} triangles, normals inwards; written by make.py."]
    lines += ["v " + " ".join(f"{x:.17g}" for x in v) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    for level in (2, 3):
        write(Path(__file__).with_name(f"sphere-{level}.obj"), level)
