# SPDX-License-Identifier: BSD-3-Clause
"""Daylight through openings by integrals: CIE general skies (ISO 15469), glass, and the room of CIE 171, cases 5.9 to 5.12."""
import numpy as np

COEFFICIENTS = {1: (4, -0.7, 0, -1, 0), 2: (4, -0.7, 2, -1.5, 0.15), 3: (1.1, -0.8, 0, -1, 0), 4: (1.1, -0.8, 2, -1.5, 0.15),
                5: (0, -1, 0, -1, 0), 6: (0, -1, 2, -1.5, 0.15), 7: (0, -1, 5, -2.5, 0.3), 8: (0, -1, 10, -3, 0.45),
                9: (-1, -0.55, 2, -1.5, 0.15), 10: (-1, -0.55, 5, -2.5, 0.3), 11: (-1, -0.55, 10, -3, 0.45),
                12: (-1, -0.32, 10, -3, 0.45), 13: (-1, -0.32, 16, -3, 0.3), 14: (-1, -0.15, 16, -3, 0.3),
                15: (-1, -0.15, 24, -2.8, 0.15)}  # a, b, c, d, e of CIE S 011, table 1
ELEVATION = np.radians(60)  # of the sun in CIE 171
SUN = np.array([0, np.cos(ELEVATION), np.sin(ELEVATION)])  # the room's +y is south
GROUND = 0.3


def gauss(low, high, count):
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (low + high) + 0.5 * (high - low) * nodes, 0.5 * (high - low) * weights


def relative_luminance(kind, directions):
    """Of unit vectors (..., 3) above the horizon."""
    a, b, c, d, e = COEFFICIENTS[kind]
    height = np.maximum(directions[..., 2], 1e-12)
    chi = np.arccos(np.clip(directions @ SUN, -1, 1))
    return (1 + a * np.exp(b / height)) * (1 + c * (np.exp(d * chi) - np.exp(d * np.pi / 2)) + e * np.cos(chi) ** 2)


def horizontal(kind):
    """The horizontal illuminance of the relative luminance: panels that end at the sun, where it has a cusp."""
    total, zenith = 0.0, np.pi / 2 - ELEVATION
    for low, high in ((0, zenith), (zenith, np.pi / 2)):
        theta, ring = gauss(low, high, 200)
        phi, turn = gauss(0, np.pi, 200)  # from the sun's azimuth, both ways
        t, p = np.meshgrid(theta, phi + np.pi / 2, indexing="ij")
        way = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1)
        total += 2 * np.sum(relative_luminance(kind, way) * np.cos(t) * np.sin(t) * ring[:, None] * turn)
    return total


def through(kind, points, normals, corner, u, v, transmittance=None, cells=240):
    """Sky component and externally reflected component, shares of the horizontal illuminance, (2, n), of a rectangular opening
    whose side u is level. It is cut where a point sees the horizon."""
    corner, u, v = (np.asarray(one, float) for one in (corner, u, v))
    across, scale, found = np.cross(u, v) / np.linalg.norm(np.cross(u, v)), horizontal(kind), []
    for point, normal in zip(points, normals):
        horizon = np.clip((point[2] - corner[2]) / v[2], 0, 1) if v[2] else 0.0
        shares = np.zeros(2)
        for low, high in ((0.0, horizon), (horizon, 1.0)):
            if high > low:
                shares += panel(kind, point, normal, corner + low * v, u, (high - low) * v, across, transmittance, cells, scale)
        found.append(shares)
    return np.array(found).T


def panel(kind, point, normal, corner, u, v, across, transmittance, cells, scale):
    s, ds = gauss(0, 1, cells)
    way = (corner + s[:, None, None] * u + s[None, :, None] * v).reshape(-1, 3) - point
    squared = np.einsum("ij,ij->i", way, way)
    way /= np.sqrt(squared)[:, None]
    facing = np.abs(way @ across)
    weight = np.maximum(way @ normal, 0) * facing / squared * np.outer(ds, ds).ravel() * np.linalg.norm(np.cross(u, v))
    if transmittance is not None:
        weight = weight * transmittance(facing)
    above = way[:, 2] > 0
    return np.sum((weight * relative_luminance(kind, way))[above]) / scale, GROUND / np.pi * np.sum(weight[~above])


def pane(normal_transmittance, index):
    """Transmittance by the cosine of incidence of a slab: Fresnel, both polarisations, all internal reflections, absorption."""
    r0 = ((index - 1) / (index + 1)) ** 2
    square = (1 - r0) ** 2
    once = 2 * normal_transmittance / (square + np.sqrt(square**2 + 4 * normal_transmittance**2 * r0**2))

    def transmittance(cosine):
        inside = np.sqrt(1 - (1 - cosine**2) / index**2)
        a = once ** (1 / inside)
        reflected = ((cosine - index * inside) / (cosine + index * inside)) ** 2, ((index * cosine - inside) / (index * cosine + inside)) ** 2
        return sum(0.5 * (1 - r) ** 2 * a / (1 - r**2 * a**2) for r in reflected)

    return transmittance
