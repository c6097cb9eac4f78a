# SPDX-License-Identifier: BSD-3-Clause
"""`kalos year`: daylight coefficients of the patches of the sky, times the sky of every hour of a weather file.

E(t) = sum over patches p of C_p L_p(t): C_p is the illuminance under a sky of 1 cd/m2 in patch p, with the ground that this sky
lights, L_p(t) the mean luminance of Perez's sky over the patch at hour t. The sun is spread over the patch that it stands in.
Every patch has random numbers of its own, so that its error is independent of the others'.
"""
import datetime
from pathlib import Path

import numpy as np

from kalos.core import arrays
from kalos.core.options import named_options
from kalos.core.output import staged, write_json
from kalos.daylight.patches import Patches
from kalos.daylight.perez import illuminances, relative_luminance
from kalos.daylight.weather import HOURS, read_epw
from kalos.errors import KalosError, update
from kalos.estimation.filters import illuminance_filter
from kalos.preparation.scene import UNPREPARED, prepare_scene
from kalos.results.receivers import from_dataset
from kalos.scenes.reading import read_scene, receiver_names
from kalos.scenes.skies import sky, sun_positions

NORTH, GROUND = 9, 8  # components of the array Sky
SAID = 29  # patches between lines of progress
OCCUPIED = (8, 18)  # o'clock, of daylight autonomy
AUTONOMY, USEFUL = 300.0, (100.0, 3000.0)  # lx


def year(scene, weather, out, options, subdivision=1, preparing=True, say=print):
    """Writes NAME.npz per receiver set with the illuminance of every hour, and year.json with its figures."""
    found = read_epw(weather)
    reader = read_scene(scene)
    names = receiver_names(reader)
    if not names:
        raise KalosError(f"{scene}: scene: no receivers; expected some for a year of daylight")
    prepared = prepare_scene(scene, reader) if preparing else UNPREPARED
    patches = Patches(subdivision)
    with named_options():
        coefficients, errors = solve_patches(reader, prepared, options, patches, names, say)
    skies = hourly_luminances(found, patches)
    result = {"scene": str(scene), "weather": found.place, "patches": patches.count, "receivers": {}}
    with staged(out) as folder:
        for name in names:
            hours, deviation = skies @ coefficients[name], np.sqrt(skies**2 @ errors[name] ** 2)
            mean_error = np.sqrt((skies.mean(axis=0) ** 2) @ errors[name] ** 2)
            np.savez_compressed(folder / f"{name}.npz", illuminance=hours.astype(np.float32), standard_error=deviation.astype(np.float32))
            result["receivers"][name] = figures(hours, mean_error)
        write_json(folder / "year.json", result)
    for name, one in result["receivers"].items():
        say(f"{name}: annual mean {one['annual_mean_lx']:.4g} lx +- {one['annual_mean_standard_error_lx']:.2g}, daylight autonomy "
            f"{100 * one['daylight_autonomy']:.3g} %, useful {100 * one['useful_daylight']:.3g} %")
    say(f"results in {Path(out)}")
    return result


def solve_patches(reader, prepared, options, patches, names, say):
    """Coefficients and their standard errors, (patches, receivers) by receiver set, lx for 1 cd/m2."""
    given = reader.GetLuminaires().GetFieldData().GetArray(arrays.SKY)
    ground, north = (given.GetComponent(0, GROUND), given.GetComponent(0, NORTH)) if given else (0.0, 0.0)
    coefficients, errors = {}, {}
    for patch in range(patches.count):
        filter_ = prepared.put(illuminance_filter(reader, options.of_patch(patch)))
        filter_.SetInputData(2, sky(luminance_map=patches.map_of(patch), ground_reflectance=ground, north_deg=north))
        update(filter_)
        blocks = filter_.GetOutputDataObject(0)
        if (patch + 1) % SAID == 0:
            say(f"{patch + 1} of {patches.count} patches of the sky")
        for i, name in enumerate(names):
            one = from_dataset(name, blocks.GetBlock(i))
            coefficients.setdefault(name, []).append(one.illuminance)
            errors.setdefault(name, []).append(one.standard_error)
    return ({name: np.array(rows) for name, rows in coefficients.items()}, {name: np.array(rows) for name, rows in errors.items()})


def hourly_luminances(weather, patches):
    """Mean luminance of each patch in each hour, (8760, patches) cd/m2; 0 at night. The sun is that of the middle of the hour."""
    start = datetime.datetime(2001, 1, 1, tzinfo=datetime.timezone(datetime.timedelta(hours=weather.time_zone)))
    elevation, azimuth = sun_positions(start + datetime.timedelta(minutes=30), HOURS, weather.latitude, weather.longitude)
    day = (elevation > 0) & (weather.diffuse_horizontal > 0)
    zenith = np.radians(90 - elevation[day])
    diffuse, direct, coefficients = illuminances(weather.direct_normal[day], weather.diffuse_horizontal[day], zenith)
    e, a = patches.samples()
    ways, suns = directions(e, a), directions(elevation[day], azimuth[day])
    omega, found = patches.solid_angles(), np.zeros((HOURS, patches.count))
    level = np.mean(np.sin(np.radians(e)), axis=1) * omega
    for k, hour in enumerate(np.flatnonzero(day)):
        chi = np.arccos(np.clip(ways @ suns[k], -1, 1))
        pattern = relative_luminance(coefficients[k], ways[..., 2], chi)
        horizontal = np.sum(np.mean(pattern * ways[..., 2], axis=1) * omega)
        if horizontal > 0:
            found[hour] = pattern.mean(axis=1) * max(diffuse[k], 0) / horizontal
        place = int(patches.of(elevation[hour], azimuth[hour]))
        found[hour, place] += direct[k] * np.sin(np.radians(elevation[hour])) / level[place]
    return found


def directions(elevation, azimuth):
    """Unit vectors, east, north and up."""
    e, a = np.radians(elevation), np.radians(azimuth)
    return np.stack([np.cos(e) * np.sin(a), np.cos(e) * np.cos(a), np.sin(e)], axis=-1)


def figures(hours, mean_error):
    """Of the hours (8760, receivers): means over the receivers; autonomy and useful illuminance in occupied hours."""
    clock = np.arange(HOURS) % 24
    occupied = hours[(clock >= OCCUPIED[0]) & (clock < OCCUPIED[1])]
    mean = hours.mean(axis=0)
    return {"annual_mean_lx": float(mean.mean()), "annual_mean_standard_error_lx": float(np.sqrt(np.mean(mean_error**2))),
            "daylight_autonomy": float((occupied >= AUTONOMY).mean()),
            "useful_daylight": float(((occupied >= USEFUL[0]) & (occupied <= USEFUL[1])).mean()),
            "too_bright": float((occupied > USEFUL[1]).mean()), "too_dark": float((occupied < USEFUL[0]).mean())}
