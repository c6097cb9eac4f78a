# SPDX-License-Identifier: BSD-3-Clause
"""docs/make builds the manual: warnings are errors, links inside of it lead somewhere, sources that it quotes are there."""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from pages import DOCS, PAGES, ROOT, name

pytest.importorskip("sphinx", reason="no Sphinx")
pytest.importorskip("myst_parser", reason="no MyST")
pytest.importorskip("breathe", reason="no Breathe")
sys.path.insert(0, str(DOCS / "extensions"))
from kalos_manual import scene  # noqa: E402
from kalos_manual.links import broken_links  # noqa: E402
from kalos_manual.measured import PICTURES  # noqa: E402
from kalos_manual.sources import line_of  # noqa: E402

BUILD = Path(os.environ["KALOS_BUILD"])


def test_site():
    made = subprocess.run([sys.executable, DOCS / "make", "--build", BUILD], capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stdout + made.stderr
    site = BUILD / "docs" / "site"
    text = {path.name: path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert "kalos solve" in text["command.html"] and "rotation_z_deg" in text["scene.html"]
    assert "IlluminanceStandardError" in text["outputs.html"] and "KalosLuminanceImage" in text["paraview.html"]
    assert "SetRelativeError" in text["vtk.html"] and "kalos.illuminance" in text["python.html"]
    assert 'id="L-' in text["PairKernel.cxx.html"]
    assert not [page for page, words in text.items() if re.search(r'(src|href)="(https?:)?//[^"]*(js|css|woff2?)"', words)], "needs a network"


def test_a_quoted_line_must_be_there():
    path = "modules/Kernels/estimator/kernel/Clamped.h"
    assert line_of(path, "std::min(plain, this->Limit)") > 10
    with pytest.raises(ValueError, match="0 lines hold 'no such words'"):
        line_of(path, "no such words")
    with pytest.raises(ValueError, match="lines hold 'Delta'; expected one"):
        line_of(path, "Delta")


def test_a_key_needs_an_example():
    with pytest.raises(ValueError, match="'quad' lacks an example of 'u'"):
        scene.table("quad", {"properties": {"u": {"type": "number"}}}, {}, {})


def test_links(tmp_path):
    (tmp_path / "a.html").write_text('<a href="b.html#here">1</a> <a href="b.html#there">2</a> <a href="c.html">3</a> <a href="https://x.org">4</a>')
    (tmp_path / "b.html").write_text('<p id="here">5</p>')
    assert broken_links(tmp_path) == ["a.html: b.html#there", "a.html: c.html"]


def test_every_page_is_short_and_told_about():
    """Every method has a page of theory, every page stands in the contents."""
    from kalos.core.options import METHODS

    index = (DOCS / "index.md").read_text(encoding="utf-8")
    for page in DOCS.rglob("*.md"):
        inside = str(page.relative_to(DOCS).with_suffix(""))
        assert inside == "index" or re.search(rf"^{inside}$", index, re.MULTILINE), name(page)
    theory, guide = ("".join(path.read_text(encoding="utf-8") for path in DOCS.rglob(pattern)) for pattern in ("theory/*.md", "guides/methods.md"))
    for method in METHODS:
        assert f"`{method}`" in theory and f"`{method}`" in guide, method
    assert PAGES[0] == ROOT / "README.md"


def test_figures_are_of_this_version():
    version = re.search(r"^project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
    head, *lines = (DOCS / "validation" / "figures.txt").read_text(encoding="utf-8").splitlines()
    assert re.fullmatch(rf"kalos {re.escape(version)}, \d{{4}}-\d\d-\d\d: kalos validate --figures", head), "docs/make --figures"
    assert len(lines) > 100 and not [line for line in lines if "fail" in line.split()[-1:]]


def test_pictures_have_commands():
    """Each picture has the command that makes it, whose example is there; screenshots are made by tests of Edge Studio."""
    kept = {path.name for path in (DOCS / "pictures").glob("*.png")}
    assert kept == set(PICTURES) | {"edge-studio.png", "edge-lens.png", "photometry.png"}
    for command, _ in PICTURES.values():
        for path in re.findall(r"(?:examples|data|tests)/\S+", command):
            assert (ROOT / path).exists(), path
