# SPDX-License-Identifier: BSD-3-Clause
"""`kalos solve`: a scene into a folder of tables and pictures."""
from kalos import ranks
from kalos.commands.arguments import ends, receiver_and_replicate, task
from kalos.commands.options import add_method_options, options_of
from kalos.core.limits import FLOOR, PIXEL_SAMPLES, RELATIVE, TIME, techniques
from kalos.core.options import DEFAULT_METHOD, TECHNIQUES, Options
from kalos.pictures.look import OWN_COLOURS, Look
from kalos.scenes.model_file import AXES, UNITS, placed


def add(commands):
    command = commands.add_parser("solve", help="solve a scene into a folder of tables and pictures",
                                  epilog="The format of scene files is described by `kalos schema`, that of summary.json by "
                                         "`kalos schema summary`.")
    command.add_argument("scene", metavar="SCENE", help="the scene file (.json), or a model with light in it (.glb, .gltf, .obj)")
    command.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    command.add_argument("--unit", choices=UNITS, help="unit of length of a model (m)")
    command.add_argument("--up", choices=AXES, help="axis of a model that is up (y for glTF, z for OBJ)")
    add_method_options(command, DEFAULT_METHOD)
    add_goals(command)
    command.add_argument("--checkpoint", metavar="FILE",
                       help="save the state of the solve in FILE, FILE.CAMERA for cameras, every 10 s and when it is stopped; the same "
                            "command resumes from there with the same numbers, and deletes the files when it is done (none)")
    command.add_argument("--pixel-samples", metavar="N", type=PIXEL_SAMPLES, default=Options().pixel_samples,
                         help="lines of sight in a pixel that sees an edge; others have one through their centre (%(default)s)")
    command.add_argument("--disable", metavar="NAME,...", type=techniques,
                       help=f"switch off some of {', '.join(TECHNIQUES)}, to measure what each saves; no mean changes (none)")
    command.add_argument("--replay", metavar="RECEIVER:REPLICATE", type=receiver_and_replicate,
                       help="recompute one replicate of such a solve and print its scores at one receiver, without writing files; "
                            "receivers count over all sets from 0")
    command.add_argument("--no-prepare", action="store_false", dest="prepare",
                       help="take the surfaces as they are: neither repair them nor look for singular edges")
    command.add_argument("--all-points", action="store_true",
                         help="count receivers that are inside a solid, below a surface or outside in means and uniformities, too")
    add_look(command)
    command.add_argument("--report", action="store_true",
                       help="write report.html as well: plans with isolux lines, tables, luminaires, audit, in one page to print")
    command.add_argument("--author", metavar="NAME", help="whom report.html names beside the date (nobody)")
    command.add_argument("--require", metavar="NAME:LX[:U0]", type=task, action="append", default=[],
                         help="required mean illuminance and uniformity of a receiver set, as of a task of EN 12464-1: pass or fail in the "
                              "table, summary.json and report.html; may be repeated")
    command.add_argument("--hdr", action="store_true", help="write NAME.hdr per camera as well, a Radiance picture")
    command.set_defaults(run=run)


def add_look(command):
    add = command.add_argument
    add("--range", metavar="LOW:HIGH", type=ends, help="ends of the scale of illuminance in pictures, lx (auto: 0 to the largest value)")
    add("--luminance-range", metavar="LOW:HIGH", type=ends, help="ends of the scale of luminance in pictures, cd/m2 (auto)")
    add("--log", action="store_true", help="a logarithmic scale in pictures; three decades if the range is automatic")
    add("--colours", metavar="NAME", default=OWN_COLOURS,
        help="colours of pictures: kalos, or a colour map of Matplotlib such as viridis or gray (%(default)s)")
    add("--isolines", action="store_true", help="draw lines of equal illuminance on flat receiver sets, of equal luminance on images")


def look_of(arguments):
    return Look(arguments.range, arguments.luminance_range, arguments.log, arguments.colours, arguments.isolines)


def add_goals(command):
    add = command.add_argument
    add("--error", metavar="E", type=RELATIVE,
        help="stop when the 95 %% half-width of every value is within the fraction E of it, or below the floor (off)")
    add("--error-floor", metavar="LX", type=FLOOR,
        help="half-width that is small enough for any value, lx (auto: E of a hundredth of the mean)")
    add("--time", metavar="SECONDS", type=TIME, help="stop each solve after so many seconds (off)")


def run(arguments):
    from kalos.solving.solve import replay, solve, take_part

    arguments.scene = placed(arguments.scene, arguments.unit, arguments.up)
    if arguments.replay:
        replay(arguments.scene, *arguments.replay, options_of(arguments), arguments.prepare)
        return 0
    if ranks.join().rank:
        take_part(arguments.scene, options_of(arguments), arguments.prepare)
    else:
        solve(arguments.scene, arguments.out, options_of(arguments), say=print, preparing=arguments.prepare,
              report=arguments.report, hdr=arguments.hdr, everywhere=arguments.all_points, look=look_of(arguments),
              tasks=arguments.require, author=arguments.author)
    return 0
