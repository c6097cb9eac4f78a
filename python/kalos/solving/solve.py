# SPDX-License-Identifier: BSD-3-Clause
"""From a scene file to a folder of results: reads, estimates, writes."""
import os
import sys
import time
from collections import Counter
from pathlib import Path

from kalos._build import __version__
from kalos.core import arrays
from kalos.core.options import Options, named_options
from kalos.core.output import staged, write_json, write_vtp
from kalos.core.progress import run
from kalos.errors import KalosError, update
from kalos.estimation.filters import illuminance_filter, luminance_filter
from kalos.pictures import drawing
from kalos.pictures.look import LOOK
from kalos.preparation.scene import UNPREPARED, prepare_scene
from kalos.results import fields, text
from kalos.results.receivers import from_dataset
from kalos.results.daylight import daylight_figures
from kalos.results.statistics import goal, image_statistics
from kalos.results.tables import write_csv
from kalos.results.tasks import check_names, joined, judged, of_scene
from kalos.scenes.reading import MODELS, camera_names, described, photometry_warnings, read_scene, receiver_names
from kalos.solving.glare import rate_glare
from kalos.solving.hdr import write_hdr
from kalos.solving.memory import check_memory
from kalos.vtk import vtkKalosEXRWriter


def solve(scene, out, options=Options(), say=lambda line: None, preparing=True, report=False, hdr=False,
          everywhere=False, look=LOOK,
          tasks=(), author=None, daylight=False):
    """Solves the scene file, or the model (.glb, .gltf, .obj), into the folder `out` and returns what stands in summary.json.

    Every receiver set gives NAME.csv, NAME.vtp and NAME.png, every camera NAME.exr and NAME.png. `say` gets the audit,
    the result table and the paths of the pictures. With `preparing` the surfaces are repaired first, and the audit says
    where they meet at singular edges. `hdr` adds NAME.hdr per camera, a Radiance picture. `report` adds report.html, and NAME-isolux.vtp
    for flat receiver sets. `everywhere` lets statistics count receivers inside solids, below surfaces and outside, which are left out
    otherwise. `daylight` adds daylight factors. `look` is that of the pictures. `tasks` are requirements beside those of
    the scene, a kalos.results.tasks.Task each. Raises KalosError; the folder then holds nothing new.
    """
    started = time.perf_counter()
    look.check()
    reader, prepared = set_up(scene, preparing)
    check_names(tasks, receiver_names(reader))
    if daylight:
        check_sky(reader, scene)
    tasks = joined(of_scene(described(scene, "receivers")), tasks)
    setup = time.perf_counter() - started
    with staged(out) as folder:
        with named_options():
            receivers, images, outputs = estimate(reader, options, prepared)
        observers, glare = rate_glare(reader, receivers, prepared)
        result = summarise(scene, options, receivers, images, outputs, everywhere)
        if daylight:
            add_daylight(result, receivers, everywhere)
        result["observers"] = observers
        result["tasks"] = judged(tasks, result["receivers"], observers)
        result["audit"] = fields.audit(reader.GetSurfaces(), arrays.SCENE_NOTES) + prepared.audit + result["audit"] + glare
        result["setup_seconds"] = setup
        result["warnings"] = warnings(reader, scene, result["audit"])
        for one in result["warnings"]["list"]:
            print(f"kalos: warning: {one['file']}: {one['message']}", file=sys.stderr)
        say("audit")
        say(text.audit_text(result["audit"]))
        write(folder, receivers, images, result, look, daylight)
        if hdr:
            write_hdr(folder, reader, images)
        if report:
            from kalos.report.page import write_report  # its pictures take seconds to import and to draw

            write_report(folder, scene, reader, receivers, images, result, look, author)
        kept = [options.checkpoint, *(options.of_camera(name).checkpoint for name in images)] if options.checkpoint else []
        paths = [Path(out) / name for name in sorted(os.listdir(folder)) if name.endswith(".png")]
    for file in kept:  # the results are in place
        Path(file).unlink(missing_ok=True)
    say(f"result of {result['method']}, seed {result['seed']}")
    say(text.result_text(result))
    say(f"solved in {result['seconds']:.3g} s, {result['cpu_seconds']:.3g} s of processor time; set-up {setup:.2g} s")
    say("pictures")
    for path in paths:
        say(f"  {path}")
    return result


def replay(scene, receiver, replicate, options=Options(), preparing=True, say=print):
    """Recomputes one replicate and says what it scored, round by round, at one receiver, counted over all sets from 0."""
    reader, prepared = set_up(scene, preparing)
    filter_ = prepared.put(illuminance_filter(reader, options))
    filter_.SetReplayReceiver(receiver)
    filter_.SetReplayReplicate(replicate)
    with named_options():
        update(filter_)
    table = filter_.GetOutputDataObject(0).GetFieldData().GetArray(arrays.REPLAY)
    rounds = [table.GetTuple(i) for i in range(table.GetNumberOfTuples())]
    replicates, trajectories, estimate, fixed, _ = rounds.pop()
    say(f"receiver {receiver}, replicate {replicate} of {replicates:.0f}, method {options.method}, seed {options.seed}")
    say(f"{'trajectories':>24} {'mean score, lx':>22} {'direct of it, lx':>22} {'largest score so far':>22}")
    for first, count, total, direct, largest in rounds:
        say(f"{first:>11.0f} to {first + count - 1:>9.0f} {total / count:>22.15g} {direct / count:>22.15g} {largest:>22.15g}")
    say(f"does not fluctuate: {fixed:.17g} lx")
    say(f"estimate of {trajectories:.0f} trajectories: {estimate:.17g} lx")
    return estimate


def take_part(scene, options=Options(), preparing=True):
    """The part of a solve() that ranks other than 0 do; rank 0 prints and writes the files."""
    reader, prepared = set_up(scene, preparing)
    with named_options():
        estimate(reader, options, prepared)


def set_up(scene, preparing):
    reader = read_scene(scene)
    check_results(reader, scene)
    check_light(reader, scene)
    check_memory(scene, reader, preparing)
    return reader, prepare_scene(scene, reader) if preparing else UNPREPARED


def check_results(reader, scene):
    """Refuses names that would overwrite summary.json; the reader has checked that names differ from each other."""
    if "summary" in receiver_names(reader) + camera_names(reader):
        raise KalosError(f"{scene}: scene: a receiver set or camera is named summary; expected another name, as the "
                         "results stand in summary.json")


def check_light(reader, scene):
    """Refuses a model without any light; a scene file may describe a dark room on purpose."""
    exitance = reader.GetSurfaces().GetCellData().GetArray(arrays.EXITANCE)
    emits = exitance.GetNumberOfTuples() and exitance.GetRange(-1)[1] > 0
    if os.fspath(scene).lower().endswith(MODELS) and not (emits or reader.GetLuminaires().GetNumberOfPoints()):
        raise KalosError(f"{scene}: scene: nothing emits light; expected lights or emissive materials in the model, or a scene "
                         "file around it with luminaires")


def check_sky(reader, scene):
    """Daylight factors need a sky that shines."""
    sky = reader.GetLuminaires().GetFieldData().GetArray(arrays.SKY)
    if not sky or sky.GetComponent(0, 1) == 0:
        raise KalosError(f"{scene}: sky: there is none, or it is dark; expected one that shines for daylight factors")


def add_daylight(result, receivers, everywhere):
    """The figures of daylight factors of each receiver set."""
    for one in receivers:
        if one.daylight_factor is not None:
            chosen = one.valid | everywhere
            result["receivers"][one.name]["daylight"] = daylight_figures(one.daylight_factor[chosen], one.illuminance[chosen], one.direct[chosen],
                                                                               one.weights[chosen])


def estimate(reader, options, prepared):
    """Runs the estimator over all receiver sets at once, then once per camera.

    Returns the receivers, the images by camera name, and every output whose field data tell how it was solved.
    """
    receivers, images, outputs = [], {}, []
    names = receiver_names(reader)
    if names:
        blocks = run(prepared.put(illuminance_filter(reader, options)), "illuminance")
        receivers = [from_dataset(name, blocks.GetBlock(i)) for i, name in enumerate(names)]
        outputs.append(blocks)
    for i, name in enumerate(camera_names(reader)):
        images[name] = run(prepared.put(luminance_filter(reader, i, options)), f"luminance, {name}")
        outputs.append(images[name])
    return receivers, images, outputs


def summarise(scene, options, receivers, images, outputs, everywhere=False):
    """The content of summary.json; with `everywhere` statistics count the receivers that are not valid, too."""
    labels = ["receivers"] * bool(receivers) + [f"camera {name}" for name in images]
    audit = text.joined_audit(dict(zip(labels, map(fields.audit, outputs))))
    sets = {r.name: {**r.statistics(everywhere), "untrusted": int((~r.trusted).sum()), "trajectories": fields.trajectories(outputs[0]),
                     **({} if r.goal is None else {"goal": goal(r.goal)})}
            for r in receivers}
    cameras = {name: {**image_statistics(image), "trajectories": fields.trajectories(image)}
               for name, image in images.items()}
    return {"kalos": __version__, "scene": str(scene), "method": options.method, "seed": options.seed, "audit": audit,
            "receivers": sets, "cameras": cameras,
            "seconds": sum(fields.field_value(o, arrays.SOLVE_SECONDS) or 0.0 for o in outputs),
            "cpu_seconds": sum(fields.field_value(o, arrays.SOLVE_CPU_SECONDS) or 0.0 for o in outputs)}


def warnings(reader, scene, audit):
    """The warnings of photometric files and of the audit: their number, counts by code, and each one."""
    found = photometry_warnings(reader) + [{"code": "audit", "file": str(scene), "message": message}
                                           for message in fields.warnings_of(audit)]
    return {"count": len(found), "codes": dict(Counter(one["code"] for one in found)), "list": found}


def write(folder, receivers, images, result, look, daylight=False):
    """Tables, data sets, pictures and the summary."""
    write_json(folder / "summary.json", result)
    for one in receivers:
        write_csv(folder / f"{one.name}.csv", one, daylight)
        write_vtp(folder / f"{one.name}.vtp", one.dataset)
        drawing.draw_receivers(folder / f"{one.name}.png", one, look)
    for name, image in images.items():
        writer = vtkKalosEXRWriter()
        writer.SetFileName(str(folder / f"{name}.exr"))
        writer.SetInputData(image)
        update(writer, writer.Write)
        drawing.draw_image(folder / f"{name}.png", name, image, look)
