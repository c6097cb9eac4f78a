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
void TakePoints(Mesh& mesh, const std::vector<Vector3>& all, const Transform& place)
{
  std::unordered_map<std::int64_t, std::int64_t> numbers;
  for (std::int64_t& corner : mesh.Corners)
  {
    const auto [known, added] = numbers.emplace(corner, static_cast<std::int64_t>(mesh.Points.size()));
    if (added)
    {
      mesh.Points.push_back(place.Point(all[corner]));
    }
    corner = known->second;
  }
}
}  // namespace

Model ReadObjModel(const std::string& path, const ModelUse& use)
{
  Model model;
  const ObjFile file = ReadObjFile(path);
  std::vector<Material> palette = FindObjMaterials(path, file, *use.Overrides, model.Approximations);
  const auto unnamed = static_cast<std::int32_t>(palette.size());
  Material plain;
  plain.Reflectance = {UnnamedReflectance};
  palette.push_back(use.Fallback ? *use.Fallback : plain);

  std::vector<ModelPart> parts(file.ObjectNames.size());
  NoteCounter found(model.Approximations);
  for (std::size_t p = 0; p < file.Polygons.NumberOfPolygons(); ++p)
  {
    const std::size_t object = file.ObjectOf[p];
    ModelPart& part = parts[object];
    part.Name = file.ObjectNames[object];
    std::vector<std::int64_t> corners;
    for (std::int64_t i = file.Polygons.Begin(p); i < file.Polygons.Ends[p]; ++i)
    {
      corners.push_back(file.Polygons.Corners[i]);
    }
    const std::int32_t material = file.Polygons.MaterialOf[p];
    part.Polygons.AddPolygon(corners, material < 0 ? unnamed : material);
  }
  const bool anyPlain = std::count(file.Polygons.MaterialOf.begin(), file.Polygons.MaterialOf.end(), -1) > 0;
  if (anyPlain && !use.Fallback)
  {
    found.Count(UnnamedSubject, path.substr(path.find_last_of('/') + 1), UnnamedChoice, UnnamedReason);
  }
  for (ModelPart& part : parts)
  {
    if (part.Polygons.NumberOfPolygons() > 0)
    {
      TakePoints(part.Polygons, file.Polygons.Points, use.Place);
      part.Polygons.TakeMaterials(palette);
      model.Parts.push_back(std::move(part));
    }
  }
  return model;
}
}  // namespace kalos::scene
