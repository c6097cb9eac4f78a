# SPDX-License-Identifier: BSD-3-Clause
"""cmake --install, then the prefix moved elsewhere: the command, the package, the plugin and find_package() work there."""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["KALOS_BUILD"])
VERSION, = re.findall(r"^project\(Kalos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
WITHOUT_QT = not (BUILD / "bin" / "edge-studio").is_file()
SCENE = ROOT / "data" / "cornell" / "cornell-empty.json"


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("install")
    subprocess.run(["cmake", "--install", BUILD, "--prefix", folder / "first"], check=True, capture_output=True)
    return shutil.move(folder / "first", folder / "prefix")


def run(*arguments, **environment):
    """Output of a program that knows nothing of the build tree."""
    clean = {key: value for key, value in os.environ.items() if key != "KALOS"}
    found = [place for place in os.environ.get("PYTHONPATH", "").split(os.pathsep) if place and not place.startswith(str(BUILD))]
    environment["PYTHONPATH"] = os.pathsep.join([*environment.get("PYTHONPATH", "").split(), *found])  # of a VTK that is not the system's
    return subprocess.run([*map(str, arguments)], env={**clean, **environment}, text=True, capture_output=True, cwd="/",
                          check=False)


def test_nothing_points_into_the_build_tree(prefix):
    names = subprocess.run(["grep", "-rl", "--include=*.py", "--include=*.cmake", "--include=kalos", str(BUILD), prefix],
                           text=True, capture_output=True, check=False).stdout
    assert names == ""
    for library in prefix.rglob("*.so"):
        dynamic = subprocess.run(["readelf", "-d", library], text=True, capture_output=True, check=True).stdout
        assert str(BUILD) not in dynamic and "$ORIGIN" in dynamic, library
        linked = subprocess.run(["ldd", library], text=True, capture_output=True, check=True).stdout
        assert "not found" not in linked, library


def test_command_on_the_path(prefix, tmp_path):
    path = f"{prefix}/bin:{os.environ['PATH']}"
    assert run("kalos", "--version", PATH=path).stdout == f"kalos {VERSION}\n"
    solved = run("kalos", "solve", SCENE, "--out", tmp_path / "out", "--trajectories", 64, PATH=path)
    assert solved.returncode == 0, solved.stderr
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["receivers"]


def test_every_program_runs(prefix):
    """From a prefix that was moved, and without the libraries of the build."""
    programs = sorted(path.name for path in (Path(prefix) / "bin").iterdir())
    assert "kalos" in programs and (WITHOUT_QT or "edge-studio" in programs)
    for program in programs:
        path = f"{prefix}/bin:{os.environ['PATH']}"
        told = run(program, "--version", PATH=path)
        assert told.returncode == 0 and VERSION in told.stdout, (program, told.stderr)
        assert run(program, "--help", PATH=path).returncode == 0
        assert "not found" not in run("ldd", prefix / "bin" / program).stdout


@pytest.mark.skipif(WITHOUT_QT, reason="built without Edge Studio")
def test_edge_studio_opens(prefix):
    """Its window stays until it is told to go."""
    opened = run(ROOT / "tests" / "with_screen", "timeout", "4", prefix / "bin" / "edge-studio", SCENE)
    assert opened.returncode == 124, opened.stderr


def test_desktop(prefix):
    share = prefix / "share"
    if WITHOUT_QT:
        pytest.skip("built without Edge Studio")
    assert (share / "icons" / "hicolor" / "scalable" / "apps" / "kalos.svg").is_file()
    assert "*.kalos.json" in (share / "mime" / "packages" / "kalos.xml").read_text()
    entry = share / "applications" / "kalos-edge-studio.desktop"
    if shutil.which("desktop-file-validate"):
        checked = run("desktop-file-validate", entry)
        assert checked.stdout + checked.stderr == ""
    if shutil.which("help2man"):
        assert "edge" in (share / "man" / "man1" / "edge-studio.1").read_text().lower()


def test_libraries_have_a_version(prefix):
    """Two versions can be installed beside each other."""
    library = next(prefix.rglob("libvtkKalosFiltersEstimation.so"))
    soname = re.search(r"SONAME.*\[(\S+)\]", run("readelf", "-d", library).stdout)[1]
    assert soname == "libvtkKalosFiltersEstimation.so." + ".".join(VERSION.split(".")[:2]) and library.with_name(soname).exists()


@pytest.mark.parametrize("component, found", [("CommonPhotometry FiltersEstimation", True), ("Illumination", False)])
def test_components(prefix, tmp_path, component, found):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.22)\nproject(Components LANGUAGES C CXX)\n"
        f"find_package(Kalos REQUIRED COMPONENTS {component})\nmessage(STATUS \"has ${{Kalos_LIBRARIES}}\")\n")
    made = run("cmake", "-G", "Ninja", "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    assert (made.returncode == 0) == found
    if found:
        assert "has Kalos::CommonPhotometry;Kalos::FiltersEstimation\n" in made.stdout
    else:
        words = " ".join(made.stderr.split())
        assert "there is no component Illumination; expected some of" in words and "FiltersEstimation" in words


def test_command_through_a_link(prefix, tmp_path):
    (tmp_path / "kalos").symlink_to(prefix / "bin" / "kalos")
    assert run(tmp_path / "kalos", "--version").stdout == f"kalos {VERSION}\n"


def test_package_by_pythonpath(prefix):
    package = prefix / "lib" / "python3" / "dist-packages"
    program = ("import kalos; from kalos.validation.cases import DATA; print(kalos.__file__, kalos.vtkKalosIlluminance().GetClassName(), "
               "DATA)")
    found = run(sys.executable, "-c", program, PYTHONPATH=str(package))
    assert found.stdout == f"{package}/kalos/__init__.py vtkKalosIlluminance {prefix}/share/kalos/data\n", found.stderr
    assert (prefix / "share" / "kalos" / "data" / "furnace" / "furnace.json").exists()


def test_documentation_is_installed(prefix):
    share = prefix / "share"
    assert (share / "bash-completion" / "completions" / "kalos").is_file() and (share / "zsh" / "vendor-completions" / "_kalos").is_file()
    assert (share / "kalos" / "examples" / "cpp" / "desk.cxx").is_file()
    assert (share / "doc" / "Kalos" / "CHANGELOG.md").is_file() and (share / "doc" / "Kalos" / "CITATION.cff").is_file()
    if shutil.which("argparse-manpage"):
        page = (share / "man" / "man1" / "kalos.1").read_text()
        assert ".SH OPTIONS 'kalos solve'" in page and "\\-\\-trajectories" in page


def test_an_installed_example_runs(prefix, tmp_path):
    ran = run(sys.executable, prefix / "share" / "kalos" / "examples" / "scene_changes.py", tmp_path,
              PYTHONPATH=str(prefix / "lib" / "python3" / "dist-packages"))
    assert ran.returncode == 0, ran.stderr
    assert (tmp_path / "light" / "task.csv").is_file() and "without a room: " in ran.stdout


@pytest.mark.skipif(os.environ["KALOS_WITH_PARAVIEW"] != "ON", reason="built without ParaView")
def test_plugin_by_pv_plugin_path(prefix):
    plugins, = prefix.glob("lib*/**/plugins")
    program = "import paraview.simple as pv; print(pv.KalosCalculationPlane().GetXMLName())"
    found = run("pvpython", "-c", program, PV_PLUGIN_PATH=str(plugins))
    assert found.stdout.splitlines()[-1:] == ["KalosCalculationPlane"], found.stdout + found.stderr


def test_example_project(prefix, tmp_path):
    build = tmp_path / "build"
    made = run("cmake", "-G", "Ninja", "-S", ROOT / "examples" / "cpp", "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}",
               "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    assert made.returncode == 0, made.stderr
    built = run("cmake", "--build", build)
    assert built.returncode == 0, built.stdout
    lines = run(build / "desk", SCENE).stdout.splitlines()
    assert len(lines) == 16 and all(re.fullmatch(r"\d+\.\d lx, standard error \d+\.\d", line) for line in lines)
    wrong = run(build / "desk", "/nowhere.json")
    assert wrong.returncode == 1 and "/nowhere.json" in wrong.stderr
