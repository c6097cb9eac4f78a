# SPDX-License-Identifier: BSD-3-Clause
"""`kalos atlas`: how each method fails, one picture a scene."""
import argparse

from kalos.commands.arguments import methods
from kalos.core.limits import SEED, TIME
from kalos.core.options import METHODS

SCENES = ("furnace-edge", "dihedral", "contact", "keyhole", "glossy-room", "many-lamps", "caustic", "empty-room")


def scenes(text):
    """Scenes of the atlas, each once."""
    names = tuple(dict.fromkeys(text.split(",")))
    for name in names:
        if name not in SCENES:
            raise argparse.ArgumentTypeError(f"{name!r} is not allowed, expected some of {', '.join(SCENES)}")
    return names


def add(commands):
    command = commands.add_parser("atlas", help="draw how each method fails, beside the truth")
    add_one = command.add_argument
    add_one("--out", metavar="DIR", required=True, help="folder for the page and its pictures; made if it is not there")
    add_one("--scenes", metavar="a,b,...", type=scenes, help=f"out of {', '.join(SCENES)} (all)")
    add_one("--methods", metavar="a,b,...", type=methods, help=f"out of {', '.join(METHODS)} (all)")
    add_one("--budget", metavar="SECONDS", type=TIME, default=1.0, help="processor time per method and scene, s (%(default)g)")
    add_one("--seed", metavar="K", type=SEED, default=1, help="first of the seeds of the random numbers (%(default)s)")
    command.set_defaults(run=run)


def run(arguments):
    from kalos.charts.atlas import atlas

    atlas(arguments.out, arguments.scenes, arguments.methods, arguments.budget, arguments.seed, say=print)
    return 0
