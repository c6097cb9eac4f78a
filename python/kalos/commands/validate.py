# SPDX-License-Identifier: BSD-3-Clause
"""`kalos validate`: every method against closed forms."""
from kalos.core.limits import COUNT, SEED
from kalos.core.options import METHODS
from kalos.errors import FAILED


def add(commands):
    command = commands.add_parser("validate", help="hold every method against scenes with a closed-form answer")
    command.add_argument("--method", choices=METHODS, action="append", metavar="METHOD",
                          help="only this method; may be repeated")
    command.add_argument("--trajectories", metavar="N", type=COUNT, help="per case, instead of the case's own number")
    command.add_argument("--seed", metavar="K", type=SEED, default=1, help="seed of the random numbers (%(default)s)")
    command.add_argument("--figures", action="store_true",
                          help="then print what compensated reaches near edges, on CIE 171 and against direct (minutes)")
    command.add_argument("--data", metavar="DIR", help="folder of the scenes, if not the one of the source tree")
    command.set_defaults(run=run)


def run(arguments):
    from kalos.validation.validate import validate

    passed = validate(arguments.data, arguments.method, arguments.trajectories, arguments.seed)
    if arguments.figures:
        from kalos.validation.figures import figures

        passed = figures(arguments.data, arguments.seed) and passed
    return 0 if passed else FAILED
