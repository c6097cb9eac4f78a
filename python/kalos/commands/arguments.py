# SPDX-License-Identifier: BSD-3-Clause
"""Values of command-line options; each one that is not allowed gives an error of one line."""
import argparse
import math
import re
import sys

from kalos.core.limits import COUNT, SEED, length, method
from kalos.errors import BAD_INPUT
from kalos.peers import NAMES as PEERS
from kalos.results.tasks import Task


class Parser(argparse.ArgumentParser):
    """A parser that prints its errors as one line, like every other error of the command."""

    def error(self, message):
        message = message.removeprefix("argument ").replace("the following arguments are required: ", "missing ")
        print(f"kalos: error: {message}; kalos {self.command} --help tells more".replace("kalos  --", "kalos --"),
              file=sys.stderr)
        sys.exit(BAD_INPUT)

    @property
    def command(self):
        return " ".join(self.prog.split()[1:])


def methods(text):
    """Methods of Kalos, each once."""
    return tuple(dict.fromkeys(method(name) for name in text.split(",")))


def peers(text):
    """Names of peers, each once; none for the word none."""
    names = () if text == "none" else tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in PEERS:
            raise argparse.ArgumentTypeError(f"{name!r} is not allowed, expected none, or some of {', '.join(PEERS)}")
    return names


def ends(text):
    """LOW:HIGH, two numbers of which the second is larger."""
    try:
        low, high = (float(part) for part in text.split(":"))
    except ValueError:
        low, high = math.nan, math.nan
    if not (0 <= low < high < math.inf):
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected LOW:HIGH, such as 0:500, with 0 <= LOW < HIGH")
    return low, high


def task(text):
    """NAME:LX or NAME:LX:U0; a name may hold colons itself."""
    found = re.fullmatch(r"(.+?):([0-9.]+)(?::(0?\.[0-9]+|[01]))?", text)
    try:
        return Task(found[1], float(found[2]), None if found[3] is None else float(found[3]))
    except (TypeError, ValueError):
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected NAME:LX or NAME:LX:U0, such as desk:500:0.6") from None


def receiver_and_replicate(text):
    """RECEIVER:REPLICATE, two numbers from 0."""
    found = re.fullmatch(r"(\d{1,18}):(\d{1,9})", text)
    if not found:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected RECEIVER:REPLICATE, such as 12:3")
    return int(found[1]), int(found[2])


SWEEPS = {"trajectories": COUNT, "delta": length, "epsilon": length, "method": method, "seed": SEED}


def sweep(text):
    """NAME=v1,v2,...: the name of an option and the values it takes in turn."""
    name, separator, values = text.partition("=")
    if not separator or name not in SWEEPS:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected NAME=v1,v2,... with a NAME out of "
                                         f"{', '.join(SWEEPS)}")
    try:
        found = tuple(SWEEPS[name](value) for value in values.split(","))
    except argparse.ArgumentTypeError as error:
        raise argparse.ArgumentTypeError(f"{name}: {error}") from None
    if len(set(found)) < len(found):
        raise argparse.ArgumentTypeError(f"{name}: a value appears twice in {values!r}, expected each once")
    return name, found
