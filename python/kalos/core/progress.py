# SPDX-License-Identifier: BSD-3-Clause
"""Progress bars while VTK works, and the signals that stop it."""
import contextlib
import io
import os
import signal
import sys
import threading
import time

from kalos import ranks
from kalos.core.unblocked import update_unblocked
from kalos.errors import FAILED, KalosError, update

WIDTH = 30


class ProgressBar:
    """A bar on a terminal, with the time so far and the time to go; elsewhere, in a log, a line with a mark at every tenth.

    Nothing shows before `patience` seconds.
    """

    def __init__(self, label, stream=None, patience=0):
        self.label = label
        self.stream = stream or (sys.stderr if ranks.current.rank == 0 else io.StringIO())
        self.terminal = self.stream.isatty()
        self.shown = -1
        self.started = time.monotonic()
        self.earliest = self.started + patience

    def show(self, fraction):
        step = int(fraction * (100 if self.terminal else 10))
        if step <= self.shown or (self.shown < 0 and time.monotonic() < self.earliest):
            return
        if self.terminal:
            done = int(fraction * WIDTH)
            elapsed = time.monotonic() - self.started
            left = clock(elapsed * (1 - fraction) / fraction) if fraction > 0 else "?"
            self.stream.write(f"\r{self.label:<24} [{'#' * done}{' ' * (WIDTH - done)}] {step:3d} %  {clock(elapsed)} < {left} ")
        else:
            first = f"{self.label:<24} " if self.shown < 0 else ""
            self.stream.write(first + "".join(f"{10 * k}% " for k in range(self.shown + 1, step + 1)))
        self.shown = step
        self.stream.flush()

    def close(self):
        if self.shown >= 0:
            self.stream.write("\n")
            self.stream.flush()


def clock(seconds):
    """Minutes and seconds, and hours when there are any: 0:07, 1:02:03."""
    minutes, seconds = divmod(int(seconds + 0.5), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes}:{seconds:02d}"


def run(algorithm, label, stream=None, patience=0):
    """Brings a long-running algorithm up to date with a progress bar and returns its output.

    Ctrl-C stops it cleanly, as a KalosError.
    """
    if watch(algorithm, ProgressBar(label, stream, patience), signals=(signal.SIGINT, signal.SIGTERM)):
        kept = getattr(algorithm, "GetCheckpointFile", lambda: None)()
        raise KalosError("stopped before the end; " + (f"the same command goes on from {kept}" if kept and os.path.exists(kept)
                                                       else "nothing was written"), FAILED)
    return algorithm.GetOutputDataObject(0)


def watch(algorithm, progress=None, label="", signals=(signal.SIGINT,)):
    """Brings a long-running algorithm up to date; returns whether one of the signals stopped it.

    `progress` is a ProgressBar, True for one with `label`, a function of a fraction in (0, 1], or nothing. What the function
    raises stops the algorithm and is raised from here: VTK would print and drop it.
    """
    bar = ProgressBar(label) if progress is True else progress if isinstance(progress, ProgressBar) else None
    tell = bar.show if bar else progress or (lambda fraction: None)
    raised = []

    def show(fraction):
        if raised or not 0 < fraction < 1:  # VTK reports 1 after a failure too
            return
        try:
            tell(fraction)
        except BaseException as error:
            raised.append(error)
            algorithm.SetAbortExecute(1)

    with stop_signals(algorithm, signals) as stop:
        try:
            followed_update(algorithm, show)
            if not stop and not raised:
                tell(1)
        finally:
            if bar:
                bar.close()
    if raised:
        raise raised[0]
    return bool(stop)


def followed_update(algorithm, show):
    """Updates an algorithm and calls show(fraction); other threads go on during an estimate."""
    if algorithm.IsA("vtkKalosEstimatorAlgorithm"):
        update_unblocked(algorithm, show)
        return
    tag = algorithm.AddObserver("ProgressEvent", lambda caller, _event: show(caller.GetProgress()))
    try:
        update(algorithm)
    finally:
        algorithm.RemoveObserver(tag)


@contextlib.contextmanager
def stop_signals(algorithm, signals):
    """Within, the signals abort the algorithm and are noted in the list this yields.

    Python calls the handlers when the next progress event enters the interpreter.
    """
    stop = []

    def handler(number, _frame):
        stop.append(number)
        algorithm.SetAbortExecute(1)

    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    previous = {number: signal.signal(number, handler) for number in signals}
    try:
        yield stop
    finally:
        for number, action in previous.items():
            signal.signal(number, action)
