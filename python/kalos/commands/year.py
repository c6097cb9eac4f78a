# SPDX-License-Identifier: BSD-3-Clause
"""`kalos year`: daylight over a year."""
from kalos.commands.options import add_method_options, options_of
from kalos.core.options import DEFAULT_METHOD

PATCHES = {"145": 1, "577": 2}
EACH = 1024  # trajectories for each patch: of 145 independent errors little is left in their sum


def add(commands):
    command = commands.add_parser("year", help="daylight over a year of weather: autonomy, useful illuminance, every hour")
    command.add_argument("scene", metavar="SCENE.json", help="the scene file; its luminaires do not count, of its sky only ground and north")
    command.add_argument("--weather", metavar="FILE.epw", required=True, help="weather file of EnergyPlus")
    command.add_argument("--out", metavar="DIR", required=True, help="folder for the results; made if it is not there")
    command.add_argument("--patches", choices=sorted(PATCHES), default="145", help="of the sky, by Reinhart (%(default)s)")
    command.add_argument("--no-prepare", action="store_false", dest="prepare", help="take the surfaces as they are")
    add_method_options(command, DEFAULT_METHOD)
    command.set_defaults(run=run, trajectories=EACH)


def run(arguments):
    from kalos.daylight.year import year

    year(arguments.scene, arguments.weather, arguments.out, options_of(arguments), PATCHES[arguments.patches], arguments.prepare)
    return 0
