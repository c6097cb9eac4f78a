# SPDX-License-Identifier: BSD-3-Clause
"""`kalos chart`: the error of every method against time."""
from kalos.commands.arguments import PEERS, methods, peers
from kalos.core.limits import COUNT, SEED, TIME, quantity
from kalos.core.options import METHODS, REFERENCE_TRAJECTORIES


def add(commands):
    command = commands.add_parser("chart", help="draw the error of every method against time, and of the peers that are installed")
    add = command.add_argument
    add("scene", metavar="SCENE.json", help="the scene file")
    add("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    add("--receivers", metavar="NAME", help="the receiver set to measure on (all of the scene, together)")
    add("--camera", metavar="NAME", help="the camera to measure the image of, instead of receivers")
    add("--methods", metavar="a,b,...", type=methods, help=f"methods of Kalos out of {', '.join(METHODS)} (all)")
    add("--peers", metavar="a,b,...", type=peers, default=PEERS,
        help=f"other programs out of {', '.join(PEERS)}, or none (all that are installed where KALOS_PEERS_PYTHON points to)")
    add("--relative-to", choices=("value", "mean"), default="value",
        help="what errors are a share of: each receiver's value, or the mean over them (%(default)s)")
    add("--budget", metavar="SECONDS", type=TIME, default=60.0, help="processor time per method or peer, s (%(default)g)")
    add("--reference-trajectories", metavar="N", type=COUNT, default=REFERENCE_TRAJECTORIES,
        help="of the reference by compensated, kept in DIR for the next chart; where no closed form is known (%(default)s)")
    add("--seed", metavar="K", type=SEED, default=1, help="first of the seeds of the random numbers (%(default)s)")
    add("--threads", metavar="T", type=quantity(int, "a whole number from 1 to 1024", lambda n: 1 <= n <= 1024), default=1,
        help="threads of every contender (%(default)s)")
    command.set_defaults(run=run)


def run(arguments):
    from kalos.charts.chart import chart

    chart(arguments.scene, arguments.out, arguments.receivers, arguments.methods, arguments.peers, arguments.relative_to,
          arguments.budget, arguments.reference_trajectories, arguments.seed, arguments.threads, say=print, camera=arguments.camera)
    return 0
