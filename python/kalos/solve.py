# SPDX-License-Identifier: BSD-3-Clause
"""From a scene file to a folder of results: reads, estimates, writes."""
import os
import sys
import time
from collections import Counter
from pathlib import Path

import kalos
from kalos import arrays, pictures, summary as figures
from kalos.errors import KalosError, update
from kalos.estimator import Options, named_options
from kalos.glare import rate_glare
from kalos.hdr import write_hdr
from kalos.memory import check_memory
from kalos.model_file import ModelFile
from kalos.output import staged, write_vtp
from kalos.preparation import UNPREPARED, prepare_scene
from kalos.progress import run
from kalos.receivers import from_dataset
from kalos.tables import write_csv

MODELS = (".glb", ".gltf", ".obj")  # files that are scenes without a JSON around them


def solve(scene, out, options=Options(), say=lambda text: None, preparing=True, report=False, hdr=False):
    """Solves the scene file, or the model (.glb, .gltf, .obj), into the folder `out` and returns what stands in summary.json.

    Every receiver set gives NAME.csv, NAME.vtp and NAME.png, every camera NAME.exr and NAME.png. `say` gets the audit,
    the result table and the paths of the pictures. With `preparing` the surfaces are repaired first, and the audit says
    where they meet at singular edges. `hdr` adds NAME.hdr per camera, a Radiance picture. `report` adds report.html, and NAME-isolux.vtp for flat receiver sets. Raises
    KalosError; the folder then holds nothing new.
    """
    started = time.perf_counter()
    reader, prepared = set_up(scene, preparing)
    setup = time.perf_counter() - started
    with staged(out) as folder:
        with named_options():
            receivers, images, outputs = estimate(reader, options, prepared)
        observers, glare = rate_glare(reader, receivers, prepared)
        result = summarise(scene, options, receivers, images, outputs)
        result["observers"] = observers
        result["audit"] = figures.audit(reader.GetSurfaces(), arrays.SCENE_NOTES) + prepared.audit + result["audit"] + glare
        result["setup_seconds"] = setup
        result["warnings"] = photometry_warnings(reader)
        for one in result["warnings"]["list"]:
            print(f"kalos: warning: {one['file']}: {one['message']}", file=sys.stderr)
        for one in result["audit"]:
            if one["subject"] == "warning":
                print(f"kalos: warning: {scene}: {one['choice']}: {one['reason']}", file=sys.stderr)
        say("audit")
        say(figures.audit_text(result["audit"]))
        write(folder, receivers, images, result)
        if hdr:
            write_hdr(folder, reader, images)
        if report:
            from kalos.report import write_report  # its pictures take seconds to import and to draw

            write_report(folder, scene, reader, receivers, images, result)
        kept = [options.checkpoint, *(options.of_camera(name).checkpoint for name in images)] if options.checkpoint else []
        paths = [Path(out) / name for name in sorted(os.listdir(folder)) if name.endswith(".png")]
    for file in kept:  # the results are in place
        Path(file).unlink(missing_ok=True)
    say(f"result of {result['method']}, seed {result['seed']}")
    say(figures.result_text(result))
    say(f"solved in {result['seconds']:.3g} s, {result['cpu_seconds']:.3g} s of processor time; set-up {setup:.2g} s")
    say("pictures")
    for path in paths:
        say(f"  {path}")
    return result


def replay(scene, receiver, replicate, options=Options(), preparing=True, say=print):
    """Recomputes one replicate and says what it scored, round by round, at one receiver, counted over all sets from 0."""
    reader, prepared = set_up(scene, preparing)
    filter_ = prepared.put(illuminance(reader, options))
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
    """The share of a solve() of every rank but the first, whose are the words and the files."""
    reader, prepared = set_up(scene, preparing)
    with named_options():
        estimate(reader, options, prepared)


def set_up(scene, preparing):
    reader = read_scene(scene)
    check_results(reader, scene)
    check_light(reader, scene)
    check_memory(scene, reader, preparing)
    return reader, prepare_scene(scene, reader) if preparing else UNPREPARED


def read_scene(path):
    """A vtkKalosSceneReader that has read the scene or model file: ports 0 surfaces, 1 luminaires, 2 receivers, and the cameras."""
    reader = kalos.vtkKalosSceneReader()
    reader.SetFileName(os.fspath(path))
    if isinstance(path, ModelFile):
        reader.SetModelUnit(path.unit)
        reader.SetModelUp(path.up)
    update(reader)
    return reader


def photometry_warnings(reader):
    """What the scene's photometric files made one doubt or repair: counts by code, and every warning."""
    table = reader.GetLuminaires().GetFieldData().GetAbstractArray(arrays.PHOTOMETRY_WARNINGS)
    cells = [table.GetValue(i) for i in range(table.GetNumberOfValues())]
    found = [dict(zip(("code", "file", "message"), cells[i:i + 3])) for i in range(0, len(cells), 3)]
    return {"count": len(found), "codes": dict(Counter(one["code"] for one in found)), "list": found}


def receiver_names(reader):
    blocks = reader.GetReceivers()
    return [blocks.GetMetaData(i).Get(blocks.NAME()) for i in range(blocks.GetNumberOfBlocks())]


def camera_names(reader):
    return [reader.GetCameraName(i) for i in range(reader.GetNumberOfCameras())]


def check_results(reader, scene):
    """No results may displace the summary; the reader has seen to it that they do not displace each other."""
    if "summary" in receiver_names(reader) + camera_names(reader):
        raise KalosError(f"{scene}: scene: a receiver set or camera is named summary; expected another name, as the "
                         "results stand in summary.json")


def check_light(reader, scene):
    """A model without light is a mistake, not a dark room; a scene file may say so on purpose."""
    exitance = reader.GetSurfaces().GetCellData().GetArray(arrays.EXITANCE)
    emits = exitance.GetNumberOfTuples() and exitance.GetRange(-1)[1] > 0
    if os.fspath(scene).lower().endswith(MODELS) and not (emits or reader.GetLuminaires().GetNumberOfPoints()):
        raise KalosError(f"{scene}: scene: nothing emits light; expected lights or emissive materials in the model, or a scene "
                         "file around it with luminaires")


def estimate(reader, options, prepared):
    """Runs the estimator over all receiver sets at once, then once per camera.

    Returns the receivers, the images by camera name, and every output whose field data tell how it was solved.
    """
    receivers, images, outputs = [], {}, []
    names = receiver_names(reader)
    if names:
        blocks = run(prepared.put(illuminance(reader, options)), "illuminance")
        receivers = [from_dataset(name, blocks.GetBlock(i)) for i, name in enumerate(names)]
        outputs.append(blocks)
    for i, name in enumerate(camera_names(reader)):
        images[name] = run(prepared.put(luminance_image(reader, i, options)), f"luminance, {name}")
        outputs.append(images[name])
    return receivers, images, outputs


def illuminance(reader, options):
    """The filter that estimates all receiver sets of the scene."""
    estimator = kalos.vtkKalosIlluminance()
    estimator.KeepReplicatesOn()  # for the errors of means and ratios
    estimator.SetInputConnection(0, reader.GetOutputPort(2))
    estimator.SetInputConnection(1, reader.GetOutputPort(0))
    estimator.SetInputConnection(2, reader.GetOutputPort(1))
    if options:
        options.apply(estimator)
    return estimator


def luminance_image(reader, index, options):
    """The filter that estimates what camera `index` of the scene sees."""
    estimator = kalos.vtkKalosLuminanceImage()
    estimator.SetInputConnection(0, reader.GetOutputPort(0))
    estimator.SetInputConnection(1, reader.GetOutputPort(1))
    for get, put in ((reader.GetCameraPosition, estimator.SetPosition), (reader.GetCameraTarget, estimator.SetTarget),
                     (reader.GetCameraUp, estimator.SetUp)):
        vector = [0.0, 0.0, 0.0]
        get(index, vector)
        put(vector)
    resolution = [0, 0]
    reader.GetCameraResolution(index, resolution)
    estimator.SetResolution(resolution)
    estimator.SetFieldOfView(reader.GetCameraFieldOfView(index))
    if options:
        options.of_camera(reader.GetCameraName(index)).apply(estimator)
    return estimator


def summarise(scene, options, receivers, images, outputs):
    """The content of summary.json."""
    labels = ["receivers"] * bool(receivers) + [f"camera {name}" for name in images]
    audit = figures.joined_audit(dict(zip(labels, map(figures.audit, outputs))))
    sets = {r.name: {**figures.statistics(r.illuminance, r.standard_error, r.weights, r.replicates),
                     "untrusted": int((~r.trusted).sum()), "trajectories": figures.trajectories(outputs[0]),
                     **({} if r.goal is None else {"goal": figures.goal(r.goal)})}
            for r in receivers}
    cameras = {name: {**figures.image_statistics(image), "trajectories": figures.trajectories(image)}
               for name, image in images.items()}
    return {"kalos": kalos.__version__, "scene": str(scene), "method": options.method, "seed": options.seed, "audit": audit,
            "receivers": sets, "cameras": cameras,
            "seconds": sum(figures.field_value(o, arrays.SOLVE_SECONDS) or 0.0 for o in outputs),
            "cpu_seconds": sum(figures.field_value(o, arrays.SOLVE_CPU_SECONDS) or 0.0 for o in outputs)}


def write(folder, receivers, images, result):
    """Tables, data sets, pictures and the summary."""
    figures.write_json(folder / "summary.json", result)
    for one in receivers:
        write_csv(folder / f"{one.name}.csv", one)
        write_vtp(folder / f"{one.name}.vtp", one.dataset)
        pictures.draw_receivers(folder / f"{one.name}.png", one)
    for name, image in images.items():
        writer = kalos.vtkKalosEXRWriter()
        writer.SetFileName(str(folder / f"{name}.exr"))
        writer.SetInputData(image)
        update(writer, writer.Write)
        pictures.draw_image(folder / f"{name}.png", name, image)
