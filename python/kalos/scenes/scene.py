# SPDX-License-Identifier: BSD-3-Clause
"""A scene file as a Python object: built or read, changed, solved and written back."""
from __future__ import annotations

import contextlib
import copy
import json
import os
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from kalos.core.output import write_vtp
from kalos.errors import InputError, KalosError
from kalos.scenes.checks import numbers, units

SECTIONS = ("surfaces", "luminaires", "receivers", "cameras")
REFERENCES = ("file", "points")  # keys whose text is a path

PathLike = Union[str, "os.PathLike[str]"]


class Scene:
    """What a scene file says, in its words: `kalos schema` prints them all. Lengths are metres, flux is in lumens.

    materials: a dict by name; surfaces, luminaires, receivers, cameras: lists of dicts with a "name" each. All may be changed
    at will; scene["lamp"] is the entry of that name. What is wrong shows when the scene is solved. Paths of files are kept
    absolute, and written relative to the scene file where they are below it.

    >>> scene = Scene()
    >>> scene.add_material("white", reflectance=0.7)
    >>> scene.add("surfaces", "room", box={"center": [2, 2, 1.5], "size": [4, 4, 3]}, material="white")
    >>> scene.add("luminaires", "lamp", position=[2, 2, 2.9], aim=[0, 0, -1], flux=3000, distribution="lambertian")
    >>> scene.add_plane("desk", origin=[0, 0, 0.75], u=[4, 0, 0], v=[0, 4, 0], resolution=[8, 8])
    >>> scene["lamp"]["flux"] = 4000
    """

    def __init__(self) -> None:
        self.name = "scene"
        self.materials: Dict[str, Dict[str, Any]] = {}
        self.surfaces: List[Dict[str, Any]] = []
        self.luminaires: List[Dict[str, Any]] = []
        self.receivers: List[Dict[str, Any]] = []
        self.cameras: List[Dict[str, Any]] = []
        self._meshes: Dict[str, vtkPolyData] = {}
        self._points: Dict[str, Tuple[np.ndarray, np.ndarray]] = {}

    @classmethod
    def read(cls, path: PathLike) -> Scene:
        """The scene of a JSON file. Raises KalosError where it is not one; its values are checked when it is solved."""
        path, scene = Path(path), cls()
        try:
            document = json.loads(path.read_text(encoding="utf-8-sig"))
        except OSError as error:
            raise KalosError(f"{path}: file: cannot be read ({error.strerror}), expected a scene file") from None
        except ValueError as error:
            raise KalosError(f"{path}: file: {error}, expected JSON") from None
        if not isinstance(document, dict) or document.get("kalos") != 1:
            raise KalosError(f"{path}: kalos: not 1, expected a scene file with the key \"kalos\": 1")
        for section in ("materials", *SECTIONS):
            setattr(scene, section, document.get(section, {} if section == "materials" else []))
        scene.name = path.stem
        for key, entry in scene._references():
            entry[key] = str((path.resolve().parent / entry[key]).absolute())
        return scene

    def __getitem__(self, name: str) -> Dict[str, Any]:
        for section in SECTIONS:
            for entry in getattr(self, section):
                if entry.get("name") == name:
                    return entry
        raise KeyError(f"{name!r} is no surface, luminaire, receiver set or camera of this scene")

    def add_material(self, name: str, **properties: Any) -> None:
        """A material: reflectance, specular, roughness, mirror, exitance as in a scene file."""
        self.materials[name] = plain(properties)

    def add(self, section: str, name: str, **entry: Any) -> None:
        """An entry of surfaces, luminaires, receivers or cameras with the keys of a scene file; arrays become lists."""
        if section not in SECTIONS:
            raise InputError(f"section: is {section!r}, expected one of {', '.join(SECTIONS)}")
        entry = plain(entry)
        for key in REFERENCES:
            if isinstance(entry.get(key), str):
                entry[key] = os.path.abspath(entry[key])
        getattr(self, section).append({"name": name, **entry})

    def add_surface(self, name: str, mesh: vtkPolyData, material: Optional[str] = None) -> None:
        """A mesh, as kalos.surface(), quad() and box() make it; with a material's name instead of its own arrays."""
        if not isinstance(mesh, vtkPolyData):
            raise InputError(f"mesh: is of {type(mesh).__name__}, expected vtkPolyData")
        self._meshes[name] = mesh
        self.surfaces.append({"name": name, "file": f"{name}.vtp", **({} if material is None else {"material": material})})

    def add_luminaire(self, name: str, position: ArrayLike, *, aim: ArrayLike = (0, 0, -1), flux: Optional[float] = None,
                      file: Optional[PathLike] = None, distribution: Optional[str] = None, rotation_deg: float = 0.0) -> None:
        """A luminaire at a place, m: of a photometric file, or with a flux, lm, and "lambertian" (the default) or "isotropic"."""
        entry: Dict[str, Any] = {"position": position, "aim": aim, "rotation_deg": rotation_deg}
        if file is not None:
            entry["file"] = os.path.abspath(file)
        else:
            entry["distribution"] = distribution or "lambertian"
        self.add("luminaires", name, **entry, **({} if flux is None else {"flux": flux}))

    def add_plane(self, name: str, origin: ArrayLike, u: ArrayLike, v: ArrayLike, resolution: ArrayLike) -> None:
        """A calculation plane: its values are those at the centres of cells, columns along u and rows along v."""
        self.add("receivers", name, plane={"origin": origin, "u": u, "v": v, "resolution": resolution})

    def add_points(self, name: str, points: ArrayLike, normals: ArrayLike) -> None:
        """Receivers at points (n, 3), m, with unit normals (n, 3) or (3,)."""
        places = numbers("points", points, [("n", 3)])
        self._points[name] = places, np.broadcast_to(units("normals", normals, [places.shape, (3,)]), places.shape)
        self.receivers.append({"name": name, "points": f"{name}.csv"})

    def add_camera(self, name: str, position: ArrayLike, target: ArrayLike, *, up: ArrayLike = (0, 0, 1), fov_deg: float = 45.0,
                   resolution: ArrayLike = (256, 256)) -> None:
        """A camera, m; fov_deg is its vertical field of view."""
        self.add("cameras", name, position=position, target=target, up=up, fov_deg=fov_deg, resolution=resolution)

    def write(self, path: PathLike) -> None:
        """Writes the scene file; meshes and points that came as arrays beside it, as NAME.vtp and NAME.csv."""
        path, document = Path(path), self._document()
        for name, mesh in self._meshes.items():
            write_vtp(path.parent / f"{name}.vtp", mesh)
        for name, columns in self._points.items():
            np.savetxt(path.parent / f"{name}.csv", np.hstack(columns), "%r", ",", header="x,y,z,nx,ny,nz", comments="")
        for key, entry in references(document):
            with contextlib.suppress(ValueError):  # a file elsewhere keeps its absolute path
                entry[key] = str(Path(entry[key]).relative_to(path.resolve().parent))
        path.write_text(json.dumps(document, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")

    def _document(self) -> Dict[str, Any]:
        found = {"kalos": 1, "materials": self.materials, **{section: getattr(self, section) for section in SECTIONS}}
        return copy.deepcopy({key: value for key, value in found.items() if value})

    def _references(self) -> Iterator[Tuple[str, Dict[str, Any]]]:
        return references({section: getattr(self, section) for section in SECTIONS})


def references(document: Dict[str, Any]) -> Iterator[Tuple[str, Dict[str, Any]]]:
    """Keys whose value is a path, with the entry that has them."""
    for section in SECTIONS:
        for entry in document.get(section, ()):
            if isinstance(entry, dict):
                yield from ((key, entry) for key in REFERENCES if isinstance(entry.get(key), str))


def plain(value: Any) -> Any:
    """Arrays and NumPy's numbers as JSON has them."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value


@contextlib.contextmanager
def scene_file(scene: Union[Scene, PathLike]) -> Iterator[Path]:
    """The path of a scene file, for a Scene of one that is there within the block; messages name the scene."""
    if not isinstance(scene, Scene):
        yield Path(scene)
        return
    with tempfile.TemporaryDirectory(prefix="kalos-") as folder:
        path = Path(folder) / f"{scene.name}.json"
        scene.write(path)
        try:
            yield path
        except KalosError as error:
            raise KalosError(str(error).replace(str(path), scene.name), error.status) from None
