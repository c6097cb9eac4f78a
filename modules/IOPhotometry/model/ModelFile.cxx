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
std::string Suffix(const std::string& path)
{
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}
}  // namespace

bool IsGltfFile(const std::string& path)
{
  return Suffix(path) == ".gltf" || Suffix(path) == ".glb";
}

bool IsModelFile(const std::string& path)
{
  return IsGltfFile(path) || Suffix(path) == ".obj";
}

Transform UprightPlace(double scale, bool yUp)
{
  Transform place;
  place.Axes = {{{scale, 0.0, 0.0},
                 yUp ? Vector3{0.0, 0.0, scale} : Vector3{0.0, scale, 0.0},
                 yUp ? Vector3{0.0, -scale, 0.0} : Vector3{0.0, 0.0, scale}}};
  return place;
}

Model ReadModelFile(const JsonCursor& place, const std::string& path, const ModelUse& use)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    place.Fail("no file " + path + "; expected a mesh file, its path relative to the scene file");
  }
  Model model;
  try
  {
    model = IsGltfFile(path) ? ReadGltfModel(path, use) : ReadObjModel(path, use);
  }
  catch (const InputError& error)
  {
    throw error.In(path);
  }
  std::size_t dropped = 0;
  for (ModelPart& part : model.Parts)
  {
    dropped += part.Polygons.DropDegenerate();
    part.Polygons.Check(path, "face");
  }
  model.Parts.erase(std::remove_if(model.Parts.begin(), model.Parts.end(),
                                   [](const ModelPart& part) { return part.Polygons.NumberOfPolygons() == 0; }),
                    model.Parts.end());
  if (dropped > 0)
  {
    model.Approximations.push_back(
        {"degenerate faces", "left out", "they have no area (" + std::to_string(dropped) + ")"});
  }
  if (model.Parts.empty() && model.Lights.empty())
  {
    throw InputError(path, "file", "no polygons and no lights; expected at least one of them");
  }
  return model;
}
}  // namespace kalos::scene
