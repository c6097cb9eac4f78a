# SPDX-License-Identifier: BSD-3-Clause
"""The contenders of a chart: the methods of Kalos and the peers, behind one interface."""
from dataclasses import replace

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.core.options import METHODS, Options
from kalos.core.progress import run
from kalos.errors import KalosError
from kalos.estimation.filters import illuminance_filter, luminance_filter
from kalos.peers import NAMES, Absent, Run
from kalos.peers.description import describe, gloss, materials
from kalos.peers.mitsuba3 import Mitsuba
from kalos.peers.radiance import CachedRadiance, Radiance
from kalos.results.fields import audit, field_value, trajectories
from kalos.results.receivers import from_dataset
from kalos.results.statistics import error_of
from kalos.scenes.clearance import triangles
from kalos.scenes.photometric import band_weights
from kalos.scenes.reading import camera_names, receiver_names
from kalos.scenes.sight import camera_rays, first_faces, normals_towards
from kalos.studies.subject import Estimate, Subject

PEERS = dict(zip(NAMES, (Mitsuba, Radiance, CachedRadiance)))
LEAST = 32  # trajectories: one per replicate


class Room(Subject):
    """The receivers of a scene file, all of its sets together or one."""

    response, emitted, first, outgoing = None, 0.0, -1, None  # of receivers, as kalos.peers.description has it

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
        estimator = illuminance_filter(self.reader, options)
        one = len(self.chosen) == 1
        if one:
            estimator.SetInputDataObject(0, self.reader.GetReceivers().GetBlock(self.chosen[0]))
        output = run(estimator, label, patience=float("inf") if label is None else 0)
        self.receivers = [from_dataset("receivers", output if one else output.GetBlock(i)) for i in self.chosen]
        return Estimate(self.joined("illuminance"), self.joined("standard_error"), None, trajectories(output),
                        field_value(output, arrays.SOLVE_SECONDS), field_value(output, arrays.SOLVE_CPU_SECONDS),
                        field_value(output, arrays.RAYS), self.joined("direct"), tuple(audit(output)), self.mean_error())

    def mean_error(self):
        means = self.joined("replicates").mean(axis=0)
        return error_of(means) / means.mean() if means.mean() > 0 else None

    def joined(self, name):
        return np.concatenate([getattr(one, name) for one in self.receivers])

    def digest(self, *more):
        return super().digest(self.chosen, *more)


class View(Subject):
    """What a camera of a scene file sees, cd/m2, pixel by pixel; pixels that see no surface are left out.

    A line of sight ends at the pixel's centre, as in Kalos's own images: what is measured is the light that arrives where it
    does, at `points`, reflected by `response` per band, and `emitted`. Where a scene has gloss or mirrors, it is the luminance
    that the `first` triangles reflect to the eye, `outgoing`.
    """

    def __init__(self, path, wanted):
        super().__init__(path)
        names = camera_names(self.reader)
        if wanted not in names:
            raise KalosError(f"--camera: {wanted!r} is not in {path}, expected one of {', '.join(names) or 'its cameras, but it has none'}")
        self.is_image, self.quantity, self.unit, self.name = True, "luminance", "cd/m²", wanted
        self.index = names.index(wanted)
        filter_ = luminance_filter(self.reader, self.index, None)
        rays = camera_rays(filter_.GetPosition(), filter_.GetTarget(), filter_.GetUp(), filter_.GetFieldOfView(),
                           filter_.GetResolution())
        surfaces = self.reader.GetOutputDataObject(0)
        faces, (reflectance, exitance) = triangles(surfaces), materials(surfaces)
        distance, face = first_faces(filter_.GetPosition(), rays, faces)
        self.seen = face >= 0
        face, rays = face[self.seen], rays[self.seen]
        self.points = np.asarray(filter_.GetPosition()) + distance[self.seen, None] * rays
        self.normals = normals_towards(rays, faces, face)
        weights = band_weights(reflectance.shape[1])
        shiny = any(values.any() for values in gloss(surfaces)[::2])
        self.response = (np.ones_like(reflectance[face]) if shiny else reflectance[face]) * weights / np.pi
        self.first, self.outgoing = (face, -rays) if shiny else (-1, None)
        across = np.cross(faces[face, 1] - faces[face, 0], faces[face, 2] - faces[face, 0])
        front = np.einsum("ij,ij->i", across, self.normals) > 0
        self.emitted = np.where(front, exitance[face] @ weights, 0) / np.pi

    def solve(self, options, label):
        options = replace(options, pixel_samples=1)
        output = run(luminance_filter(self.reader, self.index, options), label, patience=float("inf") if label is None else 0)
        data = output.GetPointData()
        # The mean errs by at most the mean of the errors: pixels share trajectories.
        values, error = (vtk_to_numpy(data.GetArray(name)).astype(float)[self.seen]
                         for name in (arrays.LUMINANCE, arrays.LUMINANCE_STANDARD_ERROR))
        return Estimate(values, error, None, trajectories(output), field_value(output, arrays.SOLVE_SECONDS),
                        field_value(output, arrays.SOLVE_CPU_SECONDS), field_value(output, arrays.RAYS), None, tuple(audit(output)),
                        float(error.mean() / values.mean()) if values.mean() > 0 else None)

    def digest(self, *more):
        return super().digest(self.points.tobytes(), *more)


class Method:
    """A method of Kalos, with its automatic settings."""

    EFFORT, START, version, setup_cpu_seconds = "trajectories", 4 * LEAST, None, None

    def __init__(self, room, name, threads):
        self.room, self.options = room, Options(method=name, threads=threads)
        self.NAME, self.LABEL = name, f"Kalos, {name}"
        try:
            self.solve(LEAST, 1)
        except KalosError as error:  # the room is sound: another method has solved it
            raise Absent(str(error)) from None

    def solve(self, effort, seed):
        found = self.room.solve(replace(self.options, trajectories=effort, seed=seed), None)
        self.last = found
        return Run(found.values, found.trajectories, found.cpu_seconds, found.rays)

    def close(self):
        pass


def assemble(room, methods, peers, threads, say):
    """The contenders that can take part; `say` gets a line about each one that cannot."""
    makers = {name: lambda name=name: Method(room, name, threads) for name in methods or METHODS}
    if peers:
        scene = describe(room.reader, room.points, room.normals, room.response, room.emitted, room.first, room.outgoing)
        for name in peers:
            makers[name] = lambda kind=PEERS[name]: kind(scene, threads)
    found = []
    for name, make in makers.items():
        try:
            found.append(make())
        except Absent as absent:
            say(f"without {name}: {absent}")
    return found
