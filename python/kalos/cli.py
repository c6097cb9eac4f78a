# SPDX-License-Identifier: BSD-3-Clause
"""The command: options in, one line per error out. Everything it does is a function elsewhere in the package."""
import sys
import traceback

from kalos import __version__, ranks
from kalos.arguments import (COUNT, FLOOR, PEERS, RELATIVE, SEED, THREADS, TIME, Parser, length, methods, peers, quantity,
                             receiver_and_replicate, savings, sweep)
from kalos.errors import FAILED, KalosError
from kalos.estimator import DEFAULT_METHOD, METHODS, REFERENCE_TRAJECTORIES, SAVINGS, Options
from kalos.model_file import AXES, UNITS, placed

EDGE_LENGTH = quantity(float, "a length > 0, in metres", lambda x: x > 0)


def parser():
    top = Parser(prog="kalos", description="Illuminance and luminance of lit scenes, with an error bar on every value.")
    top.add_argument("--version", action="version", version=f"kalos {__version__}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True)

    solve = commands.add_parser("solve", help="solve a scene into a folder of tables and pictures")
    solve.add_argument("scene", metavar="SCENE", help="the scene file (.json), or a model with light in it (.glb, .gltf, .obj)")
    solve.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    solve.add_argument("--unit", choices=UNITS, help="unit of length of a model (m)")
    solve.add_argument("--up", choices=AXES, help="axis of a model that is up (y for glTF, z for OBJ)")
    add_method_options(solve, DEFAULT_METHOD)
    add_goals(solve)
    solve.add_argument("--checkpoint", metavar="FILE",
                       help="keep the solve in FILE, FILE.CAMERA for cameras, every 10 s and when it is stopped; the same command "
                            "goes on from there to the same numbers, and takes the files away when it is done (none)")
    solve.add_argument("--without", metavar="a,b,...", type=savings,
                       help=f"do without some of {', '.join(SAVINGS)}, to measure what they save; no mean moves (none)")
    solve.add_argument("--replay", metavar="RECEIVER:REPLICATE", type=receiver_and_replicate,
                       help="write nothing, but recompute one replicate of such a solve and print its scores at one receiver, "
                            "counted over all sets from 0")
    solve.add_argument("--no-prepare", action="store_false", dest="prepare",
                       help="take the surfaces as they are: neither repair them nor look for singular edges")
    solve.add_argument("--report", action="store_true",
                       help="write report.html as well: plans with isolux lines, tables, luminaires, audit, in one page to print")
    solve.add_argument("--hdr", action="store_true", help="write NAME.hdr per camera as well, a Radiance picture")
    solve.set_defaults(run=run_solve)

    study = commands.add_parser("study", help="solve a scene with every combination of settings and measure the errors")
    study.add_argument("scene", metavar="SCENE.json", help="the scene file; its first camera is solved, or its receivers")
    study.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    study.add_argument("--sweep", metavar="NAME=v1,v2,...", type=sweep, action="append", default=[],
                       help="values of trajectories, delta, epsilon, method or seed; may be repeated: every combination")
    study.add_argument("--table1", action="store_true",
                       help="the three series of Budak et al. (2023), Table 1, instead of --sweep")
    study.add_argument("--reference-trajectories", metavar="N", type=COUNT, default=REFERENCE_TRAJECTORIES,
                       help="of the reference by compensated, kept in DIR for the next study (%(default)s)")
    add_method_options(study, None)
    study.set_defaults(run=run_study)

    chart = commands.add_parser("chart", help="draw the error of every method against time, and of the peers that are installed")
    add_chart_options(chart)
    chart.set_defaults(run=run_chart)

    prepare = commands.add_parser("prepare", help="repair a mesh, remesh it if wanted, and find its singular edges")
    prepare.add_argument("mesh", metavar="IN", help="the mesh: .obj, .ply, .stl, .off, .gltf, .glb or .vtp, in metres")
    prepare.add_argument("--out", metavar="OUT.vtp", required=True, help="file for the prepared surface")
    prepare.add_argument("--edge-length", metavar="M", type=EDGE_LENGTH, help="remesh to edges of about this length, m (off)")
    prepare.add_argument("--report", metavar="FILE.json", help="file for what was done (none)")
    prepare.add_argument("--time", metavar="SECONDS", type=TIME, help="give up each step after so long (600)")
    prepare.set_defaults(run=run_prepare)

    validate = commands.add_parser("validate", help="hold every method against scenes with a closed-form answer")
    validate.add_argument("--method", choices=METHODS, action="append", metavar="METHOD",
                          help="only this method; may be repeated")
    validate.add_argument("--trajectories", metavar="N", type=COUNT, help="per case, instead of the case's own number")
    validate.add_argument("--seed", metavar="K", type=SEED, default=1, help="seed of the random numbers (%(default)s)")
    validate.add_argument("--figures", action="store_true",
                          help="then print what compensated reaches near edges, on CIE 171 and against direct (minutes)")
    validate.add_argument("--data", metavar="DIR", help="folder of the scenes, if not the one of the source tree")
    validate.set_defaults(run=run_validate)
    return top


def add_method_options(command, method):
    """What a single estimate depends on; `method` is the default."""
    defaults = Options()
    add = command.add_argument
    add("--method", choices=METHODS, default=method, metavar="METHOD",
        help=f"one of {', '.join(METHODS)} ({method or f'{DEFAULT_METHOD}; sphere-published with --table1'})")
    add("--trajectories", metavar="N", type=COUNT,
        help="at most so many trajectories (10000; no limit with --error or --time)")
    add("--delta", metavar="M", type=length,
        help="distance below which the methods with a neighbourhood alter the kernel, m (auto: from the vertices' density)")
    add("--epsilon", metavar="M", type=length, help="radius of the neighbourhood, m (auto: likewise)")
    add("--seed", metavar="K", type=SEED, default=defaults.seed, help="seed of the random numbers (%(default)s)")
    add("--threads", metavar="T", type=THREADS, default=defaults.threads, help="threads, 0 for all (%(default)s)")


def add_chart_options(command):
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


def add_goals(command):
    add = command.add_argument
    add("--error", metavar="E", type=RELATIVE,
        help="stop when every 95 %% half-width is within E of its value, or below the floor (off)")
    add("--error-floor", metavar="LX", type=FLOOR,
        help="half-width that is small enough for any value, lx (auto: E of a hundredth of the mean)")
    add("--time", metavar="SECONDS", type=TIME, help="stop each solve after so many seconds (off)")


def options_of(arguments):
    given = {name: getattr(arguments, name, None) for name in Options.__dataclass_fields__}
    return Options(**{name: value for name, value in given.items() if value is not None})


def run_solve(arguments):
    from kalos.solve import replay, solve, take_part

    arguments.scene = placed(arguments.scene, arguments.unit, arguments.up)
    if arguments.replay:
        replay(arguments.scene, *arguments.replay, options_of(arguments), arguments.prepare)
        return 0
    if ranks.join().rank:
        take_part(arguments.scene, options_of(arguments), arguments.prepare)
    else:
        solve(arguments.scene, arguments.out, options_of(arguments), say=print, preparing=arguments.prepare,
              report=arguments.report, hdr=arguments.hdr)
    return 0


def run_study(arguments):
    from kalos.study import study

    from kalos.sweep import combinations, table1

    if arguments.table1 and not arguments.method:
        arguments.method = "sphere-published"
    rows = (table1 if arguments.table1 else combinations)(arguments.sweep, options_of(arguments))
    study(arguments.scene, arguments.out, rows, arguments.reference_trajectories, say=print)
    return 0


def run_chart(arguments):
    from kalos.chart import chart

    chart(arguments.scene, arguments.out, arguments.receivers, arguments.methods, arguments.peers, arguments.relative_to,
          arguments.budget, arguments.reference_trajectories, arguments.seed, arguments.threads, say=print, camera=arguments.camera)
    return 0


def run_prepare(arguments):
    from kalos.prepare import prepare

    prepare(arguments.mesh, arguments.out, arguments.edge_length, arguments.report, say=print,
            time_limit=arguments.time)
    return 0


def run_validate(arguments):
    from kalos.validate import validate

    passed = validate(arguments.data, arguments.method, arguments.trajectories, arguments.seed)
    if arguments.figures:
        from kalos.figures import figures

        passed = figures(arguments.data, arguments.seed) and passed
    return 0 if passed else FAILED


def main(arguments=None):
    """Runs the command; returns its exit status: 0 done, 1 failed, 2 bad input."""
    arguments = parser().parse_args(arguments)
    try:
        if ranks.several() and arguments.run is not run_solve:
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
