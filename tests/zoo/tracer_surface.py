# SPDX-License-Identifier: BSD-3-Clause
"""Rays and reflection of the tracer, compiled by numba. Double precision throughout."""
import numpy as np
from numba import njit

NEAR = 1e-9  # of a ray's length or m: what lies nearer to its start is the surface that it leaves
fast = njit(error_model="numpy")  # not cached: numba would not notice a change in what a function calls


@fast
def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@fast
def add(a, s, b):
    return (a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2])


@fast
def scaled(s, a):
    return (s * a[0], s * a[1], s * a[2])


@fast
def vector(table, i):
    return (table[i, 0], table[i, 1], table[i, 2])


@fast
def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@fast
def unit(a):
    return scaled(1 / np.sqrt(dot(a, a)), a)


@fast
def frame(n):
    """Two unit vectors that make a right-handed system with n."""
    helper = (1.0, 0.0, 0.0) if abs(n[0]) < 0.6 else (0.0, 1.0, 0.0)
    t = unit(cross(helper, n))
    return t, cross(n, t)


@fast
def to_world(n, local):
    t, b = frame(n)
    return add(add(scaled(local[0], t), local[1], b), local[2], n)


@fast
def cosine_direction(n):
    r, phi = np.sqrt(np.random.random()), 2 * np.pi * np.random.random()
    return to_world(n, (r * np.cos(phi), r * np.sin(phi), np.sqrt(max(0.0, 1 - r * r))))


@fast
def hit(s, origin, direction, far, anything):
    """The nearest triangle up to `far` (or any), and its distance; -1 without one."""
    inverse = (1 / direction[0], 1 / direction[1], 1 / direction[2])
    stack = np.empty(64, np.int64)
    stack[0], depth, found = 0, 1, -1
    while depth > 0:
        depth -= 1
        node = stack[depth]
        enter, leave = 0.0, far
        for k in range(3):
            if direction[k] == 0:
                if not s.low[node, k] <= origin[k] <= s.high[node, k]:
                    leave = -1.0
                continue
            a, b = (s.low[node, k] - origin[k]) * inverse[k], (s.high[node, k] - origin[k]) * inverse[k]
            if a > b:
                a, b = b, a
            enter, leave = max(enter, a), min(leave, b)
        if enter > leave * (1 + 1e-12) + 1e-12:
            continue
        if s.count[node] == 0:
            stack[depth], stack[depth + 1] = s.first[node], s.first[node] + 1
            depth += 2
            continue
        for i in range(s.first[node], s.first[node] + s.count[node]):
            u, v = vector(s.side_u, i), vector(s.side_v, i)
            p = cross(direction, v)
            determinant = dot(u, p)
            if determinant == 0:
                continue
            to = add(origin, -1.0, vector(s.corner, i))
            a = dot(to, p) / determinant
            if a < -1e-12 or a > 1 + 1e-12:
                continue
            q = cross(to, u)
            b = dot(direction, q) / determinant
            if b < -1e-12 or a + b > 1 + 1e-12:
                continue
            t = dot(v, q) / determinant
            if NEAR < t < far:
                found, far = i, t
                if anything:
                    return found, far
    return found, far


@fast
def visible(s, a, b):
    to = add(b, -1.0, a)
    distance = np.sqrt(dot(to, to))
    return distance > 0 and hit(s, a, scaled(1 / distance, to), distance * (1 - NEAR) - NEAR, True)[0] < 0


@fast
def lobe_albedo(s, i, mu):
    x = min(max(mu, 0.0), 1.0) * (s.albedo.shape[1] - 1)
    k = min(int(x), s.albedo.shape[1] - 2)
    table = s.albedo[s.gloss[i]]
    return table[k] + (x - k) * (table[k + 1] - table[k])


@fast
def smith(alpha, mu):
    return (np.sqrt(1 + alpha * alpha * (1 / (mu * mu) - 1)) - 1) / 2


@fast
def normals(alpha, cosine):
    """GGX's density of normals, 1/sr."""
    spread = 1 - cosine * cosine * (1 - alpha * alpha)
    return alpha * alpha / (np.pi * spread * spread)


@fast
def schlick(f0, cosine):
    return f0 + (1 - f0) * (1 - cosine) ** 5


@fast
def lobe(s, i, n, wi, wo):
    """The lobe's part of reflection()."""
    mi, mo = dot(n, wi), dot(n, wo)
    if s.gloss[i] < 0 or mi <= 0 or mo <= 0:
        return 0.0
    half = unit(add(wi, 1.0, wo))
    d = normals(s.alpha[i], dot(half, n))
    masking = 1 / (1 + smith(s.alpha[i], mi) + smith(s.alpha[i], mo))
    return (1 - s.mirror[i]) * d * schlick(s.specular[i], dot(half, wo)) * masking / (4 * mi * mo)


@fast
def reflection(s, i, n, wi, wo):
    """BRDF (1/sr) of triangle i without its mirror, and the densities of drawing wi from wo, and wo from wi, survival included.

    f = rho/pi (1 - A(mi)) (1 - A(mo)) / (1 - A_mean) + (1 - m) D F G2 / (4 mi mo), GGX with Smith's height-correlated masking.
    """
    mi, mo = dot(n, wi), dot(n, wo)
    if mi <= 0 or mo <= 0:
        return 0.0, 0.0, 0.0
    rho = s.reflectance[i]
    if s.gloss[i] < 0:
        return rho / np.pi, rho * mi / np.pi, rho * mo / np.pi
    d, kept = normals(s.alpha[i], dot(unit(add(wi, 1.0, wo)), n)), 1 - s.mirror[i]
    li, lo = smith(s.alpha[i], mi), smith(s.alpha[i], mo)
    ai, ao = lobe_albedo(s, i, mi), lobe_albedo(s, i, mo)
    f = rho / np.pi * (1 - ai) * (1 - ao) / (1 - s.mean_albedo[s.gloss[i]]) + lobe(s, i, n, wi, wo)
    forward = rho * (1 - ao) * mi / np.pi + kept * ao * d / ((1 + lo) * 4 * mo)
    backward = rho * (1 - ai) * mo / np.pi + kept * ai * d / ((1 + li) * 4 * mi)
    return f, forward, backward


@fast
def scatter(s, i, n, wo):
    """A direction drawn from the reflection of triangle i: 0 absorbed, 1 drawn, 2 by the mirror; the direction."""
    u = np.random.random() - s.mirror[i]
    if u < 0:
        return 2, add(scaled(2 * dot(n, wo), n), -1.0, wo)
    mo = dot(n, wo)
    lobe = lobe_albedo(s, i, mo) if s.gloss[i] >= 0 else 0.0
    u -= s.reflectance[i] * (1 - lobe)
    if u < 0:
        return 1, cosine_direction(n)
    if u >= (1 - s.mirror[i]) * lobe:
        return 0, n
    t, b = frame(n)
    alpha = s.alpha[i]
    view = unit((alpha * dot(t, wo), alpha * dot(b, wo), mo))
    across = np.hypot(view[0], view[1])
    t1 = (-view[1] / across, view[0] / across, 0.0) if across > 0 else (1.0, 0.0, 0.0)
    t2 = cross(view, t1)
    r, phi = np.sqrt(np.random.random()), 2 * np.pi * np.random.random()
    p1 = r * np.cos(phi)
    p2 = (1 - view[2]) / 2 * np.sqrt(max(0.0, 1 - p1 * p1)) + (1 + view[2]) / 2 * r * np.sin(phi)
    m = add(add(scaled(p1, t1), p2, t2), np.sqrt(max(0.0, 1 - p1 * p1 - p2 * p2)), view)
    m = unit((alpha * m[0], alpha * m[1], max(1e-12, m[2])))
    m = add(add(scaled(m[0], t), m[1], b), m[2], n)
    wi = add(scaled(2 * dot(m, wo), m), -1.0, wo)
    return (1, wi) if dot(n, wi) > 0 else (0, n)
