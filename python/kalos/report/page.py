# SPDX-License-Identifier: BSD-3-Clause
"""`kalos solve --report`: one self-contained HTML page to read, to print and to hand on."""
import io
import time
from html import escape
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy

from kalos.core import arrays
from kalos.core.output import write_vtp
from kalos.photometry import draw_photometry, facts, read_photometry
from kalos.pictures import drawing
from kalos.pictures.isolux import isolux
from kalos.pictures.plan import draw_plan
from kalos.pictures.projection import flat_frame
from kalos.report.grid import grid_section
from kalos.report.html import embedded, table
from kalos.report.surfaces import surface_section
from kalos.results.text import number, with_error
from kalos.scenes.reading import described, maintenance

KINDS = ("isotropic", "lambertian", "light of the model")  # by Distribution, for luminaires that no scene file describes

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #1d2429; max-width: 62rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.7rem; margin: 0; } h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; border-bottom: 2px solid #0b5d8f; }
h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; } p.facts { color: #566; margin: .2rem 0; }
table { border-collapse: collapse; width: 100%; margin: .5rem 0; font-size: .88rem; }
th, td { text-align: left; padding: .28rem .6rem .28rem 0; border-bottom: 1px solid #d5dbdf; vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; } img { max-width: 100%; display: block; margin: .5rem 0; }
.warning { color: #8a3b00; }
table.grid { font-size: .72rem; } table.grid td, table.grid th { padding: .1rem .25rem; }
@page { size: A4; margin: 15mm; }
@media print { body { margin: 0; padding: 0; max-width: none; font-size: 11px; } h2, h3 { break-after: avoid; }
  thead { display: table-header-group; } img, tr, .together { break-inside: avoid; } img { max-height: 230mm; } }
"""


def write_report(folder, scene, reader, receivers, images, result, look, author=None):
    """report.html, and NAME-isolux.vtp for every flat receiver set that has isolux lines."""
    by = f", by {escape(author)}" if author else ""
    body = [f"<h1>{escape(Path(scene).stem)}: lighting calculation</h1>",
            f"<p class='facts'>{time.strftime('%Y-%m-%d')}{by}</p>",
            f"<p class='facts'>Kalos {escape(result['kalos'])}, method {escape(result['method'])}, seed {result['seed']}, "
            f"{result['seconds']:.3g} s ({result['cpu_seconds']:.3g} s of processor time). Every value is an estimate; ± is one "
            "standard error, two of them hold the true value in about 95 of 100 cases.</p>"]
    body += receiver_sections(folder, [one for one in receivers if one.name not in result["observers"]], result, look)
    body += task_section(result)
    body += glare_section(result)
    body += camera_sections(images, look)
    body += luminaire_section(scene, reader, result)
    body += surface_section(reader)
    body += ["<h2>What was modelled, and why</h2>",
             table(("subject", "choice", "reason"), [(e["subject"], e["choice"], e["reason"]) for e in result["audit"]])]
    page = (f"<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>{escape(Path(scene).stem)}: lighting calculation"
            f"</title><style>{STYLE}</style></head><body>\n" + "\n".join(body) + "\n</body></html>\n")
    (folder / "report.html").write_text(page, encoding="utf-8")


def receiver_sections(folder, receivers, result, look):
    if not receivers:
        return []
    head = ("receivers", "points", "mean lx", "min lx", "max lx", "U0 = min/mean", "Ud = min/max", "largest error", "untrusted", "left out")
    rows = []
    for one in receivers:
        values = result["receivers"][one.name]
        worst = values["largest_relative_standard_error"]
        rows.append((one.name, len(one.illuminance), *(with_error(values, key) for key in ("mean", "min", "max", "U0", "Ud")),
                     "-" if worst is None else f"{100 * worst:.2g} %", values["untrusted"], values["left_out"]))
    sections = ["<h2>Illuminance</h2>", table(head, rows, numbers=range(1, 10))]
    if any(result["receivers"][one.name]["left_out"] for one in receivers):
        sections.append("<p class='facts'>Left out: points inside a solid, below a surface or outside, grey in the pictures.</p>")
    for one in receivers:
        sections.append(f"<div class='together'><h3>{escape(one.name)}</h3>{receiver_picture(folder, one, look)}</div>{grid_section(one)}")
    return sections


def receiver_picture(folder, one, look):
    lines = isolux(one) if one.cells else None
    file = io.BytesIO()
    if lines is None:
        drawing.draw_receivers(file, one, look)
        return embedded(file, f"illuminance of {one.name}")
    draw_plan(file, one, flat_frame(one.points, one.normals), lines, look)
    write_vtp(folder / f"{one.name}-isolux.vtp", lines)
    return embedded(file, f"plan of {one.name} with isolux lines")


def task_section(result):
    if not result["tasks"]:
        return []
    rows = []
    for task in result["tasks"]:
        figures = result["receivers"][task["receivers"]] | result["observers"].get(task["receivers"], {})
        rows.append((task["receivers"], *(cell for key in ("mean", "U0", "UGR") for cell in required(task, figures, key)), task["result"]))
    head = ("task", "mean required, lx", "mean, lx", "U0 required", "U0", "UGR at most", "UGR", "result")
    factors = [line["choice"] for line in result["audit"] if line["subject"] == "maintenance factor"]
    return ["<h2>Required values</h2>", table(head, rows, numbers=range(1, 7)),
            "<p class='facts'>As EN 12464-1 asks of task areas. A value within two standard errors of its limit is undecided. "
            f"Maintenance factor: {escape(factors[0]) if factors else 'none is applied, values are those of new luminaires'}.</p>"]


def required(task, figures, key):
    """A required value and the one found; - where nothing is required."""
    return (f"{task[f'required_{key}']:g}", with_error(figures, key)) if f"required_{key}" in task else ("-", "-")


def glare_section(result):
    if not result["observers"]:
        return []
    rows = [(name, *(with_error(figures, key) for key in ("UGR", "background_luminance")), figures["sources"],
             with_error(result["receivers"][name], "mean")) for name, figures in result["observers"].items()]
    head = ("observer", "UGR", "background cd/m²", "sources in sight", "illuminance at the eye, lx")
    return ["<h2>Discomfort glare</h2>", table(head, rows, numbers=range(1, 5)),
            "<p class='facts'>Unified glare rating of CIE 117; - where no source is seen.</p>"]


def camera_sections(images, look):
    if not images:
        return []
    sections = ["<h2>Luminance</h2>"]
    for name, image in images.items():
        file = io.BytesIO()
        drawing.draw_image(file, name, image, look)
        sections.append(f"<div class='together'><h3>{escape(name)}</h3>{embedded(file, f'luminance seen from {name}')}</div>")
    return sections


def luminaire_section(scene, reader, result):
    """One row a luminaire, and the curves of every photometric file."""
    luminaires = reader.GetLuminaires()
    if luminaires.GetNumberOfPoints() == 0:
        return []
    known, usual = described(scene, "luminaires"), maintenance(scene)
    data = luminaires.GetPointData()
    flux, kinds = (vtk_to_numpy(data.GetArray(name)) for name in (arrays.LUMINOUS_FLUX, arrays.DISTRIBUTION))
    names = data.GetAbstractArray(arrays.LUMINAIRE_NAMES)
    rows = []
    for i in range(luminaires.GetNumberOfPoints()):
        one = known.get(names.GetValue(i), {})
        kind = one.get("file") or ("rectangle" if "rectangle" in one else KINDS[min(int(kinds[i]), len(KINDS) - 1)])
        place = ", ".join(f"{x:.2f}" for x in luminaires.GetPoint(i))
        rows.append((names.GetValue(i), kind, place, f"{one.get('maintenance_factor', usual):g}", number(float(flux[i]))))
    head = ("luminaire", "distribution", "place, m", "maintenance factor", "maintained flux, lm")
    sections = ["<h2>Luminaires</h2>", table(head, rows, numbers=(3, 4)),
                f"<p class='facts'>{len(rows)} luminaires, {number(float(flux.sum()))} lm together.</p>"]
    for name, lamp_set in sorted({(one["file"], one.get("lamp_set", 1)) for one in known.values() if "file" in one}):
        photometry = read_photometry(Path(scene).parent / name, lamp_set)
        file = io.BytesIO()
        draw_photometry(file, photometry)
        picture = embedded(file, f"polar curves and photometric solid of {name}: {facts(photometry)}")
        sections.append(f"<div class='together'><h3>{escape(name)}</h3>{picture}</div>")
    sections += [f"<p class='warning'>{escape(Path(w['file']).name)}: {escape(w['message'])}</p>" for w in result["warnings"]["list"]]
    return sections
