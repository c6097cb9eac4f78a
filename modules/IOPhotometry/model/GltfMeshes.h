// SPDX-License-Identifier: BSD-3-Clause
/** The meshes of a glTF as polygons. */
#ifndef KalosGltfMeshes_h
#define KalosGltfMeshes_h

#include <cstdint>
#include <map>
#include <vector>

#include "../scene/SceneNotes.h"
#include "GltfFile.h"
#include "Tally.h"
#include "Transform.h"

namespace kalos::scene
{
constexpr std::size_t MaximumTriangles = 10000000;  ///< of a mesh, and over all instances; with three points for each

/** Triangles of one mesh in its own coordinates; MaterialOf counts the file's materials, -1 for none. */
struct GltfMesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<std::uint32_t, 3>> Triangles;
  std::vector<std::int32_t> MaterialOf;
};

class GltfMeshes
{
public:
  GltfMeshes(const GltfFile& file, Notes& notes) : File(file), Found(notes) {}

  /** The mesh that `number` names, read once. */
  const GltfMesh& Read(const Node& number);

private:
  void ReadPrimitive(const Node& primitive, const std::string& name, GltfMesh& mesh);

  const GltfFile& File;
  Tally Found;
  std::map<std::size_t, GltfMesh> Known;
};

/** The map of a node: its matrix, or translation, rotation and scale. */
Transform ReadNodeTransform(const Node& node);

/** The places of EXT_mesh_gpu_instancing relative to the node; one that changes nothing if the node has none. */
std::vector<Transform> ReadInstances(const GltfFile& file, const Node& node);
}  // namespace kalos::scene

#endif
