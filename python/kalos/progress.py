# SPDX-License-Identifier: BSD-3-Clause
"""What the user sees while VTK works, and the keys and signals that stop it."""
import contextlib
import signal
import sys
import threading
import time

from kalos.errors import FAILED, KalosError, update

WIDTH = 30


class ProgressBar:
    """A bar on a terminal; elsewhere, in a log, a line with a mark at every tenth. Nothing before `patience` seconds."""

    def __init__(self, label, stream=None, patience=0):
        self.label = label
        self.stream = stream or sys.stderr
        self.terminal = self.stream.isatty()
        self.shown = -1
        self.earliest = time.monotonic() + patience

    def show(self, fraction):
        step = int(fraction * (100 if self.terminal else 10))
        if step <= self.shown or (self.shown < 0 and time.monotonic() < self.earliest):
            return
        if self.terminal:
            done = int(fraction * WIDTH)
            self.stream.write(f"\r{self.label:<24} [{'#' * done}{' ' * (WIDTH - done)}] {step:3d} %")
        else:
            first = f"{self.label:<24} " if self.shown < 0 else ""
            self.stream.write(first + "".join(f"{10 * k}% " for k in range(self.shown + 1, step + 1)))
        self.shown = step
        self.stream.flush()

    def close(self):
        if self.shown >= 0:
            self.stream.write("\n")
            self.stream.flush()


def run(algorithm, label, stream=None, patience=0):
    """Brings a long-running algorithm up to date with a progress bar and returns its output.

    Ctrl-C stops it cleanly, as a KalosError.
    """
    bar = ProgressBar(label, stream, patience)

    def show(caller, _event):
        if 0 < caller.GetProgress() < 1:  # VTK reports 1 after a failure too
            bar.show(caller.GetProgress())

    with stop_signals(algorithm) as stop:
        tag = algorithm.AddObserver("ProgressEvent", show)
        try:
            update(algorithm)
            if not stop:
                bar.show(1)
        finally:
            algorithm.RemoveObserver(tag)
            bar.close()
    if stop:
        raise KalosError("stopped before the end; nothing was written", FAILED)
    return algorithm.GetOutputDataObject(0)


@contextlib.contextmanager
def stop_signals(algorithm):
    """Within, SIGINT and SIGTERM abort the algorithm and are noted in the list this yields.

    Python calls the handlers when the next progress event enters the interpreter.
    """
    stop = []

    def handler(number, _frame):
        stop.append(number)
        algorithm.SetAbortExecute(1)

    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    previous = {number: signal.signal(number, handler) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield stop
    finally:
        for number, action in previous.items():
            signal.signal(number, action)
