# SPDX-License-Identifier: BSD-3-Clause
"""What is too long for every day: statistics of many seeds, error slopes, mutations, kills, fuzzing, sanitizers.

tests/run --long [NAME ...]   all of it, or the sections whose name is given; the page is out/long/report.md

Each section is a command that can be run by hand and that fails by its exit status. A section that would end after the hour is
left out, and the page says so.
"""
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "out" / "long"
HOUR = 3600
PYTHON = "/usr/bin/python3"
SAMPLERS = ("Random.*:Sobol.*:SampleStream.*:Warp.*:Brdf.*:CandelaTable.samples*:Polygon.SphericalTriangle*:SphereAverage.OneSample*:"
            "Trajectories.*")
QUICK = "-*Edges.Compensated*:*GatherEffort*:*AgreesWith*:*SobolLeaves*:*Stops*:*Pauses*:*Torture*:*Gathered*"

# Name, what it shows, command.
SECTIONS = (
    ("samplers", "chi-square and moments of every sampler", ["build/bin/KernelTests", f"--gtest_filter={SAMPLERS}"]),
    ("slopes", "error against trajectories: -0.5 independent, steeper for Sobol's points", ["build/bin/KernelTests", "--gtest_also_run_disabled_tests", "--gtest_filter=*ErrorSlopes*"]),
    ("truths", "every method on every truth, 200 seeds", [PYTHON, "tests/long_truths.py", "200"]),
    ("coverage", "intervals near edges, 200 seeds; CIE 171", ["build/bin/kalos", "validate", "--method", "compensated", "--figures"]),
    ("zoo", "hard rooms: intervals, flags and times of both methods, each room with a truth of its own", [PYTHON, "tests/zoo/run.py", "--out", "out/long/zoo"]),
    ("zoo-truths", "the zoo's path tracer on the closed forms; needs numba", [PYTHON, "tests/zoo/trace.py", "--check", "--seconds", "10"]),
    ("kills", "50 SIGKILLs, each resumed to bitwise the same numbers",
     ["env", "KALOS_KILLS=50", f"KALOS={ROOT}/build/bin/kalos", PYTHON, "-m", "pytest", "-q", "-s", "-p", "no:cacheprovider",
      "tests/command/test_checkpoint.py", "-k", "killed"]),
    ("fuzz", "every reader, half a minute each", ["tests/fuzz/run", "30"]),
    ("sanitizers", "kernels under address and undefined-behaviour sanitizers", ["tests/sanitized", "asan", QUICK]),
    ("meshing", "meshing and its filters under address and undefined-behaviour sanitizers", ["tests/meshing/sanitize"]),
    ("threads", "kernels under the thread sanitizer", ["tests/sanitized", "tsan", QUICK]),
    ("tidy", "clang-tidy on the kernels", ["tests/tidy"]),
    ("mutations", "every mutation of the kernels is caught", ["tests/mutate", "tests/kernels/"]),
)


def run(name, command, left):
    """Status, seconds, and the last lines that the command said."""
    log = OUT / f"{name}.log"
    started = time.monotonic()
    with log.open("w") as file:
        try:
            status = subprocess.run(command, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT, timeout=left, check=False).returncode
        except subprocess.TimeoutExpired:
            status = "out of time"
    lines = log.read_text(errors="replace").strip().splitlines()
    return status, time.monotonic() - started, lines[-25:]


def main(wanted):
    unknown = set(wanted) - {name for name, _, _ in SECTIONS}
    if unknown:
        sys.exit(f"long: no section {', '.join(sorted(unknown))}; expected some of {', '.join(name for name, _, _ in SECTIONS)}")
    OUT.mkdir(parents=True, exist_ok=True)
    started, failed = time.monotonic(), []
    table, details = ["| section | what it shows | seconds | result |", "| --- | --- | --- | --- |"], []
    for name, shows, command in SECTIONS:
        if wanted and name not in wanted:
            continue
        left = HOUR - (time.monotonic() - started)
        status, seconds, lines = run(name, command, left) if left > 0 else ("out of time", 0, [])
        result = {0: "passed", 77: "skipped: a tool is missing"}.get(status, f"FAILED ({status})")
        if status not in (0, 77):
            failed.append(name)
        print(f"{name:<12} {seconds:7.0f} s  {result}", flush=True)
        table.append(f"| {name} | {shows} | {seconds:.0f} | {result} |")
        details += [f"## {name}", "", f"`{' '.join(command)}`", "", "```", *lines, "```", ""]
    revision = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True, check=False)
    page = [f"# Kalos, the long tests: {'failed: ' + ', '.join(failed) if failed else 'all passed'}", "",
            f"Revision {revision.stdout.strip() or 'unknown'}, {os.cpu_count()} processors, "
            f"{(time.monotonic() - started) / 60:.0f} minutes.", "", *table, "", *details]
    (OUT / "report.md").write_text("\n".join(page))
    print(OUT / "report.md")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
