# SPDX-License-Identifier: BSD-3-Clause
"""Closed forms that every estimate is held against. Lengths in m, flux in lm, illuminance in lx.

All are exact for Lambertian surfaces and need nothing of the estimators: no sampling, no mesh.
"""
import numpy as np
from scipy import integrate, special


def white_furnace(reflectance: float, exitance: float) -> float:
    """Illuminance everywhere in a closed scene of one reflectance whose every surface emits `exitance`, lm/m2.

    E = M0/(1 - rho): at any distance from any edge, on any mesh. The luminance is E rho/pi + M0/pi.
    """
    return exitance / (1 - reflectance)


def mean_indirect(flux, area, reflectance):
    """Mean indirect illuminance over all surfaces, together `area`, of a closed room of one reflectance.

    (Phi/S) rho/(1 - rho), from the balance of energy; test case 5.8 of CIE 171:2006.
    """
    return flux / area * reflectance / (1 - reflectance)


def sphere_indirect(flux, radius, reflectance):
    """Indirect illuminance everywhere in a sphere, whatever the source (the integrating sphere of photometry)."""
    return mean_indirect(flux, 4 * np.pi * radius**2, reflectance)


def sobolev(flux, h1, height, rho1, rho2, r):
    """Illuminance on plane 1 at distance r from the foot of an isotropic point source between two infinite planes.

    The source is h1 above plane 1, the planes are `height` apart (V. V. Sobolev's problem of two diffuse planes):
    E1(r) = Phi/4pi int_0^inf [e^(-k h1) + rho2 kappa e^(-k h2)] / (1 - rho1 rho2 kappa^2) J0(k r) k dk with
    kappa = k H K1(k H), the Hankel transform of the exchange between the planes.
    """
    direct = flux / (4 * np.pi) * h1 / (h1**2 + r**2) ** 1.5

    def reflected(k):
        x = max(k * height, 1e-12)
        kappa = x * special.k1(x)
        source = rho2 * kappa * np.exp(-k * (height - h1)) + rho1 * rho2 * kappa**2 * np.exp(-k * h1)
        return source / (1 - rho1 * rho2 * kappa**2) * special.j0(k * r) * k

    # The direct part is known in closed form; what is left falls off as e^(-k H), so that 60/H is infinity.
    value, _ = integrate.quad(reflected, 0, 60 / height, limit=400, epsabs=1e-13, epsrel=1e-12)
    return direct + flux / (4 * np.pi) * value


def polygon_form_factor(point, normal, corners):
    """Form factor from a surface element to a polygon wholly on the front of it (J. H. Lambert, 1760).

    (1/2pi) sum over the edges of (angle under which the edge is seen) (normal . unit normal of the plane through the
    edge and the point). The sign of the winding is dropped.
    """
    to = np.asarray(corners, float) - point
    to /= np.linalg.norm(to, axis=1)[:, None]
    following = np.roll(to, -1, axis=0)
    across = np.cross(to, following)
    length = np.linalg.norm(across, axis=1)
    angle = np.arctan2(length, (to * following).sum(axis=1))
    return abs(float(np.sum(angle * (across @ normal) / length))) / (2 * np.pi)


def parallel_rectangle(a, b, distance):
    """Form factor from an element to a parallel rectangle a x b with a corner straight above it (Howell, B-3)."""
    x, y = a / distance, b / distance
    u, v = np.sqrt(1 + x * x), np.sqrt(1 + y * y)
    return (x / u * np.arctan(y / u) + y / v * np.arctan(x / v)) / (2 * np.pi)


def perpendicular_rectangle(distance, width, depth):
    """Form factor from an element to a perpendicular rectangle, the element in front of a corner (Howell, B-4).

    The element is `distance` from the common edge; the rectangle is `width` along it and `depth` away from it.
    Two of them side by side tend to 1/2 at the edge.
    """
    far = np.hypot(distance, depth)
    return (np.arctan(width / distance) - distance / far * np.arctan(width / far)) / (2 * np.pi)


def disc_form_factor(radius, distance):
    """Form factor from an element to a parallel disc centred above it: R2/(R2 + h2) (Howell, B-13)."""
    return radius**2 / (radius**2 + distance**2)


def cie171_point(points, intensity=1000.0, height=3.0):
    """CIE 171:2006, 5.2: a Lambertian point source at (0, 0, height) aimed down; E = I0 h2/d4 on the floor."""
    squared = height**2 + points[:, 0] ** 2 + points[:, 1] ** 2
    return intensity * height**2 / squared**2


def cie171_area(points, normals, intensity=1000.0):
    """CIE 171:2006, 5.3: a luminous square of 1 m at the ceiling centre of a black room 4 x 4 x 3 m; E = M F."""
    square = [(1.5, 1.5, 3), (2.5, 1.5, 3), (2.5, 2.5, 3), (1.5, 2.5, 3)]
    return np.array([np.pi * intensity * polygon_form_factor(p, n, square) for p, n in zip(points, normals)])


def isotropic_point(points, normals, position, flux):
    """Illuminance from an isotropic point source with nothing between: Phi cos/(4 pi d2)."""
    to = position - points
    distance = np.linalg.norm(to, axis=1)
    return flux * (to * normals).sum(axis=1) / (4 * np.pi * distance**3)


def cie171_reflection(points, normals):
    """CIE 171:2006, 5.6: E/(E_floor rho) under the ceiling and on a wall over a floor 4 x 4 m, black elsewhere."""
    floor = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]
    return np.array([polygon_form_factor(p, n, floor) for p, n in zip(points, normals)])


def cie171_obstruction(points, normals):
    """CIE 171:2006, 5.7: E/(E_wall rho) from the wall y = 4 (4 x 3 m) past a block y 2.5 to 2.7, z 0 to 1.

    The block spans the room, so that it hides the wall below a level line: form factor of what is left. (The table
    printed in the report is wrong.)
    """
    result = []
    for (x, y, z), normal in zip(points, normals):
        cut = max([z + (1 - z) * (4 - y) / (edge - y) for edge in (2.5, 2.7)] + [0.0])
        corners = [(0, 4, cut), (4, 4, cut), (4, 4, 3), (0, 4, 3)]
        result.append(polygon_form_factor(np.array([x, y, z]), normal, corners) if cut < 3 else 0.0)
    return np.array(result)
