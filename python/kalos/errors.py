# SPDX-License-Identifier: BSD-3-Clause
"""The exceptions of Kalos, and the conversion of VTK's error events into them."""
import re
import sys

from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonMisc import vtkErrorCode

BAD_INPUT = 2
FAILED = 1
UNKNOWN_ERROR = vtkErrorCode.UnknownError


class KalosError(Exception):
    """What is wrong, in one line, as `FILE: WHERE: what is wrong and what is expected`.

    status is the exit status of the command: 2 for bad input, 1 for other failures.
    """

    def __init__(self, message, status=BAD_INPUT):
        super().__init__(message)
        self.status = status


class InputError(KalosError, ValueError):
    """An argument of the Python interface that cannot be used: its name, its shape and what is expected."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, or the stop button of a notebook, ended a solve.

    partial is the result of the rounds that were complete, with the standard errors they reached; None before the first.
    """

    def __init__(self, partial):
        super().__init__("stopped before the end; " + ("no round was complete" if partial is None else
                                                       f"partial holds the {partial.trajectories} trajectories until then"))
        self.partial = partial


def update(algorithm, request=None):
    """Brings a VTK algorithm up to date; its first error event becomes a KalosError."""
    messages = []

    def note(_caller, _event, text):
        messages.append(plain(text))

    def tell(_caller, _event, text):
        warn(plain(text))

    note.CallDataType = VTK_STRING
    tell.CallDataType = VTK_STRING
    # The executive complains a second time when an algorithm has failed: listening keeps that off the screen.
    tags = [(caller, caller.AddObserver(event, action))
            for caller in (algorithm, algorithm.GetExecutive())
            for event, action in (("ErrorEvent", note), ("WarningEvent", tell))]
    try:
        (request or algorithm.Update)()
    finally:
        for caller, tag in tags:
            caller.RemoveObserver(tag)
    failed(algorithm, messages)


def failed(algorithm, messages):
    """Raises the first of the error messages of an update, if there are any."""
    if messages:
        ended = getattr(algorithm, "GetErrorCode", int)() == UNKNOWN_ERROR  # a failure of the work itself, not bad input
        raise KalosError(messages[0], FAILED if ended else BAD_INPUT)


def warn(message):
    print(f"kalos: warning: {message}", file=sys.stderr)


def plain(text):
    """The message of a VTK error event without the source line and the address before it."""
    if text is None:  # the wrapping decodes UTF-8 only, and a message quotes what it found
        return "input: not UTF-8 text; expected UTF-8"
    return re.sub(r"\A(?:ERROR|Warning): In .*?\n(?:\w+ \([^)]*\): )?", "", text, flags=re.DOTALL).strip()
