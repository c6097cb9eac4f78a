# SPDX-License-Identifier: BSD-3-Clause
"""Makes the truths of the zoo that are no closed form: truths/NAME.csv, by the path tracer of this folder, on one thread.

    python3 -m venv --system-site-packages zoo && zoo/bin/pip install numba==0.60.*
    PYTHONPATH=build/python zoo/bin/python tests/zoo/trace.py [--rooms WORD,...] [--error 0.002] [--seconds 120] [--missing]
    PYTHONPATH=build/python zoo/bin/python tests/zoo/trace.py --check [--rooms WORD,...]

A room is traced until the rms standard error of its values is below --error, but no longer than --seconds of processor time; the
standard errors stand in the table. --missing leaves out rooms that have a table. --check holds the tracer itself against the rooms
with closed forms, and ends with status 1 if one is off by more than chance allows, with 77 without numba.
"""
import argparse
import sys
import time

import kalos  # noqa: F401  finds VTK
import numpy as np
from scipy import stats

from catalogue import ROOMS
from room import TRUTHS, write_table

try:
    from tracer import Tracer
except ImportError as missing:
    print(f"trace: {missing}; expected numba", file=sys.stderr)
    sys.exit(77)  # skipped

LEAST = 20  # batches, whose spread is the standard error
BATCH, STAGED = 0.5, 2.0  # s of processor time, about; longer where light passes several portals, as a batch draws from all that pass
FALSE_ALARM = 1e-4  # that --check fails a room of a sound tracer
DELTA = ("mirrors", "facing")  # no path tracer finds a point lamp in mirrors from a point


def trace(room, error, seconds):
    """Values, standard errors and the number of samples."""
    tracer = Tracer(room)
    tracer.batch(2, 0)  # compiles
    samples, spent = 10, 0.0
    aim = STAGED if len(room.portals) > 1 else BATCH
    while spent < aim / 4:
        samples *= 2
        started = time.process_time()
        tracer.batch(samples, 0)
        spent = time.process_time() - started
    samples = max(1, int(samples * aim / spent))
    started, found = time.process_time(), []
    while True:
        found.append(tracer.batch(samples, len(found) + 1))
        if len(found) < LEAST:
            continue
        values, errors = np.mean(found, axis=0), np.std(found, axis=0, ddof=1) / np.sqrt(len(found))
        with np.errstate(divide="ignore", invalid="ignore"):
            reached = np.sqrt(np.mean((errors / values) ** 2)) <= error
        if reached or time.process_time() - started > seconds:
            return values, errors, samples * len(found), len(found)


def make(room, error, seconds):
    values, errors, samples, batches = trace(room, error, seconds)
    relative = errors / values
    write_table(room, values, errors, [
        f"{samples} paths per {'opening' if room.portals else 'receiver'} in {batches} batches; the standard error is their spread",
        f"tests/zoo/trace.py --rooms {room.name} --error {error:g} --seconds {seconds:g}"])
    rms = np.sqrt(np.mean(relative**2))
    print(f"{room.name:<26} {samples:>9} paths  rms error {100 * rms:.2f} %, largest {100 * relative.max():.2f} %", flush=True)


def check(room, error, seconds):
    """Whether the tracer agrees with a closed form: Student's t over the batches, Sidak's correction over the receivers."""
    truth, slack = room.truth()
    values, errors, _, batches = trace(room, error, seconds)
    off = np.abs(values - truth) - slack
    worst = (off / np.maximum(errors, 1e-6 * truth)).max()
    allowed = stats.t.isf((1 - (1 - FALSE_ALARM) ** (1 / len(truth))) / 2, batches - 1)
    print(f"{room.name:<26} off by {worst:5.2f} SE, allowed {allowed:.2f}; rms error {100 * np.sqrt(np.mean((errors / truth) ** 2)):.2f} %",
          flush=True)
    return worst <= allowed


def main():
    parser = argparse.ArgumentParser(description="Makes or checks the truths of the zoo.")
    parser.add_argument("--rooms", default="", help="only rooms whose name or kind has one of these words")
    parser.add_argument("--error", type=float, default=0.002)
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    words = given.rooms.split(",")
    rooms = [room for room in ROOMS if bool(room.exact) == given.check and any(word in room.name or word in room.kind for word in words)]
    if given.check:
        sound = [check(room, given.error, given.seconds) for room in rooms if not room.name.startswith(DELTA)]
        return 0 if all(sound) else 1
    for room in rooms:
        if not (given.missing and (TRUTHS / f"{room.name}.csv").exists()):
            make(room, given.error, given.seconds)
    return 0


if __name__ == "__main__":
    sys.exit(main())
