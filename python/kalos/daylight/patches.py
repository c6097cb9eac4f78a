# SPDX-License-Identifier: BSD-3-Clause
"""Reinhart's division of the sky: 145 patches (Tregenza) or 577, and which hold a direction."""
import numpy as np

ROWS = (30, 30, 24, 24, 18, 12, 6)  # patches in rows of 12 degrees from the horizon; one cap at the zenith
MAP_STEP = 0.5  # degrees of a map's pixel


class Patches:
    """Patches in rows of equal height from the horizon up; the last is the cap. Azimuths are clockwise from north."""

    def __init__(self, subdivision=1):
        self.rows = [count * subdivision for count in ROWS for _ in range(subdivision)]
        # Radiance's division: rows of 90 / (7 m + 0.5) degrees, the cap takes half a row.
        self.height = 90 / (len(self.rows) + 0.5)
        self.first = np.concatenate([[0], np.cumsum(self.rows)])
        self.count = int(self.first[-1]) + 1

    def of(self, elevation, azimuth):
        """Index of the patch of each direction above the horizon, degrees."""
        elevation, azimuth = np.broadcast_arrays(np.asarray(elevation, float), np.asarray(azimuth, float))
        row = np.minimum((elevation / self.height).astype(int), len(self.rows))
        counts = np.array(self.rows + [1])[row]
        column = np.floor(np.mod(azimuth, 360) / 360 * counts + 0.5).astype(int) % counts  # the first one is centred on north
        return self.first[row] + column

    def solid_angles(self):
        """sr"""
        sines = np.sin(np.radians(np.append(np.arange(len(self.rows) + 1) * self.height, 90)))
        return np.repeat(2 * np.pi * np.diff(sines) / np.array(self.rows + [1]), self.rows + [1])

    def samples(self, across=4):
        """Directions, degrees, evenly over each patch: (count, across^2) elevations and azimuths."""
        u = (np.arange(across) + 0.5) / across
        elevations, azimuths = [], []
        for row, count in enumerate(self.rows + [1]):
            low, high = row * self.height, min(90.0, (row + 1) * self.height)
            sines = np.sin(np.radians(low)) + u * (np.sin(np.radians(high)) - np.sin(np.radians(low)))
            for column in range(count):
                turn = (column - 0.5 + u) * 360 / count
                e, a = np.meshgrid(np.degrees(np.arcsin(sines)), turn, indexing="ij")
                elevations.append(e.ravel())
                azimuths.append(a.ravel())
        return np.array(elevations), np.array(azimuths)

    def map_of(self, patch):
        """A latitude-longitude picture of 1 cd/m2 in the patch and 0 elsewhere."""
        elevation = 90 - MAP_STEP * (np.arange(int(180 / MAP_STEP)) + 0.5)
        azimuth = MAP_STEP * (np.arange(int(360 / MAP_STEP)) + 0.5) - 180
        picture = np.zeros((len(elevation), len(azimuth)), np.float32)
        above = elevation > 0
        picture[above] = self.of(elevation[above][:, None], azimuth[None, :]) == patch
        return picture
