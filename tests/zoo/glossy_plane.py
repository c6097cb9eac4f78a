# SPDX-License-Identifier: BSD-3-Clause
"""The truth of an isotropic lamp over a glossy plane, by quadrature."""
import numpy as np

from kalos.validation import truths
from tracer_scene import TABLE, lobe_albedo, smith

STEPS = 1500  # of the distance; a quarter of the angle
COSINES = np.linspace(0, 1, TABLE)


def glossy_plane(flux, position, reflectance, specular, roughness):
    """An isotropic lamp over the plane z = 0 with Kalos's reflection (material/Brdf.h), nothing else: direct light and

    E = Phi/4pi int f cos_i cos_o cos_r / (d_i2 d_o2) dA,

    the diffuse part about the lamp's foot, the lobe about the mirror point.
    """
    alpha, position = roughness**2, np.asarray(position, float)
    albedo = lobe_albedo(specular, alpha)

    def truth(receivers):
        values = truths.isotropic_point(receivers[:, :3], receivers[:, 3:], position, flux)
        return np.maximum(values, 0) + flux / (4 * np.pi) * np.array([reflected(place) for place in receivers])

    def reflected(place):
        foot, width = position[:2], position[2]
        found = integral(transport(position, place, lambda wi, wo: diffuse(albedo, reflectance, wi, wo)), foot, np.eye(2) * width)
        shiny = transport(position, place, lambda wi, wo: lobe(alpha, specular, wi, wo))
        return found + integral(shiny, *highlight(alpha, position, place))

    return truth


def integral(integrand, middle, axes):
    """Of a function of points (x, y) over a plane, that falls off from `middle` within about the lengths of two axes.

    With q the distance in these lengths, u = q2/(1 + q2) and the polar angle are what is divided evenly.
    """
    u, phi = (np.arange(STEPS) + 0.5) / STEPS, 2 * np.pi * (np.arange(STEPS // 4) + 0.5) / (STEPS // 4)
    q = np.sqrt(u / (1 - u))[:, None, None]
    points = middle + q * (np.cos(phi)[:, None] * axes[0] + np.sin(phi)[:, None] * axes[1])
    area = abs(np.linalg.det(axes)) * np.pi / (1 - u) ** 2 / STEPS / len(phi)
    return (integrand(points) * area[:, None]).sum()


def transport(position, place, reflect):
    """f cos_i cos_o cos_r / (d_i2 d_o2) of points of the plane."""
    def of(points):
        ground = np.concatenate([points, np.zeros_like(points[..., :1])], axis=-1)
        to_lamp, to_place = position - ground, place[:3] - ground
        i2, o2 = (to_lamp**2).sum(axis=-1), (to_place**2).sum(axis=-1)
        wi, wo = to_lamp / np.sqrt(i2)[..., None], to_place / np.sqrt(o2)[..., None]
        return reflect(wi, wo) * wi[..., 2] * wo[..., 2] * np.maximum(-(wo @ place[3:]), 0) / (i2 * o2)
    return of


def diffuse(albedo, reflectance, wi, wo):
    kept = [1 - np.interp(w[..., 2], COSINES, albedo) for w in (wi, wo)]
    return reflectance / np.pi * kept[0] * kept[1] / (1 - 2 * np.trapz(albedo * COSINES, COSINES))


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
