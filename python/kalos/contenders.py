# SPDX-License-Identifier: BSD-3-Clause
"""Who takes part in a chart: every method of Kalos and the peers, alike to the one who measures them."""
from dataclasses import replace

import numpy as np

from kalos import arrays
from kalos.errors import KalosError
from kalos.estimator import METHODS, Options
from kalos.peers import NAMES, Absent, Run
from kalos.peers.description import beyond, describe
from kalos.peers.mitsuba3 import Mitsuba
from kalos.peers.radiance import CachedRadiance, Radiance
from kalos.progress import run
from kalos.receivers import from_dataset
from kalos.solve import illuminance, receiver_names
from kalos.subject import Estimate, Subject
from kalos.summary import field_value, trajectories

PEERS = dict(zip(NAMES, (Mitsuba, Radiance, CachedRadiance)))
LEAST = 32  # trajectories: one per replicate


class Room(Subject):
    """The receivers of a scene file, all of its sets together or one."""

    def __init__(self, path, wanted=None):
        super().__init__(path)
        names = receiver_names(self.reader)
        if not names:
            raise KalosError(f"{path}: receivers: there are none, expected a scene with receivers")
        if wanted and wanted not in names:
            raise KalosError(f"--receivers: {wanted!r} is not in {path}, expected one of {', '.join(names)}")
        self.is_image, self.quantity, self.unit = False, "illuminance", "lx"
        self.name = wanted or ", ".join(names)
        self.chosen = [i for i, name in enumerate(names) if wanted in (None, name)]
        self.solve(Options(trajectories=LEAST), None)
        self.points, self.normals = self.joined("points"), self.joined("normals")

    def solve(self, options, label):
        estimator = illuminance(self.reader, options)
        one = len(self.chosen) == 1
        if one:
            estimator.SetInputDataObject(0, self.reader.GetReceivers().GetBlock(self.chosen[0]))
        output = run(estimator, label, patience=float("inf") if label is None else 0)
        self.receivers = [from_dataset("receivers", output if one else output.GetBlock(i)) for i in self.chosen]
        return Estimate(self.joined("illuminance"), self.joined("standard_error"), None, trajectories(output),
                        field_value(output, arrays.SOLVE_SECONDS), field_value(output, arrays.SOLVE_CPU_SECONDS),
                        field_value(output, arrays.RAYS))

    def joined(self, name):
        return np.concatenate([getattr(one, name) for one in self.receivers])

    def digest(self, *more):
        return super().digest(self.chosen, *more)


class Method:
    """A method of Kalos, with its automatic settings."""

    EFFORT, START, version, setup_cpu_seconds = "trajectories", 4 * LEAST, None, None

    def __init__(self, room, name, threads):
        self.room, self.options = room, Options(method=name, threads=threads)
        self.NAME, self.LABEL = name, f"Kalos, {name}"
        try:
            self.solve(LEAST, 1)
        except KalosError as error:
            if "available" not in str(error):
                raise
            raise Absent("not in this build") from None

    def solve(self, effort, seed):
        found = self.room.solve(replace(self.options, trajectories=effort, seed=seed), None)
        return Run(found.values, found.trajectories, found.cpu_seconds, found.rays)

    def close(self):
        pass


def assemble(room, methods, peers, threads, say):
    """The contenders that can take part; `say` gets a line about every one that can not."""
    makers = {name: lambda name=name: Method(room, name, threads) for name in methods or METHODS}
    if peers:
        scene, reason = describe(room.reader, room.points, room.normals), beyond(room.reader)
        for name in peers:
            makers[name] = lambda kind=PEERS[name]: kind(scene, threads)
    found = []
    for name, make in makers.items():
        try:
            if name in PEERS and reason:
                raise Absent(f"knows no {reason} here, expected a scene of Lambertian surfaces and luminaires")
            found.append(make())
        except Absent as absent:
            say(f"without {name}: {absent}")
    return found
