# SPDX-License-Identifier: BSD-3-Clause
"""The glossy lobe of Kalos's reflection (material/Brdf.h) in NumPy: for closed forms, and for programs that know nothing of Kalos."""
import numpy as np

TABLE, STEPS = 129, 256  # entries of an albedo table; of the integration over visible normals
KERNEL_TABLE, KERNEL_STEPS = 33, 48  # the same of the kernels


def smith(alpha, mu):
    """Smith's Lambda of GGX."""
    return (np.sqrt(1 + alpha**2 * (1 / mu**2 - 1)) - 1) / 2


def lobe_albedo(specular, alpha, entries=TABLE, steps=STEPS):
    """Albedo of the lobe (without the mirror's share) over the cosine of incidence: the mean of F G2/G1 over visible normals."""
    if specular == 0:
        return np.zeros(entries)
    u = (np.arange(steps) + 0.5) / steps
    r, phi = np.sqrt(u)[:, None], 2 * np.pi * u
    found = []
    for mu in np.maximum(1e-3, np.linspace(0, 1, entries)):
        # Visible normals are those of a hemisphere seen under stretching (Heitz 2018); incidence in the plane y = 0.
        view = np.array([alpha * np.sqrt(1 - mu * mu), 0, mu])
        view /= np.linalg.norm(view)
        p1, p2 = r * np.cos(phi), r * np.sin(phi)
        p2 = (1 - view[2]) / 2 * np.sqrt(1 - p1**2) + (1 + view[2]) / 2 * p2
        up = np.sqrt(np.maximum(0, 1 - p1**2 - p2**2))
        m = np.array([-view[2] * p2 + view[0] * up, p1, view[0] * p2 + view[2] * up])
        m *= np.array([alpha, alpha, 1])[:, None, None]
        m /= np.sqrt((m**2).sum(axis=0))
        cosine = np.maximum(0, m[0] * np.sqrt(1 - mu * mu) + m[2] * mu)
        down = 2 * cosine * m[2] - mu  # the reflected direction's own cosine
        fresnel = specular + (1 - specular) * (1 - cosine) ** 5
        out, back = smith(alpha, np.maximum(down, 1e-9)), smith(alpha, mu)
        found.append(np.where(down > 0, fresnel * (1 + back) / (1 + back + out), 0).mean())
    return np.array(found)


def mean_albedo(albedo):
    """Cosine-weighted mean of a table that is linear between its entries, exactly: 2 integral of A mu dmu."""
    mu, step = np.linspace(0, 1, len(albedo)), 1 / (len(albedo) - 1)
    return float(2 * step * (mu[:-1] * (albedo[:-1] + albedo[1:]) / 2 + step * (albedo[:-1] / 6 + albedo[1:] / 3)).sum())
