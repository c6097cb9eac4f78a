# SPDX-License-Identifier: BSD-3-Clause
"""The Debian package: apt would install it, it needs ParaView and no -dev package, and what it holds works unpacked."""
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["KALOS_BUILD"])
VERSION, = re.findall(r"^project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("package")
    subprocess.run(["cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder], check=True, capture_output=True)
    found, = folder.glob("*.deb")
    return found


def output(*command, **options):
    return subprocess.run([*map(str, command)], text=True, capture_output=True, check=True, **options).stdout


def test_control(package):
    assert re.fullmatch(r"kalos_0\.1\.0_\w+\.deb", package.name)
    fields = dict(re.findall(r"^ (\S+): (.*)$", output("dpkg-deb", "-I", package), re.MULTILINE))
    needed = {entry.split()[0] for entry in fields["Depends"].split(", ")}
    assert {"paraview", "python3-paraview", "python3-numpy", "python3-matplotlib", "python3"} <= needed
    assert {name for name in needed if name.startswith("libembree")} and {name for name in needed if name.startswith("libtbb")}
    assert not [name for name in needed if name.endswith("-dev")]


def test_apt_accepts_it(package):
    planned = output("apt-get", "install", "-s", "--no-install-recommends", package)
    assert re.search(r"^Inst kalos \(0\.1\.0", planned, re.MULTILINE), planned


def test_contents_work(package, tmp_path):
    output("dpkg-deb", "-x", package, tmp_path)
    places = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*")}
    assert {"usr/bin/kalos", "usr/lib/python3/dist-packages/kalos/__init__.py", "usr/share/kalos/data/cornell/cornell.json",
            "usr/share/applications/kalos-edge-studio.desktop", "usr/share/mime/packages/kalos.xml", "usr/share/man/man1/kalos.1",
            "usr/share/icons/hicolor/scalable/apps/kalos.svg", "usr/share/kalos/examples/first_light.py"} <= places
    assert not [place for place in places if place.endswith((".a", ".pyc"))]
    clean = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "KALOS")}
    assert output(tmp_path / "usr" / "bin" / "kalos", "--version", env=clean, cwd="/") == f"kalos {VERSION}\n"
