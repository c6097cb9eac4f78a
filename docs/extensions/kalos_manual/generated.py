# SPDX-License-Identifier: BSD-3-Clause
"""Pages written from the sources: `<!-- generate: NAME ARGUMENT... -->` stands for what a writer returns as Markdown."""
import re

from docutils import nodes

from kalos_manual import arrays, command, notebook, proxies, scene, vtk_classes

WRITERS = {"arrays": arrays.write, "command": command.write, "notebook": notebook.write, "proxies": proxies.write,
           "scene": scene.write, "summary": scene.write_summary, "vtk-classes": vtk_classes.write}
MARK = re.compile(r"^<!-- generate: (\S+) ?(.*?) ?-->$", re.MULTILINE)


def fill(app, name, text):
    text[0] = MARK.sub(lambda mark: WRITERS[mark[1]](*mark[2].split()), text[0])


def drop_titles(app, tree):
    """A property's methods are a group of Doxygen without a name; Breathe says so, which tells nobody anything."""
    for title in [node for node in tree.findall(nodes.rubric) if node.astext() == "Unnamed Group"]:
        title.parent.remove(title)


def setup(app):
    app.connect("doctree-read", drop_titles)
    app.connect("source-read", fill)
