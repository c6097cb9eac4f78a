// SPDX-License-Identifier: BSD-3-Clause
#include "SceneModels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "../base/FilePaths.h"
#include "../base/Names.h"
#include "../mesh/MeshFile.h"
#include "../model/ModelFile.h"

namespace kalos::scene
{
namespace
{
constexpr double LargestBuilding = 100.0;  ///< m, along its shortest side
constexpr double LeastModel = 0.01;        ///< m, along its longest side

/** Where the coordinates of a file lie; without keys, glTF has y up and all others z. */
Transform readPlace(const JsonCursor& node, const std::string& path)
{
  const auto scale = node.find("scale");
  const auto up = node.find("up");
  const std::string axis = up ? up->string() : isGltfFile(path) ? "y" : "z";
  if (axis != "y" && axis != "z")
  {
    up->failExpected("\"y\" or \"z\"");
  }
  return uprightPlace(scale ? scale->numberAbove(0.0) : 1.0, axis == "y");
}

/** All parts of a model as one mesh. */
Mesh join(const Model& model)
{
  Mesh mesh;
  for (const ModelPart& part : model.parts)
  {
    const Mesh& from = part.polygons;
    const auto firstPoint = static_cast<std::int64_t>(mesh.points.size());
    const auto firstCorner = static_cast<std::int64_t>(mesh.corners.size());
    const auto firstMaterial = static_cast<std::int32_t>(mesh.palette.size());
    mesh.points.insert(mesh.points.end(), from.points.begin(), from.points.end());
    mesh.palette.insert(mesh.palette.end(), from.palette.begin(), from.palette.end());
    for (const std::int64_t corner : from.corners)
    {
      mesh.corners.push_back(firstPoint + corner);
    }
    for (std::size_t p = 0; p < from.numberOfPolygons(); ++p)
    {
      mesh.ends.push_back(firstCorner + from.ends[p]);
      mesh.materialOf.push_back(firstMaterial + from.materialOf[p]);
    }
  }
  return mesh;
}

/** Sides of the box about a model, m, of which y and z are those of the scene. */
struct Extent
{
  Vector3 sides{};
  double longest() const { return std::max({this->sides[0], this->sides[1], this->sides[2]}); }
};

Extent extentOf(const Model& model)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  Vector3 low{far, far, far}, high{-far, -far, -far};
  for (const ModelPart& part : model.parts)
  {
    for (const Vector3& point : part.polygons.points)
    {
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], point[c]);
        high[c] = std::max(high[c], point[c]);
      }
    }
  }
  return model.parts.empty() ? Extent{} : Extent{high - low};
}

std::string metres(double length)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << length << " m";
  return text.str();
}

void tellAxes(const JsonCursor& node, const std::string& path, const Extent& extent, Notes& notes)
{
  if (node.has("up"))
  {
    return;
  }
  std::string reason = "\"up\" and \"scale\" beside \"file\" in a scene file change it";
  // Rooms are lower than they are long and wide.
  const Vector3& sides = extent.sides;
  if (!isGltfFile(path) && sides[1] > 0.0 && sides[1] < 0.8 * std::min(sides[0], sides[2]))
  {
    reason += "; the model is lower along y (" + metres(sides[1]) + ") than along x and z (" + metres(sides[2]) +
              "): expected \"up\": \"y\" if it was made with y up";
  }
  notes.push_back({"axes", isGltfFile(path) ? "turned from y up to z up" : "as in the file, z up", reason});
}

void tellUnit(const Extent& extent, Notes& notes)
{
  const Vector3& sides = extent.sides;
  const double lowest = std::min({sides[0], sides[1], sides[2]});
  const std::string size = metres(sides[0]) + " x " + metres(sides[1]) + " x " + metres(sides[2]);
  if (lowest > LargestBuilding || extent.longest() > 1000.0 * LargestBuilding)
  {
    notes.push_back({"unit", "metres",
                     "the model is " + size + ", larger than buildings: expected --unit mm, or " +
                         "\"scale\": 0.001 beside \"file\", if it is in millimetres"});
  }
  else if (extent.longest() > 0.0 && extent.longest() < LeastModel)
  {
    notes.push_back({"unit", "metres",
                     "the model is " + size + ", smaller than furniture: expected --unit, or " +
                         "\"scale\" beside \"file\", if it is not in metres"});
  }
}
}  // namespace

const Material* findMaterial(const JsonCursor& surface, const Materials& materials)
{
  const auto node = surface.find("material");
  if (!node)
  {
    return nullptr;
  }
  const auto found = materials.find(node->string());
  if (found == materials.end())
  {
    node->failExpected("the name of one of \"materials\"");
  }
  return &found->second;
}

Mesh readSurfaceFile(const JsonCursor& node, const Materials& materials, const Material* material,
                     const std::string& folder, Notes& notes)
{
  const JsonCursor file = node.at("file");
  const std::string path = resolvePath(folder, file.string(), notes);
  const Transform place = readPlace(node, path);
  if (isGltfFile(path))
  {
    const Model model = readModelFile(file, path, {place, &materials, material});
    notes.insert(notes.end(), model.approximations.begin(), model.approximations.end());
    return join(model);
  }
  Mesh mesh = readMeshFile(file, path, materials, material, notes);
  for (Vector3& point : mesh.points)
  {
    point = place.point(point);
  }
  return mesh;
}

void addModel(const JsonCursor& node, const Materials& materials, const std::string& folder,
              std::set<std::string>& names, SceneSurfaces& surfaces)
{
  node.checkKeys({"file", "material", "scale", "up", "lights", "cameras"});
  const JsonCursor file = node.at("file");
  Notes& notes = surfaces.approximations;
  const std::string path = resolvePath(folder, file.string(), notes);
  Model model = readModelFile(file, path, {readPlace(node, path), &materials, findMaterial(node, materials)});
  const Extent extent = extentOf(model);
  for (ModelPart& part : model.parts)
  {
    const std::string name = freeName(part.name, "surface", names);
    surfaces.all.push_back({name, node.where() + "." + name, std::move(part.polygons)});
  }
  const auto wanted = [&node](const char* key) { return !node.has(key) || node.at(key).boolean(); };
  if (wanted("lights"))
  {
    surfaces.lights.insert(surfaces.lights.end(), model.lights.begin(), model.lights.end());
  }
  if (wanted("cameras"))
  {
    surfaces.cameras.insert(surfaces.cameras.end(), model.cameras.begin(), model.cameras.end());
  }
  tellAxes(node, path, extent, notes);
  if (!node.has("scale"))
  {
    tellUnit(extent, notes);
  }
  notes.insert(notes.end(), model.approximations.begin(), model.approximations.end());
  surfaces.hasModel = true;
}
}  // namespace kalos::scene
