# SPDX-License-Identifier: BSD-3-Clause
"""The same lamp as a point, a rectangle, an IES and a EULUMDAT file gives the same lux, and the audit says how."""
import json

import numpy as np
import pytest
from files import write_ies, write_ldt
from scipy import stats

from kalos.core.options import Options
from kalos.solving.solve import solve
from kalos.validation.verdicts import REPLICATES

FLUX = 100.0
ANGLES = tuple(np.arange(0, 90.01, 0.5))


def cosine(plane, angle):
    return FLUX / np.pi * max(0.0, np.cos(np.radians(angle))) if angle < 90 else 0.0


def room(luminaire):
    wall = {"white": {"reflectance": 0.5}}
    quads = {"floor": ([0, 0, 0], [4, 0, 0], [0, 4, 0]), "ceiling": ([0, 0, 3], [0, 4, 0], [4, 0, 0]),
             "left": ([0, 0, 0], [0, 4, 0], [0, 0, 3]), "front": ([0, 0, 0], [0, 0, 3], [4, 0, 0]),
             "right": ([4, 0, 0], [0, 0, 3], [0, 4, 0]), "back": ([0, 4, 0], [4, 0, 0], [0, 0, 3])}
    return {"kalos": 1, "materials": wall,
            "surfaces": [{"name": n, "quad": dict(zip(("origin", "u", "v"), q)), "material": "white"} for n, q in quads.items()]
            + [{"name": "box", "box": {"center": [1, 1, 0.5], "size": [0.6, 0.6, 1]}, "material": "white"}],
            "luminaires": [{"name": "lamp", "aim": [0, 0, -1], **luminaire}],
            "receivers": [{"name": "desk", "plane": {"origin": [0, 0, 0.75], "u": [4, 0, 0], "v": [0, 4, 0], "resolution": [3, 3]}},
                          {"name": "near", "points": "near.csv"}]}


def results(folder, name, luminaire):
    path = folder / f"{name}.json"
    path.write_text(json.dumps(room(luminaire)))
    (folder / "near.csv").write_text("x,y,z,nx,ny,nz\n2,2,2.9,0,0,1\n2.1,1.7,2.6,0,0,1\n2.5,2.5,2.8,-1,0,0\n")
    summary = solve(path, folder / name, Options(trajectories=12800))
    tables = {s: np.genfromtxt(folder / name / f"{s}.csv", delimiter=",", names=True) for s in ("desk", "near")}
    return tables, {line["subject"]: line["choice"] for line in summary["audit"]}


@pytest.fixture(scope="module")
def forms(tmp_path_factory):
    folder = tmp_path_factory.mktemp("contract")
    place, size = {"position": [2, 2, 2.999]}, 0.3
    write_ies(folder / "point.ies", cosine, angles=ANGLES)
    write_ies(folder / "area.ies", cosine, angles=ANGLES, opening=(size, size, 0))
    write_ldt(folder / "point.ldt", cosine, angles=ANGLES, symmetry=1)
    write_ldt(folder / "area.ldt", cosine, angles=ANGLES, size=(1000 * size, 1000 * size), symmetry=1)
    side = {"rectangle": {"center": [2, 2, 2.999], "u": [size, 0, 0], "v": [0, size, 0]}, "flux": FLUX}
    small = {"rectangle": {"center": [2, 2, 2.999], "u": [0.01, 0, 0], "v": [0, 0.01, 0]}, "flux": FLUX}
    return {"point": results(folder, "p", {**place, "flux": FLUX, "distribution": "lambertian"}),
            "small": results(folder, "s", small), "large": results(folder, "l", side),
            "point.ies": results(folder, "pi", {**place, "file": "point.ies"}),
            "point.ldt": results(folder, "pl", {**place, "file": "point.ldt"}),
            "area.ies": results(folder, "ai", {**place, "file": "area.ies"}),
            "area.ldt": results(folder, "al", {**place, "file": "area.ldt"})}


def agree(a, b, shared):
    """Within the standard errors, at a false alarm of 1e-3 over all receivers of a test (Sidak), and of those 2 %."""
    quantile = stats.t.isf((1 - (1 - 1e-3) ** (1 / 60)) / 2, REPLICATES - 1)
    error = np.hypot(a["standard_error_lx"], b["standard_error_lx"])
    assert (np.abs(a["illuminance_lx"] - b["illuminance_lx"]) <= quantile * error + shared * b["illuminance_lx"]).all()
    assert (error < 0.05 * b["illuminance_lx"]).all()


@pytest.mark.parametrize("form", ["small", "point.ies", "point.ldt"])
def test_points(forms, form):
    # Half-degree chords of the cosine lie 1e-5 low; a centimetre at a decimetre loses (0.01/0.1)^2 / 3.
    agree(forms[form][0]["desk"], forms["point"][0]["desk"], 1e-4)
    agree(forms[form][0]["near"], forms["point"][0]["near"], 4e-3)


@pytest.mark.parametrize("form", ["area.ies", "area.ldt"])
def test_openings(forms, form):
    # Beyond 5 sizes a point stands for the area: 2 m below 0.3 m, (0.3/2)^2 / 3 of the direct light at most.
    agree(forms[form][0]["desk"], forms["large"][0]["desk"], 0.0075)
    agree(forms[form][0]["near"], forms["large"][0]["near"], 1e-4)
    assert forms[form][1]["luminous openings"] == "1 as areas to 3 of 12 receivers, else points"


def test_audit(forms):
    assert forms["point.ies"][1]["point luminaires"] == "1, exact"
    assert forms["large"][1]["luminous rectangles"] == "1, polygon formula"


def test_warnings_are_counted(tmp_path, capfd):
    write_ies(tmp_path / "a.ies", cosine, angles=ANGLES, lumens=10)
    path = tmp_path / "scene.json"
    (tmp_path / "near.csv").write_text("x,y,z,nx,ny,nz\n2,2,2,0,0,1\n")
    description = room({"position": [2, 2, 2.9], "file": "a.ies"})
    description["luminaires"].append({**description["luminaires"][0], "name": "other"})
    path.write_text(json.dumps(description))
    summary = solve(path, tmp_path / "out", Options(trajectories=320))
    assert summary["warnings"]["count"] == 1 and summary["warnings"]["codes"] == {"ies-flux": 1}
    assert summary["warnings"] == json.loads((tmp_path / "out" / "summary.json").read_text())["warnings"]
    warning = f"{tmp_path}/a.ies: line 8: lumens per lamp: the intensities make 100 lm, more than the lamps' 10 [ies-flux]"
    assert capfd.readouterr().err.endswith(f"kalos: warning: {warning}\n")
