# SPDX-License-Identifier: BSD-3-Clause
"""Mitsuba 3 as a peer: starts kalos.peers.mitsuba_worker, which says what it does, and talks to it."""
import glob
import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from kalos.peers import Absent, Run, clean_environment, interpreter

WORKER = Path(__file__).resolve().with_name("mitsuba_worker.py")
LLVM = ("/usr/lib/*/libLLVM*.so*", "/usr/lib64/libLLVM*.so*", "/usr/lib/llvm-*/lib/libLLVM*.so*")
OLDEST = 17  # what the vector code of Dr.Jit 1.x needs on x86; Debian 12 has libllvm19


def newest_llvm():
    """The path of the newest LLVM library; None where all are too old."""
    found = [(int(version[1]), path) for pattern in LLVM for path in glob.glob(pattern)
             if (version := re.search(r"libLLVM(?:\.so\.|-)?(\d+)", path)) and int(version[1]) >= OLDEST]
    return max(found)[1] if found else None


class Mitsuba:
    NAME, LABEL, EFFORT, START = "mitsuba", "Mitsuba 3, path tracing", "paths per receiver", 4

    def __init__(self, scene, threads=1):
        if scene["mirror"].any() and not scene["lamp_u"].any(axis=1).all():
            raise Absent("no path finds a point luminaire in a mirror, expected rectangles or no mirrors")
        llvm = os.environ.get("DRJIT_LIBLLVM_PATH") or newest_llvm()
        if not llvm:
            raise Absent(f"no LLVM library of version {OLDEST} or newer, expected one (Debian: libllvm19) or DRJIT_LIBLLVM_PATH")
        probe = subprocess.run([interpreter(), "-c", "import mitsuba"], env=clean_environment(), capture_output=True, check=False)
        if probe.returncode:
            raise Absent(f"{interpreter()} has no mitsuba, expected a KALOS_PEERS_PYTHON that has")
        self.response, self.emitted = scene["response"], scene["emitted"]
        self.folder = tempfile.TemporaryDirectory(prefix="kalos-mitsuba-")
        path = Path(self.folder.name)
        np.savez(path / "scene.npz", **scene)
        self.out = path / "values.npy"
        self.log = open(path / "log", "w+", encoding="utf-8")
        command = [interpreter(), WORKER, path / "scene.npz", str(threads)]
        self.worker = subprocess.Popen(command, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.log,
                                       env=clean_environment(DRJIT_LIBLLVM_PATH=llvm))
        first = self.answer()
        self.setup_cpu_seconds, self.version = first["setup_cpu_seconds"], first["version"]

    def answer(self):
        line = self.worker.stdout.readline()
        if not line:
            self.log.seek(0)
            last = (self.log.read().strip().splitlines() or ["without a word"])[-1]
            self.close()
            raise Absent(f"Mitsuba stopped: {last}")
        return json.loads(line)

    def solve(self, effort, seed):
        self.worker.stdin.write(json.dumps({"effort": int(effort), "seed": seed, "out": str(self.out)}) + "\n")
        self.worker.stdin.flush()
        said = self.answer()
        self.setup_cpu_seconds = said["setup_cpu_seconds"]
        values = (np.load(self.out) * self.response).sum(axis=1) + self.emitted
        return Run(values, said["effort"], said["cpu_seconds"], said["rays"])

    def close(self):
        if self.worker.poll() is None:
            self.worker.stdin.close()
            self.worker.wait()
        self.worker.stdout.close()
        self.log.close()
        self.folder.cleanup()
