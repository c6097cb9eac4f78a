// SPDX-License-Identifier: BSD-3-Clause
#include "GltfModel.h"

#include <algorithm>
#include <cmath>
#include <map>

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
      : File(file), Use(use), Result(model), Meshes(file, model.approximations), Found(model.approximations)
  {
    this->Sources = readGltfMaterials(file, *use.overrides, model.approximations);
    for (const GltfMaterial& source : this->Sources)
    {
      this->Palette.push_back(source.material);
    }
    this->Unnamed = static_cast<std::int32_t>(this->Palette.size());
    Material plain;
    plain.reflectance = {UnnamedReflectance};
    this->Palette.push_back(use.fallback ? *use.fallback : plain);
  }

  void run(const std::vector<JsonCursor>& roots)
  {
    this->Visited.resize(this->File.section("nodes").size());
    this->push(roots, this->Use.place);
    while (!this->Work.empty())
    {
      const auto [index, world] = this->Work.back();
      this->Work.pop_back();
      this->visit(this->File.section("nodes")[index], world);
    }
  }

private:
  void push(const std::vector<JsonCursor>& numbers, const Transform& parent)
  {
    for (auto number = numbers.rbegin(); number != numbers.rend(); ++number)
    {
      const std::size_t index = this->File.index(*number, "nodes");
      if (this->Visited[index])
      {
        number->fail("node " + std::to_string(index) + " is met twice; expected a tree");
      }
      this->Visited[index] = true;
      this->Work.emplace_back(index, parent * readNodeTransform(this->File.section("nodes")[index]));
    }
  }

  /** Whether KHR_node_visibility hides the node and its children. */
  bool isHidden(const JsonCursor& node)
  {
    const auto extensions = node.find("extensions");
    const auto holder = extensions ? extensions->find("KHR_node_visibility") : std::nullopt;
    const auto visible = holder ? holder->find("visible") : std::nullopt;
    if (!visible || visible->boolean())
    {
      return false;
    }
    this->Found.count("hidden nodes", node.has("name") ? node.at("name").string() : node.where(), "left out",
                      "with all that hangs on them");
    return true;
  }

  void visit(const JsonCursor& node, const Transform& world)
  {
    if (this->isHidden(node))
    {
      return;
    }
    if (node.has("mesh"))
    {
      this->addPart(node, world);
    }
    if (const auto light = readGltfLight(this->File, node, world, this->Found))
    {
      this->Result.lights.push_back(*light);
    }
    if (const auto camera = readGltfCamera(this->File, node, world, this->Found))
    {
      this->Result.cameras.push_back(*camera);
    }
    if (const auto children = node.find("children"))
    {
      this->push(children->items(), world);
    }
  }

  void addPart(const JsonCursor& node, const Transform& world)
  {
    const GltfMesh& source = this->Meshes.read(node.at("mesh"));
    ModelPart part;
    for (const JsonCursor& named : {node, this->File.element(node.at("mesh"), "meshes")})
    {
      const auto name = named.find("name");
      part.name = part.name.empty() && name ? name->string() : part.name;
    }
    if (node.has("skin"))
    {
      this->Found.count("skinned meshes", part.name, "in their resting pose", "nothing moves here");
    }
    const std::vector<Transform> instances = readInstances(this->File, node);
    this->Count += instances.size() * std::max(source.triangles.size(), source.points.size() / 3);
    if (this->Count > MaximumTriangles)
    {
      node.fail("too many triangles over all instances; expected at most " + std::to_string(MaximumTriangles));
    }
    for (const Transform& instance : instances)
    {
      this->addTriangles(source, world * instance, part);
    }
    if (part.polygons.numberOfPolygons() > 0)
    {
      part.polygons.takeMaterials(this->Palette);
      this->Result.parts.push_back(std::move(part));
    }
  }

  void addTriangles(const GltfMesh& source, const Transform& map, ModelPart& part)
  {
    Mesh& mesh = part.polygons;
    const auto first = static_cast<std::int64_t>(mesh.points.size());
    for (const Vector3& point : source.points)
    {
      mesh.points.push_back(map.point(point));
    }
    const bool turned = map.mirrors();
    bool plain = false;
    for (std::size_t t = 0; t < source.triangles.size(); ++t)
    {
      const auto& [a, b, c] = source.triangles[t];
      const std::int32_t material = source.materialOf[t];
      const bool colored = !source.colorOf.empty();
      plain = plain || (material < 0 && !colored);
      const std::int32_t number = colored        ? this->coloredNumber(material, source.colorOf[t])
                                  : material < 0 ? this->Unnamed
                                                 : material;
      const std::int64_t second = first + (turned ? c : b), third = first + (turned ? b : c);
      mesh.addPolygon({first + a, second, third}, number);
      if (material >= 0 && this->Sources[material].emitsOnBothSides)
      {
        mesh.addPolygon({first + a, third, second}, number);
      }
    }
    if (plain && !this->Use.fallback)
    {
      this->Found.count(UnnamedSubject, part.name, UnnamedChoice, UnnamedReason);
    }
  }

  /** The index in Palette of a material times a vertex colour; without a material the colour is the reflectance. */
  std::int32_t coloredNumber(std::int32_t material, const std::array<double, 3>& color)
  {
    const auto [known, added] =
        this->Colored.emplace(std::make_pair(material, color), static_cast<std::int32_t>(this->Palette.size()));
    if (added)
    {
      MetallicRoughness plain;
      plain.metallic = 0.0;
      GltfMaterial source{this->Palette[this->Unnamed], {}};
      source.source = this->Use.fallback ? std::nullopt : std::optional<MetallicRoughness>(plain);
      this->Palette.push_back(multiplyBaseColor(material < 0 ? source : this->Sources[material], color));
    }
    return known->second;
  }

  const GltfFile& File;
  const ModelUse& Use;
  Model& Result;
  GltfMeshes Meshes;
  NoteCounter Found;
  std::vector<GltfMaterial> Sources;
  std::vector<Material> Palette;
  std::map<std::pair<std::int32_t, std::array<double, 3>>, std::int32_t> Colored;
  std::int32_t Unnamed = 0;
  std::vector<bool> Visited;
  std::vector<std::pair<std::size_t, Transform>> Work;
  std::size_t Count = 0;
};

/** The numbers of the root nodes: of the default scene, or of the first. */
std::vector<JsonCursor> roots(const GltfFile& file)
{
  const auto scene = file.root().find("scene");
  const std::vector<JsonCursor>& scenes = file.section("scenes");
  if (!scene && scenes.empty())
  {
    file.root().fail("no scenes; expected one, as a library of meshes has no place for them");
  }
  const JsonCursor& chosen = scene ? file.element(*scene, "scenes") : scenes.front();
  const auto nodes = chosen.find("nodes");
  return nodes ? nodes->items() : std::vector<JsonCursor>();
}
}  // namespace

Model readGltfModel(const std::string& path, const ModelUse& use)
{
  Model model;
  const GltfFile file(path, model.approximations);
  file.tellExtensions(model.approximations);
  Walk(file, use, model).run(roots(file));
  return model;
}
}  // namespace kalos::scene
