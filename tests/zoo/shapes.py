# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces, luminaires and receivers that rooms are made of. Lengths in m."""
import numpy as np


def quad(name, origin, u, v, material):
    """A parallelogram whose normal is u x v."""
    return {"name": name, "quad": {"origin": list(origin), "u": list(u), "v": list(v)}, "material": material}


def box(name, center, size, material, rotation=0):
    return {"name": name, "box": {"center": list(center), "size": list(size), "rotation_z_deg": rotation}, "material": material}


def shell(size, material, origin=(0, 0, 0), name="", leave=()):
    """The six faces of a room, normals inwards. `material` is one name or a dictionary by face, with "" for the others."""
    a, b, c = size
    x, y, z = origin
    materials = material if isinstance(material, dict) else {"": material}
    faces = {"floor": ((x, y, z), (a, 0, 0), (0, b, 0)), "ceiling": ((x, y, z + c), (0, b, 0), (a, 0, 0)),
             "left": ((x, y, z), (0, b, 0), (0, 0, c)), "right": ((x + a, y, z), (0, 0, c), (0, b, 0)),
             "front": ((x, y, z), (0, 0, c), (a, 0, 0)), "back": ((x, y + b, z), (a, 0, 0), (0, 0, c))}
    return [quad(name + face, *corners, materials.get(face, materials.get(""))) for face, corners in faces.items() if face not in leave]


def lamp(position, flux=1000.0, distribution="isotropic", aim=(0, 0, -1), name="lamp"):
    return {"name": name, "position": list(position), "aim": list(aim), "flux": flux, "distribution": distribution}


def panel(center, u, v, aim, flux, name="panel"):
    return {"name": name, "rectangle": {"center": list(center), "u": list(u), "v": list(v)}, "aim": list(aim), "flux": flux}


def scene(materials, surfaces, luminaires=()):
    """Materials as dictionaries, or as bare reflectances."""
    given = {name: one if isinstance(one, dict) else {"reflectance": one} for name, one in materials.items()}
    return {"materials": given, "surfaces": list(surfaces), "luminaires": list(luminaires)}


def grid(origin, u, v, columns, rows):
    """Receivers at the centres of the cells of a rectangle, normals u x v."""
    origin, u, v = (np.asarray(one, float) for one in (origin, u, v))
    normal = np.cross(u, v)
    normal /= np.linalg.norm(normal)
    return np.array([[*(origin + (i + 0.5) / columns * u + (j + 0.5) / rows * v), *normal]
                     for j in range(rows) for i in range(columns)])


def row(start, end, normal, count):
    """Receivers from `start` to `end`, both included."""
    points = np.linspace(start, end, count)
    return np.hstack([points, np.broadcast_to(np.asarray(normal, float), points.shape)])


def joined(*receivers):
    return np.vstack(receivers)


def room_places(size, origin=(0, 0, 0), margin=0.15):
    """Fifteen receivers on floor, walls and ceiling of a room, looking inwards, none in its symmetry planes."""
    a, b, c = size
    across = np.array([(0.31, 0.27), (0.83, 0.61), (0.47, 0.88)])
    across = margin + (1 - 2 * margin) * across
    places = [[a * p, b * q, 0, 0, 0, 1] for p, q in across] + [[a * q, b * p, c, 0, 0, -1] for p, q in across]
    places += [[0, b * p, c * q, 1, 0, 0] for p, q in across] + [[a, b * q, c * p, -1, 0, 0] for p, q in across]
    places += [[a * q, b, c * p, 0, -1, 0] for p, q in across]
    places = np.array(places, float)
    places[:, :3] += origin
    return places


def obj(vertices, faces):
    """The text of an OBJ file; faces count vertices from 0."""
    return "".join("v " + " ".join(repr(float(x)) for x in one) + "\n" for one in vertices) + \
        "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def sphere(radius, level, inwards=True, center=(0, 0, 0)):
    """A subdivided octahedron blown up so that its area is that of the sphere: vertices, faces."""
    vertices = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    vertices = [np.array(v, float) for v in vertices]
    for _ in range(level):
        middle, finer = {}, []
        for face in faces:
            mids = []
            for i, j in zip(face, face[1:] + face[:1]):
                key = (min(i, j), max(i, j))
                if key not in middle:
                    point = vertices[i] + vertices[j]
                    vertices.append(point / np.linalg.norm(point))
                    middle[key] = len(vertices) - 1
                mids.append(middle[key])
            (a, b, c), (d, e, f) = face, mids
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    corners = np.array(vertices)[np.array(faces)]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    scale = radius * np.sqrt(4 * np.pi / area)
    points = scale * np.array(vertices) + center
    return points, [face[::-1] for face in faces] if inwards else faces
