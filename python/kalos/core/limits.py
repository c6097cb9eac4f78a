# SPDX-License-Identifier: BSD-3-Clause
"""The values that options may have: text is converted to a number or name, or an error says what is expected."""
import argparse
import math

from kalos.core.options import ELEMENTS, METHODS, OWN_OPTIONS, TECHNIQUES, Options
from kalos.errors import InputError


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
PIXEL_SAMPLES = quantity(int, "a whole number from 1 to 256", lambda n: 1 <= n <= 256)
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


def techniques(text):
    """Techniques to switch off, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in TECHNIQUES:
            raise argparse.ArgumentTypeError(f"{name!r} is not allowed, expected some of {', '.join(TECHNIQUES)}")
    return names


def elements(text):
    if text not in ELEMENTS:
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected {' or '.join(ELEMENTS)}")
    return text


CONNECTIONS = quantity(int, "all, or a whole number from 1 to 100", lambda n: 1 <= n <= 100)


def connections(text):
    """A number of connections; None, which is all of them, for that word."""
    return None if text == "all" else CONNECTIONS(text)


def flag(text):
    if text not in ("True", "False"):
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed, expected True or False")
    return text == "True"


TYPES = {"method": method, "trajectories": COUNT, "error": RELATIVE, "error_floor": FLOOR, "time": TIME, "delta": GIVEN_LENGTH,
         "epsilon": GIVEN_LENGTH, "seed": SEED, "threads": THREADS, "pixel_samples": PIXEL_SAMPLES,
         "photons": COUNT, "cone_filter": flag, "final_gather": flag, "elements": elements, "connections": connections}


def checked_options(disable=(), checkpoint=None, method_options=None, **given):
    """Options from the arguments of a Python call, held to what the command allows; InputError names the one that is not."""
    for name, value in (method_options or {}).items():
        if name not in OWN_OPTIONS:
            raise InputError(f"method_options: {name!r} is not there, expected some of {', '.join(OWN_OPTIONS)}")
        given[name] = value
    values = {}
    for name, value in given.items():
        if value is not None or name in ("method", "seed", "threads"):
            values[name] = converted(name, TYPES[name], str(value))
    if disable:
        values["disable"] = converted("disable", techniques, disable if isinstance(disable, str) else ",".join(disable))
    options = Options(**values, checkpoint=checkpoint)
    wrong = options.for_another_method()
    if wrong:
        name, methods = wrong
        raise InputError(f"method_options: {name} has no effect on {options.method}, expected method {' or '.join(methods)}")
    return options


def converted(name, convert, text):
    try:
        return convert(text)
    except argparse.ArgumentTypeError as wrong:
        raise InputError(f"{name}: {wrong}") from None
