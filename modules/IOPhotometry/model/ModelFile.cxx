// SPDX-License-Identifier: BSD-3-Clause
#include "ModelFile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "../base/InputError.h"
#include "GltfModel.h"
#include "ObjModel.h"

namespace kalos::scene
{
namespace
{
std::string suffix(const std::string& path)
{
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}
}  // namespace

bool isGltfFile(const std::string& path)
{
  return suffix(path) == ".gltf" || suffix(path) == ".glb";
}

bool isModelFile(const std::string& path)
{
  return isGltfFile(path) || suffix(path) == ".obj";
}

Transform uprightPlace(double scale, bool yUp)
{
  Transform place;
  place.axes = {{{scale, 0.0, 0.0},
                 yUp ? Vector3{0.0, 0.0, scale} : Vector3{0.0, scale, 0.0},
                 yUp ? Vector3{0.0, -scale, 0.0} : Vector3{0.0, 0.0, scale}}};
  return place;
}

Model readModelFile(const JsonCursor& place, const std::string& path, const ModelUse& use)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    place.fail("no file " + path + "; expected a mesh file, its path relative to the scene file");
  }
  Model model;
  try
  {
    model = isGltfFile(path) ? readGltfModel(path, use) : readObjModel(path, use);
  }
  catch (const InputError& error)
  {
    throw error.in(path);
  }
  std::size_t dropped = 0;
  for (ModelPart& part : model.parts)
  {
    part.polygons.check(path, "face");
    dropped += part.polygons.dropDegenerate();
  }
  model.parts.erase(std::remove_if(model.parts.begin(), model.parts.end(),
                                   [](const ModelPart& part) { return part.polygons.numberOfPolygons() == 0; }),
                    model.parts.end());
  noteDegenerate(dropped, model.approximations);
  if (model.parts.empty() && model.lights.empty())
  {
    throw InputError(path, "file", "no polygons and no lights; expected at least one of them");
  }
  return model;
}
}  // namespace kalos::scene
