// SPDX-License-Identifier: BSD-3-Clause
#include "ObjModel.h"

#include <algorithm>
#include <unordered_map>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/NoteCounter.h"
#include "../mesh/ObjMaterials.h"

namespace kalos::scene
{
namespace
{
/** Give the mesh, whose corners count `all`, the points of these that it uses. */
void takePoints(Mesh& mesh, const std::vector<Vector3>& all, const Transform& place)
{
  std::unordered_map<std::int64_t, std::int64_t> numbers;
  for (std::int64_t& corner : mesh.corners)
  {
    const auto [known, added] = numbers.emplace(corner, static_cast<std::int64_t>(mesh.points.size()));
    if (added)
    {
      mesh.points.push_back(place.point(all[corner]));
    }
    corner = known->second;
  }
}
}  // namespace

Model readObjModel(const std::string& path, const ModelUse& use)
{
  Model model;
  ObjFile file = readObjFile(path, model.approximations);
  useObjMaterials(path, file, *use.overrides, false, model.approximations);
  std::vector<Material>& palette = file.polygons.palette;
  const auto unnamed = static_cast<std::int32_t>(palette.size());
  Material plain;
  plain.reflectance = {UnnamedReflectance};
  palette.push_back(use.fallback ? *use.fallback : plain);

  std::vector<ModelPart> parts(file.objectNames.size());
  NoteCounter found(model.approximations);
  for (std::size_t p = 0; p < file.polygons.numberOfPolygons(); ++p)
  {
    const std::size_t object = file.objectOf[p];
    ModelPart& part = parts[object];
    part.name = file.objectNames[object];
    std::vector<std::int64_t> corners;
    for (std::int64_t i = file.polygons.begin(p); i < file.polygons.ends[p]; ++i)
    {
      corners.push_back(file.polygons.corners[i]);
    }
    const std::int32_t material = file.polygons.materialOf[p];
    part.polygons.addPolygon(corners, material < 0 ? unnamed : material);
  }
  const bool anyPlain = std::count(file.polygons.materialOf.begin(), file.polygons.materialOf.end(), -1) > 0;
  if (anyPlain && !use.fallback)
  {
    found.count(UnnamedSubject, path.substr(path.find_last_of('/') + 1), UnnamedChoice, UnnamedReason);
  }
  for (ModelPart& part : parts)
  {
    if (part.polygons.numberOfPolygons() > 0)
    {
      takePoints(part.polygons, file.polygons.points, use.place);
      part.polygons.takeMaterials(palette);
      model.parts.push_back(std::move(part));
    }
  }
  return model;
}
}  // namespace kalos::scene
