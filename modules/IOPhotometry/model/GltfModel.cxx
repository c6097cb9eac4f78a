// SPDX-License-Identifier: BSD-3-Clause
#include "GltfModel.h"

#include <algorithm>
#include <cmath>

#include "../base/NoteCounter.h"
#include "../gltf/GltfFile.h"
#include "../gltf/GltfLights.h"
#include "../gltf/GltfMaterials.h"
#include "../gltf/GltfMeshes.h"

namespace kalos::scene
{
namespace
{
/** Walks the nodes of a scene and gathers what hangs on them. */
class Walk
{
public:
  Walk(const GltfFile& file, const ModelUse& use, Model& model)
      : File(file), Use(use), Result(model), Meshes(file, model.Approximations), Found(model.Approximations)
  {
    this->Palette = ReadGltfMaterials(file, *use.Overrides, model.Approximations);
    this->Unnamed = static_cast<std::int32_t>(this->Palette.size());
    Material plain;
    plain.Reflectance = {UnnamedReflectance};
    this->Palette.push_back(use.Fallback ? *use.Fallback : plain);
  }

  void Run(const std::vector<JsonCursor>& roots)
  {
    this->Visited.resize(this->File.Section("nodes").size());
    this->Push(roots, this->Use.Place);
    while (!this->Work.empty())
    {
      const auto [index, world] = this->Work.back();
      this->Work.pop_back();
      this->Visit(this->File.Section("nodes")[index], world);
    }
  }

private:
  void Push(const std::vector<JsonCursor>& numbers, const Transform& parent)
  {
    for (auto number = numbers.rbegin(); number != numbers.rend(); ++number)
    {
      const std::size_t index = this->File.Index(*number, "nodes");
      if (this->Visited[index])
      {
        number->Fail("node " + std::to_string(index) + " is met twice; expected a tree");
      }
      this->Visited[index] = true;
      this->Work.emplace_back(index, parent * ReadNodeTransform(this->File.Section("nodes")[index]));
    }
  }

  void Visit(const JsonCursor& node, const Transform& world)
  {
    if (node.Has("mesh"))
    {
      this->AddPart(node, world);
    }
    if (const auto light = ReadGltfLight(this->File, node, world, this->Found))
    {
      this->Result.Lights.push_back(*light);
    }
    if (const auto camera = ReadGltfCamera(this->File, node, world, this->Found))
    {
      this->Result.Cameras.push_back(*camera);
    }
    if (const auto children = node.Find("children"))
    {
      this->Push(children->Items(), world);
    }
  }

  void AddPart(const JsonCursor& node, const Transform& world)
  {
    const GltfMesh& source = this->Meshes.Read(node.At("mesh"));
    ModelPart part;
    for (const JsonCursor& named : {node, this->File.Element(node.At("mesh"), "meshes")})
    {
      const auto name = named.Find("name");
      part.Name = part.Name.empty() && name ? name->String() : part.Name;
    }
    if (node.Has("skin"))
    {
      this->Found.Count("skinned meshes", part.Name, "in their resting pose", "nothing moves here");
    }
    const std::vector<Transform> instances = ReadInstances(this->File, node);
    this->Count += instances.size() * std::max(source.Triangles.size(), source.Points.size() / 3);
    if (this->Count > MaximumTriangles)
    {
      node.Fail("too many triangles over all instances; expected at most " + std::to_string(MaximumTriangles));
    }
    for (const Transform& instance : instances)
    {
      this->AddTriangles(source, world * instance, part);
    }
    if (part.Polygons.NumberOfPolygons() > 0)
    {
      part.Polygons.TakeMaterials(this->Palette);
      this->Result.Parts.push_back(std::move(part));
    }
  }

  void AddTriangles(const GltfMesh& source, const Transform& map, ModelPart& part)
  {
    Mesh& mesh = part.Polygons;
    const auto first = static_cast<std::int64_t>(mesh.Points.size());
    for (const Vector3& point : source.Points)
    {
      mesh.Points.push_back(map.Point(point));
    }
    const bool turned = map.Mirrors();
    bool plain = false;
    for (std::size_t t = 0; t < source.Triangles.size(); ++t)
    {
      const auto& [a, b, c] = source.Triangles[t];
      const std::int32_t material = source.MaterialOf[t];
      plain = plain || material < 0;
      mesh.AddPolygon({first + a, first + (turned ? c : b), first + (turned ? b : c)},
                      material < 0 ? this->Unnamed : material);
    }
    if (plain && !this->Use.Fallback)
    {
      this->Found.Count(UnnamedSubject, part.Name, UnnamedChoice, UnnamedReason);
    }
  }

  const GltfFile& File;
  const ModelUse& Use;
  Model& Result;
  GltfMeshes Meshes;
  NoteCounter Found;
  std::vector<Material> Palette;
  std::int32_t Unnamed = 0;
  std::vector<bool> Visited;
  std::vector<std::pair<std::size_t, Transform>> Work;
  std::size_t Count = 0;
};

/** The numbers of the root nodes: of the default scene, or of the first. */
std::vector<JsonCursor> Roots(const GltfFile& file)
{
  const auto scene = file.Root().Find("scene");
  const std::vector<JsonCursor>& scenes = file.Section("scenes");
  if (!scene && scenes.empty())
  {
    file.Root().Fail("no scenes; expected one, as a library of meshes has no place for them");
  }
  const JsonCursor& chosen = scene ? file.Element(*scene, "scenes") : scenes.front();
  const auto nodes = chosen.Find("nodes");
  return nodes ? nodes->Items() : std::vector<JsonCursor>();
}
}  // namespace

Model ReadGltfModel(const std::string& path, const ModelUse& use)
{
  Model model;
  const GltfFile file(path, model.Approximations);
  Walk(file, use, model).Run(Roots(file));
  return model;
}
}  // namespace kalos::scene
