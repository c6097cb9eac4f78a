# SPDX-License-Identifier: BSD-3-Clause
"""The zoo: rooms in which estimates, error bars and flags are put to the test, one table.

    PYTHONPATH=build/python python3 tests/zoo/run.py [--rooms WORD,...] [--methods compensated,gathered] [--seeds 6]
                                                     [--trajectories 4096] [--out out/zoo] [--list]

Every room has a truth that no estimator of Kalos had part in: --list says which. Per room and method the table says, in %, how
many of all 95 % intervals hold the truth (Student's quantile), of the unflagged and of the flagged values alone, how many values
are flagged and how many of these deserve it (the interval misses the truth, or the value is off by more than 10 %), mean
deviation, largest deviation in standard errors, rms error; then the processor seconds that 1 % rms error would take (time x
variance), and those of a solve. OUT/zoo.csv holds the same numbers.

Exit status 1 if a room's unflagged intervals hold in less than 90 %, beyond what the spread of the seeds explains, and the room
does not stand in hard.txt; and if one that stands there has become sound.
"""
import argparse
import sys
import tempfile
from pathlib import Path

import kalos  # noqa: F401  finds VTK
import numpy as np
from catalogue import ROOMS
from measure import GOAL, TITLES, judge, line, over_all, solve, write_csv

HERE = Path(__file__).resolve().parent
METHODS = ("compensated", "gathered")


def chosen(words):
    """The rooms whose name or kind has one of the words."""
    return [room for room in ROOMS if not words or any(word in room.name or word in room.kind for word in words)]


def hard():
    """The rooms and methods that are known to fall short: {(room, method)}."""
    lines = [text.split("#")[0].split() for text in (HERE / "hard.txt").read_text().splitlines()]
    return {(room, method) for room, *methods in filter(None, lines) for method in methods}


def show(rooms):
    for room in rooms:
        truth, noise = room.truth()
        print(f"{room.name:<26} {len(room.receivers):>3} receivers  {room.kind}\n{'':<26} truth: {room.source}; standard error "
              f"{100 * np.sqrt(np.mean((noise / truth) ** 2)):.2f} %")


def measure(rooms, methods, seeds, trajectories, say=print):
    """The figures of every room and method."""
    rows = []
    say(f"seeds 1 to {seeds}, {trajectories} trajectories, one thread")
    say(TITLES)
    with tempfile.TemporaryDirectory(prefix="kalos-zoo-") as scratch:
        for room in rooms:
            truth, noise = room.truth()
            for method in methods:
                solves = solve(room, Path(scratch) / room.name, method, seeds, trajectories)
                rows.append(judge(room.name, method, solves, truth, noise))
                say(line(rows[-1]))
    return rows


def verdict(rows, known):
    """What is worth a failure, in words."""
    found = [f"{one.room}, {one.method}: unflagged intervals hold in {100 * one.unflagged_holds:.0f} %, expected {100 * GOAL:.0f} or a "
             "line in hard.txt"
             for one in rows if one.sure_below and (one.room, one.method) not in known]
    return found + [f"{one.room}, {one.method}: stands in hard.txt, but its intervals hold; expected no such line"
                    for one in rows if not one.unflagged_holds < GOAL and (one.room, one.method) in known]


def main():
    parser = argparse.ArgumentParser(description="Measures estimates, error bars and flags in the rooms of the zoo.")
    parser.add_argument("--rooms", help="only rooms whose name or kind has one of these words")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--seeds", type=int, default=6)
    parser.add_argument("--trajectories", type=int, default=4096)
    parser.add_argument("--out", type=Path, default=Path("out/zoo"))
    parser.add_argument("--list", action="store_true", help="only say which rooms there are and where their truths come from")
    given = parser.parse_args()
    rooms = chosen(given.rooms.split(",") if given.rooms else ())
    if not rooms:
        parser.error(f"--rooms: {given.rooms} is in no room's name or kind; --list shows them")
    if given.list:
        show(rooms)
        return 0
    rows = measure(rooms, given.methods.split(","), given.seeds, given.trajectories, lambda text: print(text, flush=True))
    given.out.mkdir(parents=True, exist_ok=True)
    write_csv(given.out / "zoo.csv", rows)
    failures = verdict(rows, hard())
    for text in over_all(rows, {room.name for room in rooms if room.ordinary}) + failures:
        print(text)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
