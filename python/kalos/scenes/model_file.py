# SPDX-License-Identifier: BSD-3-Clause
"""Model files with what they do not say: their unit of length and their axis that is up."""
from kalos.errors import KalosError

UNITS = {"mm": 0.001, "cm": 0.01, "m": 1.0, "in": 0.0254, "ft": 0.3048}  # metres
AXES = ("y", "z")
MODELS = (".glb", ".gltf", ".obj")  # files that are scenes without a JSON around them


class ModelFile(str):
    """The path of a model; unit in metres, up "y", "z" or "" for the format's own."""

    unit = 1.0
    up = ""


def placed(path, unit, up):
    """The path, or for a unit or an axis a ModelFile with them; scene files hold both themselves."""
    if unit is None and up is None:
        return path
    option = "--up" if unit is None else "--unit"
    if not str(path).lower().endswith(MODELS):
        raise KalosError(f"{path}: {option}: a scene file says so itself, by \"scale\" and \"up\" beside \"file\"; expected a model "
                         f"({', '.join(MODELS)})")
    model = ModelFile(path)
    model.unit, model.up = UNITS[unit or "m"], up or ""
    return model
