# SPDX-License-Identifier: BSD-3-Clause
"""Words of the command line turned into values; one line for each that can not be."""
import argparse
import math
import re
import sys

from kalos.errors import BAD_INPUT
from kalos.estimator import METHODS, SAVINGS
from kalos.peers import NAMES as PEERS


class Parser(argparse.ArgumentParser):
    """Errors as one line, like every other error of the command."""

    def error(self, message):
        message = message.removeprefix("argument ").replace("the following arguments are required: ", "missing ")
        print(f"kalos: error: {message}; kalos {self.command} --help tells more".replace("kalos  --", "kalos --"),
              file=sys.stderr)
        sys.exit(BAD_INPUT)

    @property
    def command(self):
        return " ".join(self.prog.split()[1:])


def quantity(kind, expected, accept):
    """An argparse type: a number that `accept` likes, else an error that says what is expected."""

    def parse(text):
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not math.isfinite(value) or not accept(value):
            raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected {expected}")
        return value

    return parse


COUNT = quantity(int, "a whole number from 1 to 9223372036854775807", lambda n: 1 <= n < 2**63)
GIVEN_LENGTH = quantity(float, "auto, or a length > 0 in metres", lambda x: x > 0)
RELATIVE = quantity(float, "a relative error > 0 and < 1, such as 0.01", lambda x: 0 < x < 1)
FLOOR = quantity(float, "a half-width of 0 lx or more", lambda x: x >= 0)
TIME = quantity(float, "a time > 0, in seconds", lambda x: x > 0)
SEED = quantity(int, "a whole number from 0 to 2147483647", lambda n: 0 <= n < 2**31)
THREADS = quantity(int, "a whole number from 0 (all) to 1024", lambda n: 0 <= n <= 1024)


def length(text):
    """A length in metres; None, which is automatic, for the word auto."""
    return None if text == "auto" else GIVEN_LENGTH(text)


def method(text):
    if text not in METHODS:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected one of {', '.join(METHODS)}")
    return text


def methods(text):
    """Methods of Kalos, each once."""
    return tuple(dict.fromkeys(method(name) for name in text.split(",")))


def savings(text):
    """Savings to do without, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in SAVINGS:
            raise argparse.ArgumentTypeError(f"{name!r} is not allowed, expected some of {', '.join(SAVINGS)}")
    return names


def peers(text):
    """Names of peers, each once; none for the word none."""
    names = () if text == "none" else tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in PEERS:
            raise argparse.ArgumentTypeError(f"{name!r} is not allowed, expected none, or some of {', '.join(PEERS)}")
    return names


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
