# SPDX-License-Identifier: BSD-3-Clause
"""Truths in closed form or by quadrature that kalos.truths does not have. Lengths in m, flux in lm, illuminance in lx."""
import numpy as np

from kalos.validation import truths


def even(value):
    """The same everywhere."""
    return lambda receivers: np.full(len(receivers), value)


def furnace(reflectance, exitance):
    return even(truths.white_furnace(reflectance, exitance))


def planes(flux, below, height, floor, ceiling):
    """An isotropic lamp `below` the upper of two infinite diffuse planes `height` apart, at x = y = 0 (Sobolev's problem).

    E = Phi/4pi int_0^inf [...] J0(k r) k dk, kalos.truths.sobolev: the lower plane is z = 0.
    """
    def truth(receivers):
        values = []
        for x, y, z, *_ in receivers:
            upper = z > height / 2
            h1, rho1, rho2 = (below, ceiling, floor) if upper else (height - below, floor, ceiling)
            values.append(truths.sobolev(flux, h1, height, rho1, rho2, float(np.hypot(x, y))))
        return np.array(values)
    return truth


def integrating_sphere(flux, position, radius, reflectance):
    """An isotropic lamp anywhere in a diffuse sphere: its direct light, and Phi/(4 pi R2) rho/(1 - rho) everywhere."""
    def truth(receivers):
        direct = truths.isotropic_point(receivers[:, :3], receivers[:, 3:], np.array(position), flux)
        return direct + truths.sphere_indirect(flux, radius, reflectance)
    return truth


def mirror_box(flux, position, size, mirror, most):
    """An isotropic lamp in a box of six mirrors: the sum over all its images.

    Image (i, j, k) has taken |i| + |j| + |k| reflections: E = Phi/4pi sum m^(|i|+|j|+|k|) cos/d2, up to `most` of them.
    An axis without mirrors (0 in `mirror`, one number per axis) has no images.
    """
    orders = np.arange(-most, most + 1)
    kept = [orders if m > 0 else np.zeros(1, int) for m in mirror]
    taken = np.stack(np.meshgrid(*kept, indexing="ij"), axis=-1).reshape(-1, 3)
    taken = taken[np.abs(taken).sum(axis=1) <= most]
    share = np.prod([np.power(m or 1.0, np.abs(taken[:, axis])) for axis, m in enumerate(mirror)], axis=0)
    images = 2 * np.asarray(size) * np.ceil(taken / 2) + np.where(taken % 2 == 0, 1, -1) * position

    def truth(receivers):
        values = []
        for place in receivers:
            to = images - place[:3]
            values.append((share * np.maximum(to @ place[3:], 0) / (to**2).sum(axis=1) ** 1.5).sum())
        return flux / (4 * np.pi) * np.array(values)
    return truth
