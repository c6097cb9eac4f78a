# SPDX-License-Identifier: BSD-3-Clause
"""Radiance's rtrace -I as a peer, without and with its irradiance cache; found through the Python package pyradiance or PATH.

Radiances are handed over as luminances, so that irradiances come back in lux. Radiance's luminaires are bodies: a point
becomes a disc or a sphere of RADIUS, a rectangle an `illum`, which nothing else sees. Surfaces that both reflect and emit
it does not have. The effort is -ad. Its random numbers start from the second that a run is started in (-u), so that no two
runs may start in the same one, and none can be repeated. Without the cache paths are ended by roulette (-lr 0)
below the weight (-lw) of half a ray, so that -ab 40 truncates next to nothing; with it -ab 8 does, as every bounce more
multiplies the time.

Gloss is Ward's model in its place of Kalos's: the same reflectances, the width of the lobe for its slope, no Fresnel term. It
agrees about as far as the lobes do: to some per cent beside narrow ones, and no further.
"""
import os
import resource
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

from kalos.peers import Absent, Run, clean_environment, interpreter

RADIUS = 1e-3  # m
LONGEST = 600  # processor seconds of a run before it is given up
COMMON = ["-h", "-I", "-fdd", "-u+", "-dt", "0", "-dc", "1", "-ds", "0.05", "-dj", "0", "-st", "0"]


def locate():
    """The folders of the programs and of their library."""
    probe = subprocess.run([interpreter(), "-c", "import pyradiance; print(pyradiance.__path__[0])"], env=clean_environment(),
                           capture_output=True, text=True, check=False)
    if probe.returncode == 0:
        folder = Path(probe.stdout.strip())
        return folder / "bin", folder / "lib"
    if shutil.which("rtrace") and os.environ.get("RAYPATH"):
        return Path(shutil.which("rtrace")).parent, os.environ["RAYPATH"]
    raise Absent(f"{interpreter()} has no pyradiance and PATH and RAYPATH no Radiance, expected a KALOS_PEERS_PYTHON that has")


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))


def colour(values):
    return " ".join(f"{x:.9g}" for x in np.broadcast_to(values, 3))


def description(scene):
    """The scene in Radiance's own language."""
    lines = []
    lobes = np.stack([scene["specular"], scene["alpha"]], axis=1)
    kinds, index = np.unique(np.hstack([scene["reflectance"], scene["exitance"], lobes]), axis=0, return_inverse=True)
    bands = scene["reflectance"].shape[1]
    for k, kind in enumerate(kinds):
        reflectance, exitance, (specular, alpha) = kind[:bands], kind[bands:-2], kind[-2:]
        if exitance.any():
            lines.append(f"void light m{k} 0 0 3 {colour(exitance / np.pi)}")
        else:
            lines.append(f"void plastic m{k} 0 0 5 {colour(reflectance)} {specular:.9g} {alpha if specular else 0:.9g}")
    for i, (corners, k) in enumerate(zip(scene["triangles"], index.ravel())):
        lines.append(f"m{k} polygon t{i} 0 0 9 " + " ".join(f"{x:.17g}" for x in corners.ravel()))
    for i, flux in enumerate(scene["lamp_flux"]):
        position, axis, u, v = (scene[f"lamp_{name}"][i] for name in ("position", "axis", "u", "v"))
        if u.any():
            area = np.linalg.norm(np.cross(u, v))
            v = v if np.cross(u, v) @ axis > 0 else -v
            ring = [position + a * u + b * v for a, b in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
            lines.append(f"void illum l{i} 1 void 0 3 {colour(flux / (np.pi * area))}")
            lines.append(f"l{i} polygon b{i} 0 0 12 " + " ".join(f"{x:.17g}" for x in np.ravel(ring)))
        else:
            isotropic = scene["lamp_isotropic"][i]
            intensity = flux / (4 * np.pi if isotropic else np.pi)
            lines.append(f"void light l{i} 0 0 3 {colour(intensity / (np.pi * RADIUS**2))}")
            place = " ".join(f"{x:.17g}" for x in position)
            lines.append(f"l{i} sphere b{i} 0 0 4 {place} {RADIUS}" if isotropic else
                         f"l{i} ring b{i} 0 0 8 {place} " + " ".join(f"{x:.17g}" for x in axis) + f" 0 {RADIUS}")
    return "\n".join(lines) + "\n"


class Radiance:
    NAME, LABEL, EFFORT, START = "radiance", "Radiance, no cache", "-ad", 4
    SETTINGS = ["-aa", "0", "-as", "0", "-ab", "40", "-lr", "0"]

    def __init__(self, scene, threads=1):
        if scene["reflectance"].shape[1] not in (1, 3):
            raise Absent("Radiance has three bands, expected a scene of one or three")
        if ((scene["reflectance"] > 0).any(axis=1) & (scene["exitance"] > 0).any(axis=1)).any():
            raise Absent("Radiance has no surfaces that both reflect and emit, expected a scene without them")
        if scene["mirror"].any() or (scene["lamp_table"] >= 0).any() or (scene["first"] >= 0).any():
            raise Absent("only gloss at receivers is handed over, expected no mirrors, candela tables or images of gloss")
        programs, library = locate()
        response = scene["response"]
        self.response = response if response.shape[1] == 3 else np.repeat(response / 3, 3, axis=1)
        self.emitted = scene["emitted"]
        self.folder = tempfile.TemporaryDirectory(prefix="kalos-radiance-")
        self.path = Path(self.folder.name)
        self.environment = clean_environment(RAYPATH=str(library))
        self.rtrace, self.threads = [programs / "rtrace", *COMMON, "-n", str(threads)], threads
        (self.path / "scene.rad").write_text(description(scene), encoding="ascii")
        np.hstack([scene["points"], scene["normals"]]).astype(float).tofile(self.path / "points")
        np.hstack([scene["points"], scene["normals"]]).astype(float)[:1].tofile(self.path / "one")
        tree = self.measure([programs / "oconv", "scene.rad"], os.devnull, "scene.oct")
        self.start = self.measure([*self.rtrace, "-ab", "0", "scene.oct"], self.path / "one", "first")
        self.setup_cpu_seconds, self.second = tree + self.start, 0
        version = subprocess.run([programs / "rtrace", "-version"], env=self.environment, capture_output=True, text=True,
                                 check=False)
        self.version = (version.stdout.split() or ["unknown"])[1 if version.stdout.startswith("RADIANCE") else 0]

    def measure(self, command, source, out):
        """Runs a program from one file into another; its processor seconds."""
        with open(source, "rb") as read, open(self.path / out, "wb") as write, open(self.path / "log", "wb") as log:
            process = subprocess.Popen(command, cwd=self.path, stdin=read, stdout=write, stderr=log, env=self.environment,
                                       preexec_fn=limit)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            said = (self.path / "log").read_text(errors="replace").strip()
            raise Absent(f"Radiance stopped: {said or f'exit status {process.returncode}'}")
        return usage.ru_utime + usage.ru_stime

    def solve(self, effort, seed):  # the clock is the seed
        while int(time.time()) == self.second:
            time.sleep(0.02)
        self.second = int(time.time())
        settings = [*self.SETTINGS, "-ad", str(effort), "-lw", f"{self.weight(effort):.3g}"]
        seconds = self.measure([*self.rtrace, *settings, "scene.oct"], self.path / "points", "values")
        values = (np.fromfile(self.path / "values").reshape(-1, 3) * self.response).sum(axis=1) + self.emitted
        return Run(values, effort, max(seconds - self.start, 1e-3))

    @staticmethod
    def weight(effort):
        return 0.5 / effort

    def close(self):
        self.folder.cleanup()


class CachedRadiance(Radiance):
    NAME, LABEL, START = "radiance-cached", "Radiance, cached", 16
    SETTINGS = ["-aa", "0.2", "-ar", "64", "-as", "0", "-ab", "8", "-lr", "12"]

    @staticmethod
    def weight(effort):
        return 0.002
