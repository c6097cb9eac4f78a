# SPDX-License-Identifier: BSD-3-Clause
"""`kalos study`: a scene with every combination of settings."""
from kalos.commands.arguments import sweep
from kalos.commands.options import add_method_options, options_of
from kalos.core.limits import COUNT
from kalos.core.options import REFERENCE_TRAJECTORIES


def add(commands):
    command = commands.add_parser("study", help="solve a scene with every combination of settings and measure the errors")
    command.add_argument("scene", metavar="SCENE.json", help="the scene file; its first camera is solved, or its receivers")
    command.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    command.add_argument("--sweep", metavar="NAME=v1,v2,...", type=sweep, action="append", default=[],
                       help="values of trajectories, delta, epsilon, method or seed; may be repeated: every combination")
    command.add_argument("--table1", action="store_true",
                       help="the three series of Budak et al. (2023), Table 1, instead of --sweep")
    command.add_argument("--reference-trajectories", metavar="N", type=COUNT, default=REFERENCE_TRAJECTORIES,
                       help="of the reference by compensated, kept in DIR for the next study (%(default)s)")
    add_method_options(command, None)
    command.set_defaults(run=run)


def run(arguments):
    from kalos.studies.study import study
    from kalos.studies.sweep import combinations, table1

    if arguments.table1 and not arguments.method:
        arguments.method = "sphere-published"
    rows = (table1 if arguments.table1 else combinations)(arguments.sweep, options_of(arguments))
    study(arguments.scene, arguments.out, rows, arguments.reference_trajectories, say=print)
    return 0
