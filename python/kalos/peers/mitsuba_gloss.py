# SPDX-License-Identifier: BSD-3-Clause
"""Path tracing of glossy surfaces and mirrors in Kalos's own reflection model (material/Brdf.h), for kalos.peers.mitsuba_worker.

Directions are drawn from the whole reflection: cosine-weighted, by visible normals of the lobe, or the mirror's. At a lobe
what is sampled of rectangles and emitting meshes is weighed by the balance heuristic against a ray that hits them. What is
found is pi times a luminance: a receiver is a white diffuse surface, a pixel is the surface point that it sees.
"""
import drjit as dr
import mitsuba as mi
import numpy as np
from mitsuba import Float, Frame3f, Mask, Point3f, Ray3f, UInt32, Vector3f
from mitsuba_lamps import offset
from mitsuba_worker import EMITTER_SAMPLES, ROULETTE, Tracer


class GlossyTracer(Tracer):
    def __init__(self, scene):
        super().__init__(scene)
        count = len(scene["triangles"])
        white = np.ones((1, self.bands), np.float32)
        self.reflectance = [Float(np.ascontiguousarray(c)) for c in np.vstack([scene["reflectance"], white]).T]
        self.mean = Float(np.append(scene["reflectance"].mean(axis=1), 1))
        row = np.append(scene["lobe"], len(scene["albedo"]))  # of the receivers: no lobe
        self.entries = scene["albedo"].shape[1]
        self.albedo = Float(np.append(scene["albedo"].ravel(), np.zeros(self.entries)).astype(np.float32))
        self.row = UInt32(row.astype(np.uint32))
        self.kept = Float((1 / (1 - np.append(scene["albedo_mean"], 0)))[row].astype(np.float32))
        self.specular, self.alpha, self.mirror = (Float(np.append(scene[name], end).astype(np.float32))
                                                  for name, end in (("specular", 0), ("alpha", 1), ("mirror", 0)))
        first = np.where(scene["first"] < 0, count, scene["first"]).astype(np.uint32)
        outgoing = np.where((scene["first"] < 0)[:, None], scene["normals"], scene["outgoing"]).astype(np.float32)
        self.first, self.outgoing = UInt32(first), Vector3f(np.ascontiguousarray(outgoing.T))
        self.exact_direct = self.exact_direct and not self.lamps.measured
        self.bodies(scene)

    def bodies(self, scene):
        """Rectangles as a scene of their own, for rays to hit."""
        own = self.lamps.count and self.lamps.rectangles
        self.rectangles = None
        if not own:
            return
        index = np.flatnonzero(self.lamps.area)
        u, v = (scene[f"lamp_{name}"][index] / 2 for name in "uv")
        middle = scene["lamp_position"][index]
        ring = [middle - u - v, middle + u - v, middle + u + v, middle - u + v]
        corners = np.stack([ring[0], ring[1], ring[2], ring[0], ring[2], ring[3]], axis=1).astype(np.float32)
        mesh = mi.Mesh("lamps", corners.shape[0] * 6, corners.shape[0] * 2, has_vertex_normals=False, has_vertex_texcoords=False)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = Float(corners.reshape(-1))
        parameters["faces"] = UInt32(np.arange(6 * len(index), dtype=np.uint32))
        parameters.update()
        self.rectangles = mi.load_dict({"type": "scene", "mesh": mesh})
        share = scene["lamp_flux"] / scene["lamp_flux"].sum()
        area = self.lamps.area[index]
        self.rectangle_axis = Vector3f(np.ascontiguousarray(scene["lamp_axis"][index].T.astype(np.float32)))
        self.rectangle_exitance = Float((scene["lamp_flux"][index] / area).astype(np.float32))
        self.rectangle_density = Float((share[index] / area).astype(np.float32))  # 1/m2 of being sampled

    def lobe_at(self, material, mu):
        x = dr.clip(mu, 0, 1) * (self.entries - 1)
        k = dr.minimum(UInt32(x), self.entries - 2)
        at = dr.gather(UInt32, self.row, material) * self.entries + k
        return dr.lerp(dr.gather(Float, self.albedo, at), dr.gather(Float, self.albedo, at + 1), x - Float(k))

    def shares(self, material, mu):
        """Of the diffuse part, the lobe and the mirror in what is reflected of light from the cosine mu."""
        lobe, mirror = self.lobe_at(material, mu), dr.gather(Float, self.mirror, material)
        return dr.gather(Float, self.mean, material) * (1 - lobe), (1 - mirror) * lobe, mirror

    def evaluate(self, material, n, wi, wo):
        """pi f per band without the mirror, and the density per sr with which draw() chooses wi; 0 below the surface."""
        frame = Frame3f(n)
        i, o = frame.to_local(wi), frame.to_local(wo)
        above = (i.z > 0) & (o.z > 0)
        mi_, mo = dr.maximum(i.z, 1e-6), dr.maximum(o.z, 1e-6)
        alpha, f0 = dr.gather(Float, self.alpha, material), dr.gather(Float, self.specular, material)
        m = dr.normalize(i + o)
        t = (m.x * m.x + m.y * m.y) / (alpha * alpha) + m.z * m.z
        spread = 1 / (dr.pi * alpha * alpha * t * t)
        fresnel = f0 + (1 - f0) * (1 - dr.clip(dr.dot(o, m), 0, 1)) ** 5
        to, back = smith(alpha, i), smith(alpha, o)
        diffuse, lobe, mirror = self.shares(material, o.z)
        shiny = dr.select(f0 > 0, (1 - mirror) * dr.pi * spread * fresnel / ((1 + to + back) * 4 * mi_ * mo), 0)
        kept = (1 - self.lobe_at(material, o.z)) * (1 - self.lobe_at(material, i.z)) * dr.gather(Float, self.kept, material)
        density = diffuse * mi_ / dr.pi + dr.select(f0 > 0, lobe * spread / ((1 + back) * 4 * mo), 0)
        density /= dr.maximum(diffuse + lobe + mirror, 1e-12)
        f = [dr.select(above, kept * dr.gather(Float, rho, material) + shiny, 0) for rho in self.reflectance]
        return f, dr.select(above, density, 0)

    def draw(self, material, n, wo, sampler, active):
        """A direction, whether it is the mirror's, its density, and what it carries per band."""
        u0, u = sampler.next_1d(active), sampler.next_2d(active)
        frame = Frame3f(n)
        o = frame.to_local(wo)
        diffuse, lobe, mirror = self.shares(material, o.z)
        total = diffuse + lobe + mirror
        x = u0 * total
        is_mirror, is_lobe = x < mirror, (x >= mirror) & (x < mirror + lobe)
        m = visible_normal(dr.gather(Float, self.alpha, material), o, u)
        shiny = frame.to_world(2 * dr.dot(o, m) * m - o)
        even = frame.to_world(mi.warp.square_to_cosine_hemisphere(u))
        d = dr.select(is_mirror, 2 * dr.dot(wo, n) * n - wo, dr.select(is_lobe, shiny, even))
        f, density = self.evaluate(material, n, d, wo)
        cosine = dr.maximum(dr.dot(d, n), 0)
        weight = [dr.select(is_mirror, total, dr.select(density > 0, one * cosine / (dr.pi * density), 0)) for one in f]
        return d, is_mirror, density, weight

    def response(self, material, n, d, wo, active):
        """pi f times the cosine per band, and the density of a ray there; the latter 0 where rays are not weighed."""
        f, density = self.evaluate(material, n, d, wo)
        cosine = dr.maximum(dr.dot(d, n), 0)
        weighed = dr.gather(Float, self.specular, material) > 0
        return [one * cosine for one in f], dr.select(weighed, density, 0)

    def lights_at(self, p, n, wo, material, sampler, active):
        """pi times the luminance that one sample of the luminaires and one of the meshes make, per band, and the rays it took."""
        found, rays = [Float(0)] * self.bands, UInt32(0)
        if self.lamps.count:
            d, across, to, sampled = self.lamps.sample(p, sampler, active)
            f, density = self.response(material, n, d, wo, active)
            weight = dr.select(sampled > 0, sampled / (sampled + density), 1) if self.lamps.rectangles else Float(1)
            facing = active & (across > 0) & (dr.dot(d, n) > 0)
            seen = self.visible(p, n, to, facing)
            found = [a + dr.select(seen, across * weight * b, 0) for a, b in zip(found, f)]
            rays += dr.select(facing, UInt32(1), UInt32(0))
        if self.sampled:
            d, d2, at_lamp, to, i = self.mesh_sample(p, sampler, active)
            f, _ = self.response(material, n, d, wo, active)
            _, density = self.evaluate(material, n, d, wo)
            own = dr.gather(Float, self.triangle_density, i, active)
            facing = active & (at_lamp > 0) & (dr.dot(d, n) > 0)
            seen = self.visible(p, n, to, facing)
            kernel = at_lamp / (dr.pi * d2)
            weight = dr.select(seen, kernel / (own + density * at_lamp / d2), 0)
            found = [a + weight * b * dr.gather(Float, m, i, active) for a, b, m in zip(found, f, self.exitance)]
            rays += dr.select(facing, UInt32(1), UInt32(0))
        return found, rays

    def mesh_sample(self, p, sampler, active):
        i = self.triangle_choice.sample(sampler.next_1d(active), active)
        b = mi.warp.square_to_uniform_triangle(sampler.next_2d(active))
        a0, a1, a2 = (dr.gather(Point3f, c, i, active) for c in self.corners)
        to = a0 + b.x * (a1 - a0) + b.y * (a2 - a0)
        d = to - p
        d2 = dr.squared_norm(d)
        d *= dr.rsqrt(d2)
        return d, d2, dr.maximum(-dr.dot(d, dr.gather(Vector3f, self.triangle_normal, i, active)), 0), to, i

    def direct(self, seed, samples):
        count = 1 if self.exact_direct else EMITTER_SAMPLES * samples
        sampler, active = self.sampler(seed, self.receivers), Mask(True)

        def step(i, found, rays, sampler):
            light, shot = self.lights_at(self.points, self.normals, self.outgoing, self.first, sampler, active)
            return i + 1, [f + one for f, one in zip(found, light)], rays + shot, sampler

        none = dr.zeros(UInt32, self.receivers)
        limit = dr.opaque(UInt32, count)
        state = (none, [dr.zeros(Float, self.receivers)] * self.bands, none, sampler)
        _, found, rays, _ = dr.while_loop(state, lambda i, *_: i < limit, step)
        dr.eval(found, rays)
        return [f / limit for f in found], rays

    def found_lamp(self, ray, end, is_mirror, weighed, density, active):
        """Exitance of a rectangle that the ray meets before `end`, times its weight."""
        ray = Ray3f(ray.o, ray.d, end, 0, [])
        hit = self.rectangles.ray_intersect_preliminary(ray, coherent=False, active=active & (is_mirror | weighed))
        i = hit.prim_index // 2
        valid = active & (is_mirror | weighed) & hit.is_valid()
        facing = -dr.dot(ray.d, dr.gather(Vector3f, self.rectangle_axis, i, valid))
        valid &= facing > 0
        sampled = dr.gather(Float, self.rectangle_density, i, valid) * hit.t * hit.t / dr.maximum(facing, 1e-6)
        weight = dr.select(is_mirror, 1, density / dr.maximum(density + sampled, 1e-20))
        return dr.select(valid, weight * dr.gather(Float, self.rectangle_exitance, i, valid), 0)

    def paths(self, seed, count):
        lanes = self.receivers * count
        receiver = dr.arange(UInt32, lanes) // dr.opaque(UInt32, count)
        start = [dr.gather(Point3f, self.points, receiver)] + [dr.gather(Vector3f, one, receiver) for one in (self.normals, self.outgoing)]

        def step(p, n, wo, material, beta, found, depth, rays, active, sampler):
            direction, is_mirror, density, weight = self.draw(material, n, wo, sampler, active)
            active &= dr.dot(direction, n) > 0
            beta = [dr.select(active, b * w, 0) for b, w in zip(beta, weight)]
            ray = Ray3f(offset(p, n), direction)
            hit = self.scene.ray_intersect_preliminary(ray, coherent=False, active=active)
            rays = rays + dr.select(active, UInt32(1), 0)
            if self.rectangles is not None:
                weighed = dr.gather(Float, self.specular, material) > 0
                light = self.found_lamp(ray, dr.select(hit.is_valid(), hit.t, dr.inf), is_mirror, weighed, density, active)
                found = [f + b * light for f, b in zip(found, beta)]
            active &= hit.is_valid()
            si = hit.compute_surface_interaction(ray, mi.RayFlags.Minimal, active)
            front = dr.dot(si.n, direction) < 0
            if self.emits:
                share = Float(1)
                if self.sampled:
                    kernel = density * dr.abs(dr.dot(si.n, direction)) / (hit.t * hit.t)
                    share = dr.select(is_mirror, 1, kernel / dr.maximum(kernel + dr.gather(Float, self.triangle_density, hit.prim_index, active), 1e-20))
                found = [f + b * share * dr.gather(Float, m, hit.prim_index, active & front)
                         for f, b, m in zip(found, beta, self.exitance)]
            p, n, wo, material = si.p, Vector3f(dr.select(front, si.n, -si.n)), -direction, hit.prim_index
            largest = beta[0]
            for b in beta[1:]:
                largest = dr.maximum(largest, b)
            active &= largest > 0
            if self.samples_lights:
                light, shot = self.lights_at(p, n, wo, material, sampler, active)
                found, rays = [f + dr.select(active, b * one, 0) for f, b, one in zip(found, beta, light)], rays + shot
            diffuse, lobe, mirror = self.shares(material, dr.dot(n, wo))
            depth = depth + 1
            survival = dr.select(depth >= ROULETTE, dr.minimum(largest * (diffuse + lobe + mirror), 0.95), 1)
            active &= sampler.next_1d(active) < survival
            return p, n, wo, material, [b / survival for b in beta], found, depth, rays, active, sampler

        state = (*start, dr.gather(UInt32, self.first, receiver), [dr.ones(Float, lanes)] * self.bands,
                 [dr.zeros(Float, lanes)] * self.bands, dr.zeros(UInt32, lanes), dr.zeros(UInt32, lanes), dr.full(Mask, True, lanes),
                 self.sampler(seed, lanes, count))
        *_, found, _, rays, _, _ = dr.while_loop(state, lambda *s: s[8], step)
        dr.eval(found, rays)
        return [dr.block_sum(f, count) for f in found], rays


def smith(alpha, w):
    """Smith's Lambda of GGX."""
    return 0.5 * (dr.sqrt(1 + alpha * alpha * (w.x * w.x + w.y * w.y) / dr.maximum(w.z * w.z, 1e-12)) - 1)


def visible_normal(alpha, w, u):
    """A normal in proportion to the area that w sees of it (Heitz 2018)."""
    v = dr.normalize(Vector3f(alpha * w.x, alpha * w.y, w.z))
    r, phi = dr.sqrt(u.x), 2 * dr.pi * u.y
    flat = dr.sqrt(v.x * v.x + v.y * v.y)
    t1 = dr.select(flat > 1e-9, Vector3f(-v.y, v.x, 0) / dr.maximum(flat, 1e-12), Vector3f(1, 0, 0))
    t2 = dr.cross(v, t1)
    p1, blend = r * dr.cos(phi), 0.5 * (1 + v.z)
    p2 = (1 - blend) * dr.sqrt(dr.maximum(1 - p1 * p1, 0)) + blend * r * dr.sin(phi)
    m = p1 * t1 + p2 * t2 + dr.sqrt(dr.maximum(1 - p1 * p1 - p2 * p2, 0)) * v
    return dr.normalize(Vector3f(alpha * m.x, alpha * m.y, dr.maximum(m.z, 1e-12)))

