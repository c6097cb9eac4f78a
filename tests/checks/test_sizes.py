# SPDX-License-Identifier: BSD-3-Clause
"""Files and functions that can be read at once: 300 lines a file, 60 a function, its signature included.

Prints the median file and the longest function: python3 -m pytest -s tests/checks/test_sizes.py.
"""
import ast
import re
import statistics

import pytest
from sources import name, sources

LARGEST_FILE = 300
LARGEST_FUNCTION = 60
OPENS = re.compile(r"^( *)\{$")
HOLDS_FUNCTIONS = re.compile(r"^(template <.*> )?(inline |typedef |extern )*(namespace|class|struct|enum|union|extern)\b")
ENDS_STATEMENT = re.compile(r"[;{}]$|^#|^\s*(//|/\*|\*)|^\s*(public|protected|private):$|^$")


def cpp_functions(text):
    """(name, lines) of every function of a file that clang-format has laid out: braces stand alone, indented as their pair."""
    lines = [re.sub(r"\s+//.*", "", line) for line in text.splitlines()]
    last = 0
    for i, line in enumerate(lines):
        opening = OPENS.match(line)
        if not opening or i < last:
            continue
        first = i
        while first > 0 and not ENDS_STATEMENT.search(lines[first - 1]):
            first -= 1
        signature = " ".join(lines[first:i]).strip()
        if not signature or HOLDS_FUNCTIONS.match(signature) or signature.endswith("="):
            continue
        last = next(j for j in range(i, len(lines)) if lines[j].startswith(opening[1] + "}"))
        yield signature, last - first + 1


def python_functions(text):
    """(name, lines) of every function, those inside functions too."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.end_lineno - node.lineno + 1


FUNCTIONS = {".cxx": cpp_functions, ".h": cpp_functions, ".py": python_functions}


def functions():
    """(lines, place and name) of all functions of the tree."""
    return [(lines, f"{name(path)}: {signature}") for path in sources(*FUNCTIONS)
            for signature, lines in FUNCTIONS[path.suffix](path.read_text(encoding="utf-8"))]


def test_files_are_short():
    lengths = {name(path): len(path.read_text(encoding="utf-8").splitlines()) for path in sources(*FUNCTIONS)}
    longest = max(lengths, key=lengths.get)
    print(f"\nmedian file {statistics.median(lengths.values()):.0f} lines, longest {longest}: {lengths[longest]}")
    assert not {path: lines for path, lines in lengths.items() if lines > LARGEST_FILE}


def test_functions_are_short():
    found = functions()
    assert len(found) > 1000
    print("\nlongest functions:", *(f"{lines} {place}" for lines, place in sorted(found, reverse=True)[:3]), sep="\n  ")
    assert not [f"{place}: {lines} lines" for lines, place in found if lines > LARGEST_FUNCTION]


CPP = """\
namespace
{
struct Pair
{
  int first;
  int sum() const
  {
    return 0;
  }
};
}  // namespace

Pair::Pair(int a,
           int b)
    : first(a)
{
  if (b)
  {
    first = 0;
  }
}
"""


def test_lines_of_functions_are_counted():
    assert list(cpp_functions(CPP)) == [("int sum() const", 4), ("Pair::Pair(int a,            int b)     : first(a)", 9)]
    assert list(python_functions("@cached\ndef one():\n    def two():\n        pass\n    return two\n")) == [("one", 4), ("two", 2)]


@pytest.mark.parametrize("line", ["namespace kalos", "class A : public B", "enum class Method", "template <class T> struct Pair"])
def test_what_holds_functions_is_none(line):
    assert not list(cpp_functions(line + "\n{\n};\n"))
