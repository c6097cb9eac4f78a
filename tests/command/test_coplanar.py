# SPDX-License-Identifier: BSD-3-Clause
"""Faces of two materials in one place: the same light by every method, in every format, prepared or not; each is told."""
import base64
import csv
import json

import numpy as np
import pytest

CARPET = [("floor", 0.5, [0, 0, 0], [4, 0, 0], [0, 4, 0]), ("carpet", 0.9, [1, 1, 0], [2, 0, 0], [0, 2, 0])]
WALLS = [("A", 0.9, [0, -5, -5], [0, 10, 0], [0, 0, 10]), ("B", 0, [0, -5, -5], [0, 0, 10], [0, 10, 0])]
LAMP = {"name": "lamp", "position": [2, 2, 2], "aim": [0, 0, -1], "flux": 1000, "distribution": "lambertian"}
BULBS = [{"name": name, "position": [x, 0, 0], "flux": 1000, "distribution": "isotropic"} for name, x in (("r", 2), ("l", -2))]


def reflected(quads, point, normal, lamps, steps=400):
    """lx at a point from planes lit by lamps, of which the later hides the earlier: the midpoint rule."""
    total = 0
    t = (np.arange(steps) + 0.5) / steps
    for k, (_, reflectance, origin, u, v) in enumerate(quads):
        origin, u, v = (np.array(x, float) for x in (origin, u, v))
        n = np.cross(u, v)
        area = np.linalg.norm(n)
        n /= area
        y = (origin + t[:, None, None] * u + t[None, :, None] * v).reshape(-1, 3)
        hidden = np.zeros(len(y), bool)
        for _, _, o, a, b in quads[k + 1:]:
            if np.dot(np.cross(a, b), n) > 0:
                hidden |= (((y - o) @ a > 0) & ((y - o) @ a < np.dot(a, a)) & ((y - o) @ b > 0) & ((y - o) @ b < np.dot(b, b)))
        for lamp in lamps:
            way, out = y - lamp["position"], point - y
            d, e = np.linalg.norm(way, axis=1), np.linalg.norm(out, axis=1)
            candela = lamp["flux"] / (4 * np.pi) if lamp["distribution"] == "isotropic" else (
                lamp["flux"] / np.pi * np.maximum(0, way @ lamp["aim"]) / d)
            lux = candela * np.maximum(0, -way @ n) / d**3
            g = np.maximum(0, out @ n) * np.maximum(0, -out @ normal) / e**4
            total += (reflectance / np.pi * lux * g * ~hidden).sum() * area / steps**2
    return total


def written(kind, quads, folder):
    """The surfaces of a scene file, with what they name written into a folder."""
    if kind == "quads":
        return [{"name": name, "material": name, "quad": {"origin": o, "u": u, "v": v}} for name, _, o, u, v in quads]
    corners = [np.array([o, np.add(o, u), np.add(np.add(o, u), v), np.add(o, v)], float) for _, _, o, u, v in quads]
    if kind == "obj":
        lines = [f"v {x} {y} {z}" for c in corners for x, y, z in c]
        for i, (name, *_) in enumerate(quads):
            lines += [f"usemtl {name}", f"f {4 * i + 1} {4 * i + 2} {4 * i + 3} {4 * i + 4}"]
        (folder / "model.obj").write_text("\n".join(lines) + "\n")
        return [{"name": "model", "file": "model.obj"}]
    if kind == "stl":
        for (name, *_), c in zip(quads, corners):
            facets = ["\n".join(["facet normal 0 0 0", "outer loop", *("vertex %r %r %r" % tuple(c[k]) for k in three), "endloop",
                                 "endfacet"]) for three in ((0, 1, 2), (0, 2, 3))]
            (folder / f"{name}.stl").write_text("\n".join([f"solid {name}", *facets, f"endsolid {name}", ""]))
        return [{"name": name, "file": f"{name}.stl", "material": name} for name, *_ in quads]
    indices = np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    data = indices + b"".join((c[:, [0, 2, 1]] * [1, 1, -1]).astype("<f4").tobytes() for c in corners)  # y up
    count = len(quads)
    model = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(count))}],
        "nodes": [{"mesh": i, "name": quads[i][0]} for i in range(count)],
        "meshes": [{"name": quads[i][0], "primitives": [{"attributes": {"POSITION": i + 1}, "indices": 0, "material": i}]}
                   for i in range(count)],
        "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorFactor": [r, r, r, 1], "metallicFactor": 0}} for name, r, *_ in quads],
        "accessors": [{"bufferView": 0, "componentType": 5123, "count": 6, "type": "SCALAR"}] + [
            {"bufferView": i + 1, "componentType": 5126, "count": 4, "type": "VEC3"} for i in range(count)],
        "bufferViews": [{"buffer": 0, "byteLength": 12}] + [{"buffer": 0, "byteOffset": 12 + 48 * i, "byteLength": 48} for i in range(count)],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    (folder / "model.gltf").write_text(json.dumps(model))
    return [{"name": "model", "file": "model.gltf"}]


def solved(command, folder, surfaces, quads, lamps, points, *options):
    """Values and their errors at the points, and the summary."""
    rows = "".join(",".join(map(str, row)) + "\n" for row in points)
    (folder / "points.csv").write_text("x,y,z,nx,ny,nz\n" + rows)
    scene = {"kalos": 1, "materials": {name: {"reflectance": r} for name, r, *_ in quads}, "surfaces": surfaces,
             "luminaires": lamps, "receivers": [{"name": "p", "points": "points.csv"}]}
    (folder / "scene.json").write_text(json.dumps(scene))
    status, _, error = command("solve", folder / "scene.json", "--out", folder / "out", "--trajectories", 65536, *options)
    assert status == 0, error
    table = list(csv.DictReader((folder / "out" / "p.csv").open()))
    values, errors, direct = (np.array([float(row[name]) for row in table])
                              for name in ("illuminance_lx", "standard_error_lx", "direct_lx"))
    return values - direct, errors, json.loads((folder / "out" / "summary.json").read_text()), error


def expect(values, errors, truth):
    """5.5 standard errors of 7 or more degrees of freedom: a false alarm in a thousand."""
    assert (np.abs(values - truth) < 5.5 * errors + 1e-3 * truth + 1e-9).all(), (values, errors, truth)
    assert (errors < 0.02 * truth + 1e-9).all()


@pytest.mark.parametrize("method", ["compensated", "gathered", "local"])
@pytest.mark.parametrize("kind", ["quads", "obj", "stl", "gltf"])
def test_the_later_carpet_lies_on_top(command, tmp_path, kind, method):
    points = [(2, 2, 1, 0, 0, -1)]
    for quads in (CARPET, CARPET[::-1]):
        truth = reflected(quads, np.array(points[0][:3]), np.array(points[0][3:]), [LAMP])
        values, errors, summary, _ = solved(command, tmp_path, written(kind, quads, tmp_path), quads, [LAMP], points, "--method", method)
        expect(values, errors, np.array([truth]))
        assert summary["warnings"]["count"] == 1


def test_the_carpet_is_that_of_the_closed_form():
    assert reflected(CARPET, np.array([2, 2, 1]), np.array([0, 0, -1]), [LAMP]) == pytest.approx(36.88, abs=0.05)


@pytest.mark.parametrize("options", [(), ("--no-prepare",)])
def test_walls_back_to_back_keep_their_sides(command, tmp_path, options):
    points = [(1, 0, 0, -1, 0, 0), (-1, 0, 0, 1, 0, 0)]
    for quads in (WALLS, WALLS[::-1]):
        for method in ("compensated", "gathered", "local"):
            values, errors, summary, error = solved(command, tmp_path, written("quads", quads, tmp_path), quads, BULBS, points,
                                                    "--method", method, *options)
            truth = reflected([WALLS[0]], np.array([1, 0, 0]), np.array([-1, 0, 0]), BULBS[:1])
            assert truth == pytest.approx(11.44, abs=0.02)
            expect(values, errors, np.array([truth, 0]))
            assert "lie back to back over 100 m2" in summary["warnings"]["list"][0]["message"]
            assert "kalos: warning: " in error and "reflectance 0.9" in error


def test_a_carpet_from_wall_to_wall_survives_repair(command, tmp_path):
    """On the floor's own corners, with the floor doubled, so that the repaired surfaces are solved."""
    quads = [CARPET[0], ("carpet", 0.9, *CARPET[0][2:])]
    surfaces = written("obj", quads, tmp_path)
    (tmp_path / "model.obj").write_text((tmp_path / "model.obj").read_text().replace("f 1 2 3 4", "f 1 2 3 4\nf 1 2 3 4"))
    truth = reflected(quads[1:], np.array([2, 2, 1]), np.array([0, 0, -1]), [LAMP])
    for options in ((), ("--no-prepare",)):
        values, errors, summary, _ = solved(command, tmp_path, surfaces, quads, [LAMP], [(2, 2, 1, 0, 0, -1)], *options)
        expect(values, errors, np.array([truth]))
        subjects = {line["subject"]: line["choice"] for line in summary["audit"]}
        assert options or "duplicate triangles dropped" in subjects["repair"]
