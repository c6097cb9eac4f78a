# SPDX-License-Identifier: BSD-3-Clause
"""Small glTF files, made by hand."""
import base64
import json
import struct

import numpy as np

FORMATS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}


class Gltf(dict):
    """The JSON of a glTF, with the content of its buffer; add...() return the number of what they add."""

    def __init__(self):
        super().__init__(asset={"version": "2.0"}, scene=0, scenes=[{"nodes": []}], nodes=[])
        self.bytes = b""

    def add(self, section, **element):
        self.setdefault(section, []).append(element)
        return len(self[section]) - 1

    def accessor(self, values, component=5126, kind="VEC3", **more):
        values = np.asarray(values, FORMATS[component])
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        view = self.add("bufferViews", buffer=0, byteOffset=len(self.bytes), byteLength=values.nbytes)
        self.bytes += values.tobytes()
        return self.add("accessors", bufferView=view, componentType=component, count=len(values), type=kind, **more)

    def mesh(self, points, indices=None, component=5123, **primitive):
        primitive["attributes"] = {"POSITION": self.accessor(points)}
        if indices is not None:
            primitive["indices"] = self.accessor(indices, component, "SCALAR")
        return self.add("meshes", primitives=[primitive])

    def node(self, root=True, **node):
        number = self.add("nodes", **node)
        if root:
            self["scenes"][0]["nodes"].append(number)
        return number

    def light(self, node=None, **light):
        extension = self.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})
        extension["lights"].append(light)
        return self.node(**(node or {}), extensions={"KHR_lights_punctual": {"light": len(extension["lights"]) - 1}})

    def material(self, color=(1, 1, 1), metallic=0, roughness=1, **more):
        return self.add("materials", pbrMetallicRoughness={
            "baseColorFactor": [*color, 1], "metallicFactor": metallic, "roughnessFactor": roughness}, **more)

    def text(self):
        if self.bytes:
            uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
            self["buffers"] = [{"byteLength": len(self.bytes), "uri": uri}]
        return json.dumps(self)

    def binary(self):
        if self.bytes:
            self["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        data = self.bytes + b"\0" * (-len(self.bytes) % 4)
        chunks += struct.pack("<II", len(data), 0x004E4942) + data
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def save(self, folder, name="model.gltf"):
        path = folder / name
        path.write_bytes(self.binary() if name.endswith(".glb") else self.text().encode())
        return str(path)


SQUARE = [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]  # 2 x 2 m on the floor, y up, seen from above
TRIANGLES = [0, 1, 2, 0, 2, 3]


def floor(size=2.0, **material):
    """A square floor about the origin; returns the Gltf, whose node 0 and material 0 it is."""
    gltf = Gltf()
    gltf.material(**{"color": (0.5, 0.5, 0.5), **material})
    gltf.node(name="floor", mesh=gltf.mesh(np.array(SQUARE) * size / 2, TRIANGLES, material=0))
    return gltf
