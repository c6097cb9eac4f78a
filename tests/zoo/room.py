# SPDX-License-Identifier: BSD-3-Clause
"""A room of the zoo: a scene, its receivers, and the illuminance that is true there."""
import csv
import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

TRUTHS = Path(__file__).resolve().parent / "truths"
HEADER = ["x", "y", "z", "nx", "ny", "nz", "illuminance_lx", "standard_error_lx"]
SAME = 1e-9  # m, within which a table's points are those of the room


@dataclass(frozen=True)
class Room:
    """Either `exact` says the truth, or the tracer has written it into truths/NAME.csv (tests/zoo/trace.py)."""

    name: str
    kind: str  # what makes it hard
    scene: dict  # as in a scene file, without receivers
    receivers: np.ndarray  # (n, 6): points, m, and unit normals
    source: str  # where the truth comes from
    exact: object = None  # of the receivers (n, 6): lx (n,)
    slack: float = 0.0  # relative, by which the scene may differ from what `exact` is of
    files: dict = field(default_factory=dict)  # name: text of what the scene refers to
    traced: dict = None  # what the tracer solves in its place: a part that sends the receivers the same light
    portals: tuple = ()  # rectangles (origin, u, v) that all light passes on its way to the receivers, in this order, u x v onward
    ordinary: bool = False  # nothing about it is hard

    def truth(self):
        """Illuminance at the receivers and its standard error, lx."""
        if self.exact:
            values = self.exact(self.receivers)
            return values, self.slack * values
        rows = np.array(read_table(self.name))
        if rows.shape != (len(self.receivers), len(HEADER)) or np.abs(rows[:, :6] - self.receivers).max() > SAME:
            raise ValueError(f"{self.name}: truths/{self.name}.csv is of other receivers, expected those of the room")
        return rows[:, 6], rows[:, 7]

    def write(self, folder):
        """Writes the scene with its receivers and returns the path of the scene file."""
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in self.files.items():
            (folder / name).write_text(text)
        with (folder / "probe.csv").open("w", newline="") as file:
            table = csv.writer(file)
            table.writerow(HEADER[:6])
            table.writerows([repr(float(x)) for x in row] for row in self.receivers)
        path = folder / "scene.json"
        path.write_text(json.dumps({"kalos": 1, **self.scene, "receivers": [{"name": "probe", "points": "probe.csv"}]}))
        return path


def read_table(name):
    with (TRUTHS / f"{name}.csv").open(newline="") as file:
        rows = [row for row in csv.reader(file) if not row[0].startswith("#")]
    if rows[0] != HEADER:
        raise ValueError(f"{name}: truths/{name}.csv has the columns {rows[0]}, expected {HEADER}")
    return [[float(x) for x in row] for row in rows[1:]]


def write_table(room, values, errors, remarks):
    """Writes what the tracer found, behind lines that say how."""
    with (TRUTHS / f"{room.name}.csv").open("w", newline="") as file:
        for remark in remarks:
            file.write(f"# {remark}\n")
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADER)
        for place, value, error in zip(room.receivers, values, errors):
            table.writerow([*(f"{x:.12g}" for x in place), f"{value:.7g}", f"{error:.2g}"])
