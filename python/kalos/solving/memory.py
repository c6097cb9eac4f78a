# SPDX-License-Identifier: BSD-3-Clause
"""Estimates the memory that a solve needs and refuses one that would not fit into what is available."""
import resource
from pathlib import Path

from kalos.core import arrays
from kalos.errors import KalosError

# Bytes, a tenth to a third more than solves took; tests/benchmarks/load.py draws both.
PROGRAM = 200e6  # interpreter, VTK, vertices of a round
TRIANGLE = 600.0  # the reader's, while its triangles are repaired and searched for edges
UNPREPARED_TRIANGLE = 500.0  # the reader's, the solver's and those of the ray tracer's tree
RECEIVER = 700.0  # geometry, results, and the columns of tables
PIXEL = 1900.0  # likewise, with what lies along the line of sight
LUMINAIRE = 1000.0
SUM = 8.0  # a number per receiver and replicate
REPLICATES = 32  # at most


def demand(triangles, receivers=0, luminaires=0, pixels=0, bands=1, preparing=True):
    """Upper bound of the memory of a solve, in bytes; pixels are those of the largest image."""
    sums = SUM * REPLICATES * (2 + 2 * bands)  # scores, direct scores, corrections, largest scores
    return (PROGRAM + triangles * (TRIANGLE if preparing else UNPREPARED_TRIANGLE) + luminaires * LUMINAIRE
            + receivers * (RECEIVER + 2 * SUM * REPLICATES)  # estimates of the replicates, for errors of means
            + pixels * PIXEL + max(receivers, pixels) * sums)


def available(root=Path("/")):
    """Bytes that this process may use in total, and what limits it: the machine, a control group or a limit of the shell.

    root is where proc and sys are. Infinite where the system does not say.
    """
    status, machine = fields(root / "proc/self/status"), fields(root / "proc/meminfo")
    own = status.get("VmRSS", 0)
    bounds = [(machine.get("MemAvailable", float("inf")) + own, "free on this machine")]
    bounds += [(free + own, "left in the control group") for free in control_groups(root)]
    for kind, name in ((resource.RLIMIT_AS, "ulimit -v"), (resource.RLIMIT_DATA, "ulimit -d")):
        soft, _ = resource.getrlimit(kind)
        if soft != resource.RLIM_INFINITY:
            bounds.append((soft - max(0, status.get("VmSize", 0) - own), f"allowed by {name}"))
    return min(bounds)


def fields(path):
    """The lines `Name: number kB` of a file below /proc, in bytes; none where there is no such file."""
    try:
        words = [line.split() for line in path.read_text().splitlines()]
    except OSError:
        return {}
    return {line[0].rstrip(":"): 1024 * int(line[1]) for line in words if len(line) == 3 and line[2] == "kB"}


def control_groups(root):
    """Bytes left in each control group that this process is in, of both versions."""
    try:
        lines = (root / "proc/self/cgroup").read_text().splitlines()
    except OSError:
        return
    for line in lines:
        number, kinds, name = line.split(":", 2)
        if number != "0" and "memory" not in kinds.split(","):
            continue
        base = root / "sys/fs/cgroup" / ("" if number == "0" else "memory")
        limit, usage = ("memory.max", "memory.current") if number == "0" else ("memory.limit_in_bytes", "memory.usage_in_bytes")
        for folder in (base / name.lstrip("/"), *(base / name.lstrip("/")).parents):
            try:
                yield int((folder / limit).read_text()) - int((folder / usage).read_text()) + reclaimable(folder)
            except (OSError, ValueError):  # not there, or "max"
                pass
            if folder == base:
                break


def reclaimable(folder):
    """Bytes of files that a control group holds in memory, and gives up when it needs to."""
    counts = dict(line.split() for line in (folder / "memory.stat").read_text().splitlines())
    return int(counts.get("inactive_file", 0)) + int(counts.get("active_file", 0))


def check_memory(scene, reader, preparing):
    """Raises KalosError if solving the scene would need more memory than is available."""
    surfaces = reader.GetSurfaces()
    triangles = surfaces.GetPolys().GetNumberOfConnectivityIds() - 2 * surfaces.GetNumberOfPolys()
    blocks = reader.GetReceivers()
    receivers = sum(blocks.GetBlock(i).GetNumberOfCells() for i in range(blocks.GetNumberOfBlocks()))
    luminaires = reader.GetLuminaires().GetNumberOfPoints()
    bands = surfaces.GetCellData().GetArray(arrays.REFLECTANCE).GetNumberOfComponents()
    pixels, resolution = 0, [0, 0]
    for i in range(reader.GetNumberOfCameras()):
        reader.GetCameraResolution(i, resolution)
        pixels = max(pixels, resolution[0] * resolution[1])
    needed = demand(triangles, receivers, luminaires, pixels, bands, preparing)
    there, bound = available()
    if needed > there:
        counts = [f"{count} {what}" for count, what in ((triangles, "triangles"), (receivers, "receivers"), (luminaires, "luminaires"),
                                                        (pixels, "pixels")) if count]
        raise KalosError(f"{scene}: memory: about {gigabytes(needed)} needed for {', '.join(counts)}, and {gigabytes(there)} are "
                         f"{bound}; expected a smaller scene, or more memory")


def gigabytes(count):
    return f"{max(0, count) / 1e9:.3g} GB"
