#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prepares every mesh under some folders and says which crash, hang or lose material; by hand, as it takes long.

    PYTHONPATH=build/python tests/meshing/real_meshes.py FOLDER... [--time 60] [--jobs 1]

Each file goes through `kalos prepare` twice, in a process of its own: repair and singular edges, then with remeshing to
a fiftieth of the diagonal. A file that is refused with status 2 and one line is fine; a signal, a traceback, another
status, more than the time limit, an area that does not add up or bounds that move are not: then the exit status is 1.
Debian's libcgal-demo (its data.tar.gz, unpacked) and assimp-testmodels have many defective ones.
"""
import argparse
import json
import math
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from kalos.preparation.mesh_readers import SUFFIXES

STEPS = 3  # of one run that each get the time limit: repair, remeshing, edges


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--time", type=float, default=60, help="limit of each step, s (60)")
    parser.add_argument("--jobs", type=int, default=1, help="files at a time (1)")
    options = parser.parse_args()
    files = sorted(path for folder in options.folders for path in folder.rglob("*")
                   if path.is_file() and path.suffix.lower() in SUFFIXES)
    outcomes = []
    with ThreadPoolExecutor(options.jobs) as pool:
        for path, outcome in zip(files, pool.map(lambda path: examine(path, options.time), files)):
            outcomes.append(outcome)
            print(f"{outcome:12} {path}", flush=True)
    counts = Counter(outcome.split(":")[0] for outcome in outcomes)
    print(f"{len(files)} files: " + ", ".join(f"{n} {word}" for word, n in sorted(counts.items())))
    return 1 if not files or any(word not in ("good", "refused", "given up", "no remesh") for word in counts) else 0


def examine(path, seconds):
    """One word, or with a colon and what went wrong."""
    with tempfile.TemporaryDirectory() as folder:
        status, text, report = prepare(path, Path(folder), seconds)
        if report is None:
            return verdict(status, text)
        lost = losses(report)
        if lost:
            return f"LOST: {lost}"
        bounds = [report["repair"][f"{end} {axis} before, m"] for axis in "xyz" for end in ("smallest", "largest")]
        diagonal = math.dist(bounds[::2], bounds[1::2])
        status, text, report = prepare(path, Path(folder), seconds, "--edge-length", f"{diagonal / 50:.6g}")
        if report is None:
            word = verdict(status, text)
            return "no remesh" if word == "refused" else word
        done = report["remesh"]
        # Curved parts are approximated, flat ones keep their area.
        if abs(done["area after, m²"] / done["area before, m²"] - 1) > 0.1:
            return f"LOST: remeshing made {done['area after, m²']:.6g} m² of {done['area before, m²']:.6g}"
        return "good"


def prepare(path, folder, seconds, *more):
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    command = [sys.executable, "-m", "kalos", "prepare", str(path), "--out", str(folder / "out.vtp"), "--report", str(report),
               "--time", str(seconds), *more]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=STEPS * seconds + 30)
    except subprocess.TimeoutExpired:
        return "HANGS", "", None
    return done.returncode, done.stderr, json.loads(report.read_text()) if done.returncode == 0 else None


def verdict(status, text):
    last = (text.strip().splitlines() or [""])[-1]
    if status == "HANGS":
        return "HANGS: no end long after the time limit"
    if status < 0:
        return f"CRASH: signal {-status}"
    if status != 2 or "Traceback" in text or not last.startswith("kalos: error: "):
        return f"FAILS: status {status}: {last}"
    return "given up" if "time limit" in last else "refused"


def losses(report):
    """What of the surface is neither there nor counted as dropped."""
    done = report["repair"]
    before, after = done["area before, m²"], done["area after, m²"]
    dropped = done["area of degenerate triangles dropped, m²"] + done["area of duplicate triangles dropped, m²"]
    # Points move by up to the tolerance when they merge: along every edge.
    slack = 1e-6 * before + 4 * done["tolerance, m"] * math.sqrt(before * done["triangles before"])
    if abs(before - after - dropped) > slack:
        return f"{before:.9g} m² before, {after:.9g} after, {dropped:.3g} dropped"
    if done["degenerate triangles dropped"] == 0:
        moved = max(abs(done[f"{end} {axis} before, m"] - done[f"{end} {axis} after, m"])
                    for axis in "xyz" for end in ("smallest", "largest"))
        if moved > 2 * done["tolerance, m"]:
            return f"bounds move by {moved:.3g} m"
    return None


if __name__ == "__main__":
    sys.exit(main())
