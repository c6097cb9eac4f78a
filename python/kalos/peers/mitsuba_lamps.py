# SPDX-License-Identifier: BSD-3-Clause
"""Luminaires of kalos.peers.mitsuba_worker: points and rectangles, even or by a candela table."""
import drjit as dr
import mitsuba as mi
import numpy as np
from mitsuba import Float, UInt32, Vector3f

NEAR = 5  # larger sides of an opening within which it is an area, as Kalos has it


class CandelaTable:
    """Intensity per lumen, bilinear in the two angles; 0 outside the table."""

    def __init__(self, planes, angles, candela, side):
        self.planes, self.angles = Float(planes), Float(angles)
        self.first, self.last, self.low, self.high = (float(x) for x in (planes[0], planes[-1], angles[0], angles[-1]))
        self.rows, self.columns, self.side = len(planes), len(angles), bool(side)
        self.candela = Float(np.ascontiguousarray((candela / flux(planes, angles, candela)).ravel(), np.float32))
        upward = candela[:, angles > 90] if not side else candela[np.abs(planes) > 90]
        self.one_sided = not upward.any()

    def intensity(self, d):
        """Into directions of the photometric frame, cd/lm."""
        x, y, z = (d.x, d.y, d.z) if not self.side else (d.z, d.x, d.y)
        plane = dr.rad2deg(dr.atan2(y, x))
        angle = dr.rad2deg(dr.atan2(dr.sqrt(x * x + y * y), z))
        plane -= 360 * dr.floor((plane - self.first) / 360)
        p, s = self.locate(self.planes, self.rows, plane)
        a, t = self.locate(self.angles, self.columns, angle)
        at = p * self.columns + a
        corner = [dr.gather(Float, self.candela, at + step) for step in (0, 1, self.columns, self.columns + 1)]
        value = dr.lerp(dr.lerp(corner[0], corner[1], t), dr.lerp(corner[2], corner[3], t), s)
        return dr.select((angle >= self.low) & (angle <= self.high) & (plane <= self.last), value, 0)

    @staticmethod
    def locate(knots, count, x):
        i = dr.binary_search(0, count - 1, lambda k: dr.gather(Float, knots, k) <= x)
        i = dr.clip(UInt32(i), 1, count - 1) - 1
        low, high = dr.gather(Float, knots, i), dr.gather(Float, knots, i + 1)
        return i, dr.clip((x - low) / (high - low), 0, 1)


def flux(planes, angles, candela):
    """Lumens of a table: the integral over each plane in closed form, linear between planes."""
    theta = np.radians(angles)
    slope = np.diff(candela, axis=1) / np.diff(theta)
    part = (candela[:, :-1] * np.cos(theta[:-1]) - candela[:, 1:] * np.cos(theta[1:]) + slope * np.diff(np.sin(theta))).sum(axis=1)
    return float(trapezoid(part, np.radians(planes)))


class Lamps:
    """All luminaires; one is drawn in proportion to its flux."""

    def __init__(self, scene):
        self.count = len(scene["lamp_flux"])
        if not self.count:
            return
        share = scene["lamp_flux"] / scene["lamp_flux"].sum()
        self.choice = mi.DiscreteDistribution(Float(share))
        kinds = scene["lamp_table"]
        chosen = Float(kinds.astype(np.float32))
        self.measured = [(float(k), CandelaTable(*(scene[f"{name}{k}"] for name in ("planes", "angles", "candela", "side"))), chosen)
                         for k in np.unique(kinds) if k >= 0]
        one_sided = ~scene["lamp_isotropic"]
        for k, one, _ in self.measured:
            one_sided[kinds == k] = one.one_sided
        numbers = np.stack([scene["lamp_flux"], share, one_sided], axis=1)
        sides = [scene[f"lamp_{name}"] for name in "uv"]
        self.rows = [table(column) for column in (scene["lamp_position"], scene["lamp_axis"], *sides, numbers, scene["lamp_up"])]
        self.area = np.where(kinds < 0, np.linalg.norm(np.cross(*sides), axis=1), 0)  # of Lambertian rectangles, m2
        self.rectangles = bool(self.area.any())
        lengths = np.linalg.norm(sides, axis=2)
        self.sizes = table(np.stack([*lengths, kinds < 0], axis=1))
        self.areas = table(np.stack([self.area] * 3, axis=1))

    def sample(self, p, sampler, active):
        """A luminaire as seen from p: a unit direction to it, the illuminance that it sends there across that direction over the
        chance of picking it, the end of a shadow ray, and the density of a Lambertian rectangle's direction, 1/sr, else 0."""
        i = self.choice.sample(sampler.next_1d(active), active) if self.count > 1 else UInt32(0)
        place = sampler.next_2d(active)
        position, axis, u, v, (flux, share, one_sided), up = (one(i) for one in self.rows)
        to = position + (place.x - 0.5) * u + (place.y - 0.5) * v
        if self.measured:
            to = dr.select(self.is_area(i, position, p), to, position)
        d = to - p
        d2 = dr.squared_norm(d)
        d *= dr.rsqrt(d2)
        along = -dr.dot(d, axis)
        shape = self.shape(i, axis, up, one_sided, along, d)
        density = Float(0)
        if self.rectangles:
            area = self.areas(i)[0]
            density = dr.select(area > 0, share * d2 / dr.maximum(area * along, 1e-20), 0)
        # A lamp flush with a surface shines into the room, also when rounding puts it into that surface.
        return d, flux * shape / (dr.pi * d2 * share), offset(to, one_sided * axis), density

    def is_area(self, i, position, p):
        """Whether the opening of a measured luminaire is so near to p that it must be an area; true of all others."""
        u, v, lambertian = self.sizes(i)
        reach = NEAR * dr.maximum(u, v)
        return (lambertian > 0) | (dr.squared_norm(p - position) < reach * reach)

    def shape(self, i, axis, up, one_sided, along, d):
        """Intensity over the flux and times pi, 1/sr; d leads from the receiver to the luminaire."""
        shape = dr.lerp(0.25, dr.maximum(along, 0), one_sided)
        for k, one, chosen in self.measured:
            local = Vector3f(-dr.dot(d, dr.cross(axis, up)), -dr.dot(d, up), along)
            value = dr.pi * one.intensity(local)
            if one.one_sided:
                value = dr.select(along > 0, value, 0)
            shape = dr.select(dr.gather(Float, chosen, i) == k, value, shape)
        return shape


def offset(p, n):
    """Off the surface, in proportion to the rounding of the coordinates."""
    return p + n * (1e-5 * (1 + dr.max(dr.abs(p))))


def trapezoid(y, x):
    return ((y[1:] + y[:-1]) / 2 * np.diff(x)).sum()


def table(rows):
    """A function from an index to a row of three numbers: to literals where there is one row, for the compiler's sake."""
    if len(rows) == 1:
        only = Vector3f(*map(float, rows[0]))
        return lambda i: only
    columns = Vector3f(np.ascontiguousarray(rows.T, np.float32))
    return lambda i: dr.gather(Vector3f, columns, i)
