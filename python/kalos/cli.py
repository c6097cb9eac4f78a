# SPDX-License-Identifier: BSD-3-Clause
"""The command: options in, one line per error out. Everything it does is a function elsewhere in the package."""
import argparse
import math
import sys

from kalos import __version__
from kalos.errors import BAD_INPUT, FAILED, KalosError
from kalos.estimator import DEFAULT_METHOD, METHODS, Options


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


LENGTH = quantity(float, "auto, or a length > 0 in metres", lambda x: x > 0)
COUNT = quantity(int, "a whole number from 1 to 9223372036854775807", lambda n: 1 <= n < 2**63)
RELATIVE = quantity(float, "a relative error > 0 and < 1, such as 0.01", lambda x: 0 < x < 1)
TIME = quantity(float, "a time > 0, in seconds", lambda x: x > 0)
SEED = quantity(int, "a whole number from 0 to 2147483647", lambda n: 0 <= n < 2**31)
THREADS = quantity(int, "a whole number from 0 (all) to 1024", lambda n: 0 <= n <= 1024)


def length(text):
    """A length in metres; None, which is automatic, for the word auto."""
    return None if text == "auto" else LENGTH(text)


def parser():
    top = Parser(prog="kalos", description="Illuminance and luminance of lit scenes, with an error bar on every value.")
    top.add_argument("--version", action="version", version=f"kalos {__version__}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True)

    solve = commands.add_parser("solve", help="solve a scene into a folder of tables and pictures")
    solve.add_argument("scene", metavar="SCENE.json", help="the scene file")
    solve.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    add_estimator_options(solve)
    solve.set_defaults(run=run_solve)

    validate = commands.add_parser("validate", help="hold every method against scenes with a closed-form answer")
    validate.add_argument("--method", choices=METHODS, action="append", metavar="METHOD",
                          help="only this method; may be repeated")
    validate.add_argument("--trajectories", metavar="N", type=COUNT, help="per case, instead of the case's own number")
    validate.add_argument("--seed", metavar="K", type=SEED, default=1, help="seed of the random numbers (%(default)s)")
    validate.add_argument("--data", metavar="DIR", help="folder of the scenes, if not the one of the source tree")
    validate.set_defaults(run=run_validate)
    return top


def add_estimator_options(command):
    defaults = Options()
    add = command.add_argument
    add("--method", choices=METHODS, default=DEFAULT_METHOD, metavar="METHOD",
        help=f"one of {', '.join(METHODS)} (%(default)s)")
    add("--trajectories", metavar="N", type=COUNT,
        help="at most so many trajectories (10000; no limit with --error or --time)")
    add("--delta", metavar="M", type=length,
        help="distance below which the methods with a neighbourhood alter the kernel, m (auto: from the vertices' density)")
    add("--epsilon", metavar="M", type=length, help="radius of the neighbourhood, m (auto: likewise)")
    add("--error", metavar="E", type=RELATIVE,
        help="stop when every 95 %% half-width is within E of its value (off)")
    add("--time", metavar="SECONDS", type=TIME, help="stop each solve after so many seconds (off)")
    add("--seed", metavar="K", type=SEED, default=defaults.seed, help="seed of the random numbers (%(default)s)")
    add("--threads", metavar="T", type=THREADS, default=defaults.threads, help="threads, 0 for all (%(default)s)")


def run_solve(arguments):
    from kalos.solve import solve

    options = Options(**{name: getattr(arguments, name) for name in Options.__dataclass_fields__})
    solve(arguments.scene, arguments.out, options, say=print)
    return 0


def run_validate(arguments):
    from kalos.validate import validate

    return 0 if validate(arguments.data, arguments.method, arguments.trajectories, arguments.seed) else FAILED


def main(arguments=None):
    """Runs the command; returns its exit status: 0 done, 1 failed, 2 bad input."""
    arguments = parser().parse_args(arguments)
    try:
        return arguments.run(arguments)
    except KalosError as error:
        print(f"kalos: error: {error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt:
        print("kalos: error: stopped before the end; nothing was written", file=sys.stderr)
        return FAILED
    except MemoryError:
        print("kalos: error: out of memory; nothing was written", file=sys.stderr)
        return FAILED
    except BrokenPipeError:
        sys.stderr.close()
        return FAILED
