# SPDX-License-Identifier: BSD-3-Clause
"""The processes of mpiexec, among which the filters divide one solve through VTK's controller."""
import os
import sys
import time
from typing import Any

from kalos.errors import FAILED, KalosError

SIZES = ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS")  # as Open MPI, MPICH and Intel MPI tell their processes
FIRST_WORDS = 1.0  # s that other ranks wait before they print an error: usually rank 0 prints the same one and aborts


class Ranks:
    """This process alone."""

    rank, size = 0, 1

    def complain(self, message, status):
        """One line about what went wrong; returns the exit status."""
        print(f"kalos: error: {message}", file=sys.stderr, flush=True)
        return status


class MpiRanks(Ranks):
    """This process among those of mpiexec; the global controller of VTK is theirs."""

    def __init__(self, controller, communicator):
        self.controller, self.communicator = controller, communicator
        self.rank, self.size = communicator.Get_rank(), communicator.Get_size()

    def complain(self, message, status):
        """Ends all ranks, as the others may be waiting for this one."""
        if self.rank:
            time.sleep(FIRST_WORDS)
            message = f"rank {self.rank} of {self.size}: {message}"
        super().complain(message, status)
        self.communicator.Abort(status)


current = Ranks()


def several():
    """Whether mpiexec started more than this process."""
    return any(os.environ.get(name, "1") not in ("", "0", "1") for name in SIZES)


def join() -> Any:
    """Joins the processes of mpiexec, if there are several; returns what is `current` from now on."""
    global current
    if several() and current.size == 1:
        try:
            from mpi4py import MPI  # initialises MPI, and ends it when Python does
            from vtkmodules.vtkParallelCore import vtkMultiProcessController
            from vtkmodules.vtkParallelMPI import vtkMPIController
        except ImportError as missing:
            raise KalosError(f"mpiexec: {missing}; expected python3-mpi4py and a VTK with MPI", FAILED) from None
        controller = vtkMPIController()
        controller.Initialize()
        vtkMultiProcessController.SetGlobalController(controller)
        current = MpiRanks(controller, MPI.COMM_WORLD)
    return current
