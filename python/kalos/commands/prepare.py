# SPDX-License-Identifier: BSD-3-Clause
"""`kalos prepare`: a mesh repaired."""
from kalos.core.limits import TIME, quantity

EDGE_LENGTH = quantity(float, "a length > 0, in metres", lambda x: x > 0)


def add(commands):
    command = commands.add_parser("prepare", help="repair a mesh, remesh it if wanted, and find its singular edges")
    command.add_argument("mesh", metavar="IN", help="the mesh: .obj, .ply, .stl, .off, .gltf, .glb or .vtp, in metres")
    command.add_argument("--out", metavar="OUT.vtp", required=True, help="file for the prepared surface")
    command.add_argument("--edge-length", metavar="M", type=EDGE_LENGTH, help="remesh to edges of about this length, m (off)")
    command.add_argument("--report", metavar="FILE.json", help="file for what was done (none)")
    command.add_argument("--time", metavar="SECONDS", type=TIME, help="give up each step after so long (600)")
    command.set_defaults(run=run)


def run(arguments):
    from kalos.preparation.mesh import prepare

    prepare(arguments.mesh, arguments.out, arguments.edge_length, arguments.report, say=print,
            time_limit=arguments.time)
    return 0
