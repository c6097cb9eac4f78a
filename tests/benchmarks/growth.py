#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the time of a solve grows with receivers, triangles, luminaires, trajectories and threads, with fitted exponents.

    PYTHONPATH=build/python tests/benchmarks/growth.py [--method METHOD] [--largest N]

One number grows, the others stay: 100 receivers on a plane, 100 boxes in a room of 30 x 30 x 4 m, one luminaire, 640
trajectories; where triangles grow, 2500 receivers and 8192 trajectories, as a few rays find no part of the scene in a cache.
The exponent is the slope of log(time) over log(number) through the last three sizes: 1 is linear. Processor seconds are of
the solve on one thread, without the building of the scene, whose processor seconds stand beside it. The whole takes a
minute and 2.5 GB.
"""
import argparse
import os
import time

import numpy as np

import kalos
from kalos.core.options import DEFAULT_METHOD, METHODS

SIZES = {"receivers": (100, 1000, 10000, 100000, 1000000), "triangles": (1000, 10000, 100000, 1000000, 10000000),
         "luminaires": (1, 10, 100, 1000), "trajectories": (100, 1000, 10000, 100000)}
OTHERS = {"triangles": {"receivers": 2500, "trajectories": 8192}}  # what stays, where it is not as above
FIT = 3  # sizes that the exponent is of
SIDE, HEIGHT = 30.0, 4.0  # m
CORNERS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)], float)
FACES = np.array([(0, 2, 1), (4, 5, 6), (0, 1, 4), (2, 6, 3), (0, 4, 2), (1, 3, 5)])  # corner, and the ends of its two sides


def box(origin, size, squares, inwards):
    """Points and triangles (n, 3) of a box whose faces are cut into squares x squares pieces; faces share no points."""
    corner, right, up = (origin + size * CORNERS[FACES[:, k]] for k in range(3))
    u, v = (right - corner) / squares, (up - corner) / squares
    if inwards:
        u, v = v, u
    row = squares + 1
    i, j = (index.ravel() for index in np.meshgrid(np.arange(row), np.arange(row)))
    points = corner[:, None] + i[None, :, None] * u[:, None] + j[None, :, None] * v[:, None]
    a = (np.arange(squares)[:, None] * row + np.arange(squares)).ravel()
    face = np.stack([a, a + 1, a + 1 + row, a, a + 1 + row, a + row], axis=1).reshape(-1, 3)
    return points.reshape(-1, 3), (row**2 * np.arange(6)[:, None, None] + face).reshape(-1, 3)


def room_mesh(triangles):
    """Points and triangles of a room with 100 boxes, cut into about so many triangles."""
    squares = max(1, round(np.sqrt(triangles / (12 * 101))))
    parts = [box(np.zeros(3), np.array([SIDE, SIDE, HEIGHT]), squares, True)]
    for i in range(100):
        parts.append(box(np.array([1 + 3.0 * (i % 10), 1 + 3.0 * (i // 10), 0]), np.array([1.2, 0.8, 0.7]), squares, False))
    first = np.cumsum([0, *(len(points) for points, _ in parts[:-1])])
    return np.concatenate([points for points, _ in parts]), np.concatenate([k + faces for k, (_, faces) in zip(first, parts)])


def room(triangles):
    points, faces = room_mesh(triangles)
    return kalos.surface(points, faces, 0.5), len(faces)


def lamp_places(count):
    side = int(np.ceil(np.sqrt(count)))
    return [(SIDE * (k % side + 0.5) / side, SIDE * (k // side + 0.5) / side, HEIGHT - 0.01) for k in range(count)]


def lamps(count):
    return kalos.luminaire(lamp_places(count), 100000 / count)


def plane(count):
    side = int(np.ceil(np.sqrt(count)))
    x, y = np.meshgrid((np.arange(side) + 0.5) / side, (np.arange(side) + 0.5) / side)
    return np.stack([SIDE * x.ravel(), SIDE * y.ravel(), np.full(x.size, 0.75)], axis=1)[:count]


def measure(method, receivers=100, triangles=1000, luminaires=1, trajectories=640, threads=1):
    """Triangles that there were, processor seconds of the solve, of everything before and after it, and wall seconds."""
    surfaces, triangles = room(triangles)
    lights, points = lamps(luminaires), plane(receivers)
    start = time.process_time()
    found = kalos.illuminance(surfaces, lights, points, (0, 0, 1), method=method, trajectories=trajectories, threads=threads)
    return triangles, found.cpu_seconds, time.process_time() - start - found.cpu_seconds, found.seconds


def exponent(sizes, seconds):
    return float(np.polyfit(np.log(sizes[-FIT:]), np.log(seconds[-FIT:]), 1)[0])


def grow(name, sizes, method):
    """Prints a series; returns its exponent, None where there are too few sizes."""
    measured, seconds = [], []
    for size in sizes:
        triangles, solve, setup, _ = measure(method, **{name: size}, **OTHERS.get(name, {}))
        measured.append(triangles if name == "triangles" else size)
        seconds.append(solve)
        print(f"{measured[-1]:>9} {name:<13} {solve:10.4f} s   scene {setup:8.3f} s", flush=True)
    if len(sizes) < 2:
        return None
    slope = exponent(measured, seconds)
    print(f"          exponent      {slope:10.2f}   over the last {min(FIT, len(sizes))} sizes\n", flush=True)
    return slope


def main():
    parser = argparse.ArgumentParser(description="Growth of the time of a solve.")
    parser.add_argument("--method", choices=METHODS, default=DEFAULT_METHOD)
    parser.add_argument("--largest", type=int, default=10**9, metavar="N", help="leave out sizes beyond N")
    arguments = parser.parse_args()
    print(f"{arguments.method}, processor time of the solve on one thread")
    for name, sizes in SIZES.items():
        grow(name, [size for size in sizes if size <= arguments.largest], arguments.method)
    single = None
    for threads in [2**k for k in range(8) if 2**k <= os.cpu_count()]:
        *_, seconds = measure(arguments.method, receivers=min(2500, arguments.largest), threads=threads)
        single = single or seconds
        print(f"{threads:>9} {'threads':<13} {seconds:10.4f} s   {single / seconds:.2f} times one thread")


if __name__ == "__main__":
    main()
