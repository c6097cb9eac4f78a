# SPDX-License-Identifier: BSD-3-Clause
"""A solve that saves a checkpoint after every round, as a program to be killed: SCENE CHECKPOINT OUT.npy [LIMIT]."""
import resource
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.core.options import Options
from kalos.errors import update
from kalos.estimation.filters import illuminance_filter
from kalos.scenes.reading import read_scene


def main(scene, checkpoint, out, limit=None):
    if limit:
        resource.setrlimit(resource.RLIMIT_FSIZE, (int(limit), int(limit)))  # as a full disk: a write comes back short
    estimator = illuminance_filter(read_scene(scene), Options(trajectories=60000, checkpoint=checkpoint))
    estimator.SetCheckpointInterval(0)
    estimator.SetIntermediateResults(True)  # many small rounds
    update(estimator)
    blocks = estimator.GetOutputDataObject(0)
    values = [vtk_to_numpy(blocks.GetBlock(i).GetPointData().GetArray(name)) for i in range(blocks.GetNumberOfBlocks())
              for name in (arrays.ILLUMINANCE, arrays.ILLUMINANCE_STANDARD_ERROR, arrays.DIRECT_ILLUMINANCE)
              if blocks.GetBlock(i).GetPointData().HasArray(name)]
    if limit is None:
        np.save(out, np.concatenate(values))
    else:
        sys.stdout.write(str(np.concatenate(values).tobytes().hex()))


if __name__ == "__main__":
    main(*sys.argv[1:])
