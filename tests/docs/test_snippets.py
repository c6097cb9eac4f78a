# SPDX-License-Identifier: BSD-3-Clause
"""Code in the manual and the README runs as it stands: Python a page at a time, commands in order, scene files by the reader.

A block below a line `<!-- not run: REASON -->` is not run; its commands must still be ones that the parser takes.
"""
import json
import os
import re
import shlex
import subprocess
import sys

import pytest
from pages import DOCS, PAGES, README, ROOT, blocks, name

import kalos
from kalos.commands.main import parser
from kalos.schemas import schema

PYTHON = {page: [block.text for block in blocks("python") if block.page == page and not block.reason] for page in PAGES}
COMMANDS = set(parser()._subparsers._group_actions[0].choices)
SHELL = [block for block in blocks("sh") if "apps/demo" not in block.text and "export" not in block.text]


@pytest.fixture
def place(tmp_path):
    """A folder like the root of the tree."""
    for entry in ("data", "examples"):
        (tmp_path / entry).symlink_to(ROOT / entry)
    return tmp_path


@pytest.mark.parametrize("page", [page for page, found in PYTHON.items() if found], ids=name)
def test_python(page, place):
    """What stands on a page runs from top to bottom, without a warning."""
    ran = subprocess.run([sys.executable, "-c", "\n".join(PYTHON[page])], cwd=place, capture_output=True, text=True, check=False)
    assert ran.returncode == 0 and "warning" not in ran.stderr.lower(), ran.stderr
    assert ran.stdout


def commands(block):
    """The lines of a block that call kalos, as words."""
    lines = re.sub(r"\\\n", " ", block.text).splitlines()
    return [words[1:] for words in (shlex.split(line, comments=True) for line in lines) if words and words[0].endswith("kalos")]


@pytest.mark.parametrize("block", [block for block in SHELL if not block.reason], ids=lambda block: name(block.page))
def test_shell(block, place):
    """The commands run on the scenes that they name; a file that a page tells to save is its JSON block."""
    for found in blocks("json"):
        if found.page == block.page:
            (place / "office.json").write_text(found.text)
    for words in commands(block):
        quick = words + ["--trajectories", "640"] * (words[0] == "solve" and "data/cornell/cornell.json" in words)
        if words[0] in ("solve", "schema"):
            ran = subprocess.run([os.environ["KALOS"], *quick], cwd=place, capture_output=True, text=True, check=False)
            assert ran.returncode == 0, ran.stderr


@pytest.mark.parametrize("block", SHELL, ids=lambda block: name(block.page))
def test_options_exist(block):
    for words in commands(block):
        parser().parse_args(words)


def test_commands_of_the_tables_exist():
    """Also inside of sentences and tables: `kalos COMMAND` and programs of the tree."""
    for page in PAGES:
        for words in re.findall(r"`(?:build/bin/)?kalos ([a-z]+)[ `]", page.read_text(encoding="utf-8")):
            assert words in COMMANDS | {"needs"}, (name(page), words)  # "kalos needs Python": a message
        for path in re.findall(r"`[^`]*?((?:tests|examples|data|apps)/[\w/.-]+\w)[^`]*`", page.read_text(encoding="utf-8")):
            assert (ROOT / path).exists(), (name(page), path)


@pytest.mark.parametrize("block", blocks("json"), ids=lambda block: name(block.page))
def test_scenes(block, place):
    """Every scene of the manual fits the schema, and the reader takes it."""
    jsonschema = pytest.importorskip("jsonschema", reason="no jsonschema")
    document = json.loads(block.text)
    jsonschema.Draft202012Validator(json.loads(schema("scene"))).validate(document)
    (place / "scene.json").write_text(block.text)
    reader = kalos.vtkKalosSceneReader()
    reader.SetFileName(str(place / "scene.json"))
    reader.Update()
    assert reader.GetErrorCode() == 0


def test_examples_of_the_reference_fit_the_schema():
    jsonschema = pytest.importorskip("jsonschema", reason="no jsonschema")
    whole = json.loads(schema("scene"))
    for title, keys in json.loads((DOCS / "reference" / "scene-examples.json").read_text(encoding="utf-8")).items():
        own = whole if title == "scene" else whole["$defs"].get(title, {"properties": {}})
        for key, value in ((key, value) for key, value in keys.items() if key in own["properties"]):
            jsonschema.Draft202012Validator({"$defs": whole["$defs"], **own["properties"][key]}).validate(value)


def test_messages_of_the_troubleshooting_exist():
    """Each message that the page explains stands in the sources."""
    sources = "\n".join(path.read_text(encoding="utf-8") for folder in ("modules", "python") for path in (ROOT / folder).rglob("*")
                        if path.suffix in (".cxx", ".h", ".py"))
    text = (DOCS / "guides" / "troubleshooting.md").read_text(encoding="utf-8")
    told = [message for line in text.splitlines() if line.startswith("| `") for message in re.findall(r"`([^`]+)`", line.split("|")[1])]
    assert len(told) > 10
    missing = [message for message in told if message not in sources]
    assert not missing


def test_readme():
    text = README.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 90
    for path in re.findall(r"\]\(([^)#]+)\)", text):
        assert "://" in path or (ROOT / path).exists(), path
    example, = (block.text for block in blocks("python") if block.page == README)
    assert len(example.splitlines()) <= 10
    ran = subprocess.run([sys.executable, "-c", example], cwd=ROOT, capture_output=True, text=True, check=False)
    assert re.fullmatch(r"\d+ lx ± \d+\.\d\n", ran.stdout), ran.stderr
    for command in ("apps/demo", "tests/run", "build/bin/kalos solve"):
        assert command in text


def test_numbers_of_the_readme():
    """They are those that the zoo lists and that `kalos validate --figures` printed last."""
    text, figures = README.read_text(encoding="utf-8"), (DOCS / "validation" / "figures.txt").read_text(encoding="utf-8")
    held = [float(number) for found in re.findall(r"hold the truth in ([\d.]+) to ([\d.]+) % of the seeds", figures) for number in found]
    said = [float(number) for number in re.search(r"hold the truth in ([\d.]+) to ([\d.]+) % of 200 seeds", text).groups()]
    assert len(held) >= 6 and said == [min(held), max(held)]
    sys.path.insert(0, str(ROOT / "tests" / "zoo"))
    from catalogue import ROOMS

    hard = [line for line in (ROOT / "tests" / "zoo" / "hard.txt").read_text().splitlines() if line and not line.startswith("#")]
    most = int(re.search(rf"at most (\d+) of {len(ROOMS)} hard rooms", text)[1])
    assert len(hard) <= most < len(hard) + 10
