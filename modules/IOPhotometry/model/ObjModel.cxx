// SPDX-License-Identifier: BSD-3-Clause
#include "ObjModel.h"

#include <algorithm>
#include <filesystem>
#include <unordered_map>

#include "../scene/FilePaths.h"
#include "../scene/SceneError.h"
#include "MtlFile.h"
#include "Tally.h"

namespace kalos::scene
{
namespace
{
/** All libraries that are there, in one; `missing` names those that are not. */
Materials ReadLibraries(const std::string& path, const ObjFile& file, Notes& notes, std::string& missing)
{
  Materials all;
  for (const std::string& name : file.Libraries)
  {
    const std::string library = ResolvePath(std::filesystem::path(path).parent_path().string(), name, notes);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(library, ignored))
    {
      all.merge(ReadMtlFile(library, notes));
    }
    else
    {
      missing += " (there is no " + Quotable(name) + ")";
    }
  }
  return all;
}

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

std::vector<Material> FindObjMaterials(const std::string& path, const ObjFile& file, const Materials& overrides,
                                       Notes& notes)
{
  const auto given = [&](const std::string& name) { return overrides.count(name) > 0; };
  Materials own;
  std::string missing;
  if (!std::all_of(file.MaterialNames.begin(), file.MaterialNames.end(), given))
  {
    own = ReadLibraries(path, file, notes, missing);
  }
  std::vector<Material> materials;
  for (const std::string& name : file.MaterialNames)
  {
    const Materials& from = given(name) ? overrides : own;
    const auto found = from.find(name);
    if (found == from.end())
    {
      throw SceneError(
          path, "usemtl " + Quotable(name),
          "no such material in the scene; expected a name from \"materials\" or of a library of the file" + missing);
    }
    materials.push_back(found->second);
  }
  return materials;
}

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
  Tally found(model.Approximations);
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
