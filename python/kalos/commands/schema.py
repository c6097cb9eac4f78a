# SPDX-License-Identifier: BSD-3-Clause
"""`kalos schema`: the format of the files, for editors and checkers."""
from kalos.schemas import KINDS, schema


def add(commands):
    command = commands.add_parser("schema", help="print the JSON Schema of scene files or of summary.json",
                                  description="Prints a JSON Schema: editors complete and check files with it.")
    command.add_argument("kind", nargs="?", choices=KINDS, default="scene", metavar="scene|summary",
                         help="the file whose format is wanted (%(default)s)")
    command.set_defaults(run=run)


def run(arguments):
    print(schema(arguments.kind), end="")
    return 0
