# SPDX-License-Identifier: BSD-3-Clause
"""Source files are formatted as .clang-format says and carry their licence."""
import subprocess

from sources import name, sources


def test_cpp_is_formatted():
    files = sources(".h", ".cxx")
    assert files
    result = subprocess.run(["clang-format", "--dry-run", "-Werror", *files], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr


def test_every_source_has_its_licence():
    bare = [name(path) for path in sources(".h", ".cxx", ".py")
            if "SPDX-License-Identifier: BSD-3-Clause" not in path.read_text(encoding="utf-8")[:200]]
    assert not bare


def test_no_tables_in_the_manuals_of_classes():
    """VTK's wrapping breaks the lines of a header's comment anew for help(); a list survives that, a table does not."""
    assert not [name(path) for path in sources(".h", below=("modules",)) if "\n * | " in path.read_text(encoding="utf-8")]
