# SPDX-License-Identifier: BSD-3-Clause
"""Receiver sets as CSV: one line a receiver, in full precision."""
import numpy as np

HEADER = "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,direct_lx,trusted,valid"


def write_csv(path, receivers):
    columns = np.column_stack([receivers.points, receivers.normals, receivers.illuminance, receivers.standard_error,
                               receivers.direct])
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(HEADER + "\n")
        for row, trusted, valid in zip(columns.tolist(), receivers.trusted, receivers.valid):
            file.write(",".join(map(repr, row)) + f",{trusted:d},{valid:d}\n")
