// SPDX-License-Identifier: BSD-3-Clause
/** What a model file (glTF, OBJ) brings: surfaces in parts, lights, cameras, and what had to be approximated. */
#ifndef KalosModel_h
#define KalosModel_h

#include <string>
#include <vector>

#include "../base/Camera.h"
#include "../base/Notes.h"
#include "../gltf/ModelLight.h"
#include "../mesh/Mesh.h"

namespace kalos::scene
{
/** A part under a name of its own: a node of a glTF, an object of an OBJ. Every polygon has a material. */
struct ModelPart
{
  std::string name;
  Mesh polygons;
};

struct Model
{
  std::vector<ModelPart> parts;
  std::vector<ModelLight> lights;
  std::vector<Camera> cameras;
  Notes approximations;
};
}  // namespace kalos::scene

#endif
