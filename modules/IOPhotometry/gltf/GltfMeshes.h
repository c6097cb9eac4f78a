// SPDX-License-Identifier: BSD-3-Clause
/** The meshes of a glTF as polygons. */
#ifndef KalosGltfMeshes_h
#define KalosGltfMeshes_h

#include <cstdint>
#include <map>
#include <vector>

#include "../base/NoteCounter.h"
#include "../base/Notes.h"
#include "../mesh/Transform.h"
#include "GltfFile.h"

namespace kalos::scene
{
constexpr std::size_t MaximumTriangles = 10000000;  ///< of a mesh, and over all instances; with three points for each

/** Triangles of one mesh in its own coordinates; MaterialOf counts the file's materials, -1 for none. */
struct GltfMesh
{
  std::vector<Vector3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int32_t> materialOf;
  std::vector<std::array<double, 3>> colorOf;  ///< mean vertex colour of each triangle, linear; empty without COLOR_0
};

class GltfMeshes
{
public:
  GltfMeshes(const GltfFile& file, Notes& notes) : File(file), Found(notes) {}

  /** The mesh that `number` names, read once. */
  const GltfMesh& read(const JsonCursor& number);

private:
  void readPrimitive(const JsonCursor& primitive, const std::string& name, GltfMesh& mesh);
  void refuseCompression(const JsonCursor& primitive, const JsonCursor& position) const;
  void readColors(const JsonCursor& primitive, const std::string& name,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles, GltfMesh& mesh);

  const GltfFile& File;
  NoteCounter Found;
  std::map<std::size_t, GltfMesh> Known;
};

/** The map of a node: its matrix, or translation, rotation and scale. */
Transform readNodeTransform(const JsonCursor& node);

/** The places of EXT_mesh_gpu_instancing relative to the node; one that changes nothing if the node has none. */
std::vector<Transform> readInstances(const GltfFile& file, const JsonCursor& node);
}  // namespace kalos::scene

#endif
