# SPDX-License-Identifier: BSD-3-Clause
"""What the manual takes from the sources: a line `<!-- generate: NAME ... -->` of a page becomes what NAME writes.

Sources are quoted by the role `source`: {source}`PATH:TEXT` links to the one line of PATH that holds TEXT, and the build
fails when there is none any more, or a second one.
"""
from kalos_manual import api, generated, katex, sources


def setup(app):
    api.setup(app)
    generated.setup(app)
    katex.setup(app)
    sources.setup(app)
    return {"version": "1", "parallel_read_safe": False, "parallel_write_safe": False}
