# SPDX-License-Identifier: BSD-3-Clause
"""`kalos solve --report`: one page that needs nothing else, and isolux lines that lie where the values are."""
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from kalos.pictures.isolux import isolux, levels, polylines
from kalos.pictures.plan import relative_error
from kalos.results.receivers import Receivers, point_receivers

PANEL = Path(__file__).resolve().parents[2] / "data" / "photometry" / "panel.ies"


@pytest.fixture
def report(scene, command, tmp_path):
    shutil.copy(PANEL, tmp_path / "panel.ies")
    scene["luminaires"].append({"name": "panel & co", "position": [1, 1.5, 2], "aim": [0, 0, -1], "file": "panel.ies"})
    scene["receivers"].append({"name": "strip", "plane": {"origin": [0, 0.4, 0.7], "u": [2, 0, 0], "v": [0, 0.2, 0],
                                                           "resolution": [10, 2]}})
    status, _, error = command("solve", scene.save(), "--out", tmp_path / "out", "--trajectories", 640, "--report")
    assert status == 0, error
    return tmp_path / "out"


def test_the_page_stands_alone(report):
    page = (report / "report.html").read_text(encoding="utf-8")
    sources = re.findall(r"(?:src|href)='([^']{0,30})", page)
    assert len(sources) == 6 and all(s.startswith("data:image/png;base64,") for s in sources)  # 4 sets, 1 camera, 1 file
    assert "http" not in re.sub(r"base64,[^']*", "", page) and "<script" not in page
    figures = json.loads((report / "summary.json").read_text())["receivers"]["desk"]
    row = re.search(r"<tr><td class=''>desk</td>(.*?)</tr>", page)[1]
    cells = re.findall(r">([^<]*)</td>", row)
    assert cells[0] == "8" and float(cells[1].split(" ± ")[0]) == pytest.approx(figures["mean"], rel=1e-3)
    assert float(cells[1].split(" ± ")[1]) > 0 and float(cells[4].split(" ± ")[0]) == pytest.approx(figures["U0"], rel=1e-3)
    assert "<td class=''>panel &amp; co</td><td class=''>panel.ies</td>" in page
    for text in ("What was modelled, and why", "shadow rays", "desk", "wall", "probe", "front", "panel.ies"):
        assert text in page


def test_isolux_files(report):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(report / "desk-isolux.vtp"))
    reader.Update()
    lines = reader.GetOutput()
    found = polylines(lines)
    assert found and {label for _, label, _ in found} == {f"{level:g} lx" for level, *_ in found}
    assert vtk_to_numpy(lines.GetPointData().GetArray("IlluminanceStandardError")).min() > 0
    assert not (report / "probe-isolux.vtp").exists()


def test_what_rounding_leaves_in_the_dark_has_no_error():
    found = relative_error(np.array([100, 2e-6, 1e-12, 0.0]), np.array([1, 1e-6, 1e-12, 0.0]))
    np.testing.assert_allclose(found, [1, 50, 0, 0])


def test_isolux_of_a_plane_that_rises():
    """E = 100 x + 7 is linear: the lines of Delaunay's mesh are exact, at x = (level - 7) / 100."""
    x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 9, 10), np.linspace(0, 4, 5)))
    points, up = np.column_stack([x, y, np.full(50, 0.8)]), np.tile([0.0, 0, 1], (50, 1))
    values = 100 * x + 7
    one = Receivers("desk", point_receivers(points, up), points, up, values, 0.1 * values, values, values > 0, np.ones(50, bool), np.ones(50))
    found = polylines(isolux(one))
    assert [level for level, *_ in found] == levels(values) == [100, 200, 300, 400, 500, 600, 700, 800, 900]
    for level, label, line in found:
        np.testing.assert_allclose(line[:, 0], (level - 7) / 100, atol=1e-5)
        np.testing.assert_allclose(line[:, 2], 0.8, atol=1e-6)
        assert np.ptp(line[:, 1]) == pytest.approx(4) and label == f"{level:g} lx"
    assert isolux(one, at=[450.0]).GetNumberOfLines() == 1
    dark = Receivers("desk", point_receivers(points, up), points, up, 0 * x, 0 * x, 0 * x, x >= 0, np.ones(50, bool), np.ones(50))
    assert polylines(isolux(dark)) == []
    tilted = up.copy()
    tilted[0] = (1, 0, 0)
    assert isolux(Receivers("desk", None, points, tilted, values, values, values, values > 0, np.ones(50, bool), np.ones(50))) is None


def test_in_a_browser(report, tmp_path):
    """A real browser shows the page and prints it."""
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not browser:
        pytest.skip("no Chromium, so the page is not looked at in a browser; apt-get install chromium")
    base = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={tmp_path / 'profile'}"]
    for option in (f"--screenshot={tmp_path / 'page.png'}", f"--print-to-pdf={tmp_path / 'page.pdf'}"):
        subprocess.run([*base, "--window-size=1000,3600", option, (report / "report.html").as_uri()], check=True,
                       capture_output=True, timeout=120, env={**os.environ, "HOME": str(tmp_path)})
    page = imread(tmp_path / "page.png")[..., :3]
    assert page.shape[:2] == (3600, 1000)
    inked = (page < 0.9).any(axis=2)
    assert inked[:120].any() and inked[3000:].any()  # from the title to the end of the page
    assert (page.std(axis=2) > 0.15).mean() > 0.03  # the pictures' colours
    assert inked[:, :10].sum() == inked[:, -10:].sum() == 0  # nothing runs over the sides
    printed = (tmp_path / "page.pdf").read_bytes()
    assert printed.startswith(b"%PDF") and len(re.findall(rb"/Type\s*/Page\b", printed)) >= 3
