# SPDX-License-Identifier: BSD-3-Clause
"""Receiver sets as CSV: one line a receiver, in full precision."""
import numpy as np

HEADER = "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,direct_lx,trusted,valid"


def write_csv(path, receivers, daylight=False):
    """With `daylight` the last column is the daylight factor."""
    factors = receivers.daylight_factor if daylight else None
    columns = np.column_stack([receivers.points, receivers.normals, receivers.illuminance, receivers.standard_error,
                               receivers.direct])
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(HEADER + ("" if factors is None else ",daylight_factor_percent") + "\n")
        last = [""] * len(columns) if factors is None else [f",{factor!r}" for factor in factors.tolist()]
        for row, trusted, valid, factor in zip(columns.tolist(), receivers.trusted, receivers.valid, last):
            file.write(",".join(map(repr, row)) + f",{trusted:d},{valid:d}{factor}\n")
