#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes kalos-presets.json: the colours of vtkKalosFalseColor as ParaView colour maps with ranges for lux and cd/m2.

    PYTHONPATH=build/python apps/paraview/make_presets.py apps/paraview/kalos-presets.json

In ParaView: Choose preset, Import; in pvpython: ImportPresets(filename=...).
"""
import json
import sys

import numpy as np

from kalos.pictures.colours import false_colours

POINTS = 256  # as many as the table has
SCALES = {"Kalos illuminance (lx)": np.linspace(0, 1000, POINTS),
          "Kalos luminance (cd/m2, logarithmic)": np.geomspace(1, 10000, POINTS)}


def presets():
    colours = false_colours()(np.linspace(0, 1, POINTS))[:, :3]
    return [{"ColorSpace": "RGB", "Creator": "Kalos", "Name": name, "NanColor": [128 / 255] * 3,
             "RGBPoints": np.column_stack([values, colours]).round(6).ravel().tolist()} for name, values in SCALES.items()]


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_presets.py FILE.json")
    with open(sys.argv[1], "w", encoding="ascii") as file:
        file.write("[\n" + ",\n".join(map(json.dumps, presets())) + "\n]\n")
