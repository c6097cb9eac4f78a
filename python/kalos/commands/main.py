# SPDX-License-Identifier: BSD-3-Clause
"""The command: options in, one line per error out. Everything it does is a function elsewhere in the package."""
import os
import sys
import traceback

from kalos import ranks
from kalos._build import __version__
from kalos.commands import chart, prepare, schema, solve, study, validate, year
from kalos.commands.arguments import Parser
from kalos.errors import FAILED, KalosError


def parser():
    top = Parser(prog="kalos", description="Illuminance and luminance of lit scenes, with an error bar on every value.")
    top.add_argument("--version", action="version", version=f"kalos {__version__}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for command in (solve, study, chart, year, prepare, validate, schema):
        command.add(commands)
    return top


def complete(words):
    """Prints completions and exits if the shell asks for them by argcomplete; else does nothing."""
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        argcomplete.autocomplete(words)


def main(arguments=None):
    """Runs the command; returns its exit status: 0 done, 1 failed, 2 bad input."""
    words = parser()
    complete(words)
    arguments = words.parse_args(arguments)
    try:
        if ranks.several() and arguments.run is not solve.run:
            raise KalosError(f"{arguments.command}: runs in one process; expected no mpiexec, or kalos solve")
        return arguments.run(arguments)
    except KalosError as error:
        return ranks.current.complain(error, error.status)
    except KeyboardInterrupt:
        return ranks.current.complain("stopped before the end; nothing was written", FAILED)
    except MemoryError:
        return ranks.current.complain("out of memory; nothing was written", FAILED)
    except BrokenPipeError:
        sys.stderr.close()
        return FAILED
    except Exception:
        if ranks.current.size == 1:
            raise
        traceback.print_exc()  # the other ranks would wait for this one
        return ranks.current.complain("failed; the lines above say where", FAILED)
