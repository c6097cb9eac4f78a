# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance that glossy planes make, by quadrature: of a lamp, of a lamp beside a mirror, of a uniformly bright room."""
import numpy as np

from kalos.scenes.lobes import TABLE, lobe_albedo, mean_albedo, smith
from kalos.validation import truths

STEPS = 1500  # of the distance; a quarter of the angle
COSINES = np.linspace(0, 1, TABLE)


def glossy_plane(flux, position, reflectance, specular, roughness, mirror=0.0):
    """An isotropic lamp over the plane z = 0 with Kalos's reflection (material/Brdf.h), nothing else: direct light and

    E = Phi/4pi int f cos_i cos_o cos_r / (d_i2 d_o2) dA,

    the diffuse part about the lamp's foot, the lobe about the mirror point. With a mirror in the plane x = 0, which reflects
    that share, lamp, receivers and plane are in front of it, and the images of lamp and receivers add what comes by it.
    """
    alpha, position = roughness**2, np.asarray(position, float)
    albedo = lobe_albedo(specular, alpha)
    ahead = np.array([-1.0, 1, 1])

    def images(vector):
        return [(1.0, vector)] + ([(mirror, vector * np.tile(ahead, len(vector) // 3))] if mirror else [])

    def truth(receivers):
        points, normals = receivers[:, :3], receivers[:, 3:]
        values = sum(share * np.maximum(truths.isotropic_point(points, normals, lamp, flux), 0) for share, lamp in images(position))
        return values + flux / (4 * np.pi) * np.array([reflected(place) for place in receivers])

    def reflected(place):
        return sum(a * b * once(lamp, seen) for a, lamp in images(position) for b, seen in images(place))

    def once(lamp, place):
        foot, width = lamp[:2], lamp[2]
        found = integral(transport(lamp, place, lambda wi, wo: diffuse(albedo, reflectance, wi, wo), mirror), foot, np.eye(2) * width)
        shiny = transport(lamp, place, lambda wi, wo: lobe(alpha, specular, wi, wo), mirror)
        return found + integral(shiny, *highlight(alpha, lamp, place))

    return truth


def furnace_floor(exitance, size, reflectance, specular, roughness, steps=400):
    """In a box of that size with black walls and ceiling of one exitance, over a glossy floor that sees nothing else.

    What leaves the floor towards the cosine mu is a(mu) = rho (1 - A(mu)) + A(mu) times the exitance over pi, so that
    E = M (1 - int (1 - a(mu)) cos cos' / (pi d2) dA) over the floor, and E = M on it.
    """
    albedo = lobe_albedo(specular, roughness**2)
    x, y = ((np.arange(steps) + 0.5) / steps * side for side in size[:2])
    floor = np.stack([*np.meshgrid(x, y), np.zeros((steps, steps))], axis=-1)

    def at(place):
        to = place[:3] - floor
        d2 = (to**2).sum(axis=-1)
        up, down = to[..., 2] / np.sqrt(d2), np.maximum(-(to @ place[3:]) / np.sqrt(d2), 0)
        absorbed = (1 - reflectance) * (1 - np.interp(up, COSINES, albedo))
        return 1 - (absorbed * up * down / (np.pi * d2)).mean() * size[0] * size[1]

    return lambda receivers: exitance * np.array([at(place) if place[2] > 0 else 1.0 for place in receivers])


def integral(integrand, middle, axes):
    """Of a function of points (x, y) over a plane, that falls off from `middle` within about the lengths of two axes.

    With q the distance in these lengths, u = q2/(1 + q2) and the polar angle are what is divided evenly.
    """
    u, phi = (np.arange(STEPS) + 0.5) / STEPS, 2 * np.pi * (np.arange(STEPS // 4) + 0.5) / (STEPS // 4)
    q = np.sqrt(u / (1 - u))[:, None, None]
    points = middle + q * (np.cos(phi)[:, None] * axes[0] + np.sin(phi)[:, None] * axes[1])
    area = abs(np.linalg.det(axes)) * np.pi / (1 - u) ** 2 / STEPS / len(phi)
    return (integrand(points) * area[:, None]).sum()


def transport(position, place, reflect, mirror):
    """f cos_i cos_o cos_r / (d_i2 d_o2) of points of the plane; in front of a mirror there are none behind x = 0."""
    def of(points):
        ground = np.concatenate([points, np.zeros_like(points[..., :1])], axis=-1)
        to_lamp, to_place = position - ground, place[:3] - ground
        i2, o2 = (to_lamp**2).sum(axis=-1), (to_place**2).sum(axis=-1)
        wi, wo = to_lamp / np.sqrt(i2)[..., None], to_place / np.sqrt(o2)[..., None]
        there = points[..., 0] > 0 if mirror else 1.0
        return there * reflect(wi, wo) * wi[..., 2] * wo[..., 2] * np.maximum(-(wo @ place[3:]), 0) / (i2 * o2)
    return of


def diffuse(albedo, reflectance, wi, wo):
    kept = [1 - np.interp(w[..., 2], COSINES, albedo) for w in (wi, wo)]
    return reflectance / np.pi * kept[0] * kept[1] / (1 - mean_albedo(albedo))


def lobe(alpha, specular, wi, wo):
    m = wi + wo
    m /= np.linalg.norm(m, axis=-1)[..., None]
    density = alpha**2 / (np.pi * (1 - m[..., 2] ** 2 * (1 - alpha**2)) ** 2)
    fresnel = specular + (1 - specular) * (1 - (m * wo).sum(axis=-1)) ** 5
    masking = 1 / (1 + smith(alpha, wi[..., 2]) + smith(alpha, wo[..., 2]))
    return density * fresnel * masking / (4 * wi[..., 2] * wo[..., 2])


def highlight(alpha, position, place):
    """The mirror point, and how far the lobe spreads along and across the plane of incidence."""
    along, up, over = place[:2] - position[:2], place[2], position[2]
    away = np.hypot(*along)
    e = along / away if away else np.array([1.0, 0.0])
    cosine = (up + over) / np.hypot(up + over, away)
    harmonic = 2 / (cosine / up + cosine / over)
    return position[:2] + along * over / (up + over), alpha * harmonic * np.array([e / cosine, [-e[1] * cosine, e[0] * cosine]])
