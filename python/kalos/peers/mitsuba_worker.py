# SPDX-License-Identifier: BSD-3-Clause
"""Path tracing on Mitsuba 3 and Dr.Jit: all receivers in one wavefront, one recorded loop. Run by kalos.peers.mitsuba3.

    python mitsuba_worker.py SCENE.npz THREADS

answers every line {"effort": n, "seed": k, "out": "FILE.npy"} on standard input by one line of JSON on standard output,
after a first one about the set-up. It is a program of its own, so that any interpreter that has Mitsuba serves.

It estimates E(r) = E_direct(r) + E[rho E(y) + M(y)] over cosine-weighted rays r -> y, as Mitsuba's own `path` does from a
white diffuse receiver (E is pi times what that reflects): emitters are sampled at every vertex, roulette on the largest
band of the throughput starts at vertex ROULETTE. It was tuned to be worth beating: multijittered samples; direct light by
one ray where that is exact, else by EMITTER_SAMPLES per path; emission of meshes found by the paths alone where most of
the scene emits, and weighed by the balance heuristic against sampling where little does.
"""
import json
import os
import sys
import time

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_mono")

from mitsuba import Float, Mask, Point3f, Ray3f, UInt32, Vector3f  # noqa: E402
from mitsuba_lamps import Lamps, offset  # noqa: E402

ROULETTE = 4  # vertices before it; 3 to 5 are alike
EMITTER_SAMPLES = 8  # at the receiver, where there is more than one luminaire or an area
EMITTING = 0.25  # share of the surface above which sampling emitting meshes does not pay
LANES = 1 << 22  # of a wavefront at most, for the sake of memory


class Tracer:
    def __init__(self, scene):
        self.bands = scene["reflectance"].shape[1]
        self.points, self.normals = Point3f(scene["points"].T.copy()), Vector3f(scene["normals"].T.copy())
        self.receivers = len(scene["points"])
        triangles = scene["triangles"]
        self.reflectance = [Float(np.ascontiguousarray(c)) for c in scene["reflectance"].T]
        self.exitance = [Float(np.ascontiguousarray(c)) for c in scene["exitance"].T]
        self.emits = bool(scene["exitance"].any())
        mesh = mi.Mesh("scene", 3 * len(triangles), len(triangles), has_vertex_normals=False, has_vertex_texcoords=False)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = Float(triangles.reshape(-1))
        parameters["faces"] = UInt32(np.arange(3 * len(triangles), dtype=np.uint32))
        parameters.update()
        self.scene = mi.load_dict({"type": "scene", "mesh": mesh})
        self.lamps = Lamps(scene)
        self.emitters(triangles, scene["exitance"])
        self.samples_lights = self.lamps.count > 0 or self.sampled
        self.exact_direct = not self.sampled and self.lamps.count == 1 and not scene["lamp_u"].any()

    def emitters(self, triangles, exitance):
        """Emitting triangles, for sampling in proportion to their flux."""
        across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        area = np.linalg.norm(across, axis=1) / 2
        mean = exitance.mean(axis=1)
        self.sampled = self.emits and area[mean > 0].sum() < EMITTING * area.sum()
        if self.sampled:
            flux = (area * mean).astype(np.float32)
            self.triangle_choice = mi.DiscreteDistribution(Float(flux))
            self.triangle_density = Float((mean / (area * mean).sum()).astype(np.float32))  # 1/m2 of the surface
            self.corners = [Point3f(np.ascontiguousarray(triangles[:, k].T)) for k in range(3)]
            self.triangle_normal = Vector3f(np.ascontiguousarray((across / (2 * area[:, None])).T.astype(np.float32)))

    def visible(self, p, n, to, active):
        origin = offset(p, n)
        target = to - origin
        distance = dr.norm(target)
        return active & ~self.scene.ray_test(Ray3f(origin, target / distance, distance * (1 - 1e-4), 0, []), active)

    def lamp_light(self, p, n, sampler, active):
        """Illuminance at p from one luminaire, over the chance of picking it, and the rays it took."""
        d, across, to, _ = self.lamps.sample(p, sampler, active)
        light = across * dr.maximum(dr.dot(d, n), 0)
        facing = active & (light > 0)
        seen = self.visible(p, n, to, facing)
        return dr.select(seen, light, 0), dr.select(facing, UInt32(1), UInt32(0))

    def mesh_light(self, p, n, sampler, active):
        """The same from an emitting triangle: exitance of unit bands, weighed against finding it by a path."""
        i = self.triangle_choice.sample(sampler.next_1d(active), active)
        b = mi.warp.square_to_uniform_triangle(sampler.next_2d(active))
        a0, a1, a2 = (dr.gather(Point3f, c, i, active) for c in self.corners)
        to = a0 + b.x * (a1 - a0) + b.y * (a2 - a0)
        d = to - p
        d2 = dr.squared_norm(d)
        d *= dr.rsqrt(d2)
        at_lamp = dr.maximum(-dr.dot(d, dr.gather(Vector3f, self.triangle_normal, i, active)), 0)
        at_point = dr.maximum(dr.dot(d, n), 0)
        kernel = at_lamp * at_point / (dr.pi * d2)  # also the density of a path's ray there, 1/m2
        density = dr.gather(Float, self.triangle_density, i, active)
        facing = active & (kernel > 0)
        seen = self.visible(p, n, to, facing)
        weight = dr.select(seen, kernel / (density + kernel), 0)
        return [weight * dr.gather(Float, m, i, active) for m in self.exitance], dr.select(facing, UInt32(1), UInt32(0))

    def direct(self, seed, samples):
        """Illuminance straight from what is sampled, per band: one ray where that is exact, else several per path."""
        count = 1 if self.exact_direct else EMITTER_SAMPLES * samples
        sampler = self.sampler(seed, self.receivers)
        active = Mask(True)

        def step(i, found, rays, sampler):
            light, shot = self.lights(self.points, self.normals, sampler, active)
            return i + 1, [f + one for f, one in zip(found, light)], rays + shot, sampler

        none = dr.zeros(UInt32, self.receivers)
        state = (none, [dr.zeros(Float, self.receivers)] * self.bands, none, sampler)
        limit = dr.opaque(UInt32, count)
        _, found, rays, _ = dr.while_loop(state, lambda i, *_: i < limit, step)
        dr.eval(found, rays)
        return [f / limit for f in found], rays

    def paths(self, seed, count):
        """What `count` paths from each receiver gather, in all, without direct light that is sampled; and the rays."""
        lanes = self.receivers * count
        receiver = dr.arange(UInt32, lanes) // dr.opaque(UInt32, count)
        p, n = dr.gather(Point3f, self.points, receiver), dr.gather(Vector3f, self.normals, receiver)

        def step(p, n, beta, found, depth, rays, active, sampler):
            direction = mi.Frame3f(n).to_world(mi.warp.square_to_cosine_hemisphere(sampler.next_2d(active)))
            ray = Ray3f(offset(p, n), direction)
            hit = self.scene.ray_intersect_preliminary(ray, coherent=False, active=active)
            rays = rays + dr.select(active, UInt32(1), 0)
            active &= hit.is_valid()
            si = hit.compute_surface_interaction(ray, mi.RayFlags.Minimal, active)
            front = dr.dot(si.n, direction) < 0
            if self.emits:
                weight = self.path_weight(n, direction, hit, si, active)
                found = [f + b * weight * dr.gather(Float, m, hit.prim_index, active & front)
                         for f, b, m in zip(found, beta, self.exitance)]
            p, n = si.p, Vector3f(dr.select(front, si.n, -si.n))
            beta = [b * dr.gather(Float, rho, hit.prim_index, active) for b, rho in zip(beta, self.reflectance)]
            largest = beta[0]
            for b in beta[1:]:
                largest = dr.maximum(largest, b)
            active &= largest > 0
            if self.samples_lights:
                light, shot = self.lights(p, n, sampler, active)
                found, rays = [f + b * one for f, b, one in zip(found, beta, light)], rays + shot
            depth = depth + 1
            survival = dr.select(depth >= ROULETTE, dr.minimum(largest, 0.95), 1)
            active &= sampler.next_1d(active) < survival
            return p, n, [b / survival for b in beta], found, depth, rays, active, sampler

        state = (p, n, [dr.ones(Float, lanes)] * self.bands, [dr.zeros(Float, lanes)] * self.bands, dr.zeros(UInt32, lanes),
                 dr.zeros(UInt32, lanes), dr.full(Mask, True, lanes), self.sampler(seed, lanes, count))
        *_, found, _, rays, _, _ = dr.while_loop(state, lambda *s: s[6], step)
        dr.eval(found, rays)  # one launch for all that is asked of it
        return [dr.block_sum(f, count) for f in found], rays

    def lights(self, p, n, sampler, active):
        """Illuminance at p by one sample of the luminaires and one of the meshes, and the rays it took."""
        found, rays = [Float(0)] * self.bands, UInt32(0)
        if self.lamps.count:
            light, shot = self.lamp_light(p, n, sampler, active)
            found, rays = [f + light for f in found], rays + shot
        if self.sampled:
            light, shot = self.mesh_light(p, n, sampler, active)
            found, rays = [f + one for f, one in zip(found, light)], rays + shot
        return found, rays

    @staticmethod
    def sampler(seed, lanes, spread=1):
        """Random numbers of so many lanes, multijittered over every `spread` of them."""
        if spread == 1:
            sampler = mi.load_dict({"type": "independent"})
        else:
            sampler = mi.load_dict({"type": "multijitter", "sample_count": spread})
            sampler.set_samples_per_wavefront(spread)
        sampler.seed(dr.opaque(UInt32, seed), lanes)
        return sampler

    def path_weight(self, n, direction, hit, si, active):
        """Of an emission that a path has found: 1, or less where it could have been sampled."""
        if not self.sampled:
            return Float(1)
        kernel = dr.maximum(dr.dot(n, direction), 0) * dr.abs(dr.dot(si.n, direction)) / (dr.pi * hit.t * hit.t)
        return kernel / (kernel + dr.gather(Float, self.triangle_density, hit.prim_index, active))

    def run(self, effort, seed):
        """Illuminance of every receiver per band, the paths per receiver that it took, and the rays."""
        passes = -(-effort * self.receivers // LANES)
        count = mi.load_dict({"type": "multijitter", "sample_count": max(2, effort // passes)}).sample_count()
        values, shots = np.zeros((self.receivers, self.bands)), 0
        parts = [(self.paths(2 * (seed * passes + k), count), passes * count) for k in range(passes)]
        if self.samples_lights:
            parts.append((self.direct(2 * seed * passes + 1, passes * count), 1))
        for (found, rays), share in parts:
            dr.eval(found)
            values += np.stack([f.numpy() for f in found], axis=1) / share
            shots += int(dr.sum(rays).numpy()[0])
        return values, passes * count, shots


def make(scene):
    """The tracer that the scene needs: most are Lambertian."""
    if not (scene["specular"].any() or scene["mirror"].any() or (scene["first"] >= 0).any()):
        return Tracer(scene)
    from mitsuba_gloss import GlossyTracer  # it is derived from the one here
    return GlossyTracer(scene)


def main(path, threads):
    start = time.process_time()
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # the libraries' own remarks are no answers
    dr.set_thread_count(threads)
    with np.load(path) as file:
        scene = {name: np.asarray(file[name], np.float32) if file[name].dtype == float else file[name] for name in file.files}
    tracer = make(scene)
    tracer.run(4, 0)  # compiles
    setup, compiled = time.process_time() - start, set()
    print(json.dumps({"setup_cpu_seconds": setup, "version": mi.__version__}), file=answers, flush=True)

    def timed(effort, seed):
        begun = time.process_time()
        found = tracer.run(effort, seed)
        return time.process_time() - begun, found

    for line in sys.stdin:
        job = json.loads(line)
        seconds, found = timed(job["effort"], job["seed"])
        if job["effort"] not in compiled:  # the kernels depend on it: the first run has compiled them
            compiled.add(job["effort"])
            again, found = timed(job["effort"], job["seed"])
            setup, seconds = setup + max(seconds - again, 0), again
        values, effort, rays = found
        np.save(job["out"], values)
        said = {"cpu_seconds": seconds, "effort": effort, "rays": rays, "setup_cpu_seconds": setup}
        print(json.dumps(said), file=answers, flush=True)


if __name__ == "__main__":
    sys.modules["mitsuba_worker"] = sys.modules["__main__"]  # for mitsuba_gloss
    main(sys.argv[1], int(sys.argv[2]))
