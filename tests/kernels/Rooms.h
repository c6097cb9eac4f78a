// SPDX-License-Identifier: BSD-3-Clause
// Scenes that several tests share.
#ifndef Rooms_h
#define Rooms_h

#include "scene/Scene.h"

namespace rooms
{
using kalos::Vec3;

inline std::uint32_t addMaterial(kalos::SceneDescription& scene, double reflectance, double exitance = 0)
{
  kalos::Material material;
  material.reflectance = kalos::uniformBands(reflectance);
  material.exitance = kalos::uniformBands(exitance);
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline void addQuad(kalos::SceneDescription& scene, const Vec3& origin, const Vec3& u, const Vec3& v,
                    std::uint32_t material)
{
  const auto first = static_cast<std::uint32_t>(scene.points.size());
  for (const Vec3& p : {origin, origin + u, origin + u + v, origin + v})
    scene.points.push_back(p);
  scene.triangles.push_back({first, first + 1, first + 2});
  scene.triangles.push_back({first, first + 2, first + 3});
  scene.triangleMaterial.insert(scene.triangleMaterial.end(), 2, material);
}

/// Six quads; normals point inwards, or outwards for a piece of furniture.
inline void addBox(kalos::SceneDescription& scene, const Vec3& low, const Vec3& size, std::uint32_t material,
                   bool inwards)
{
  const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z}, high = low + size;
  auto face = [&](const Vec3& origin, const Vec3& u, const Vec3& v) {
    inwards ? addQuad(scene, origin, u, v, material) : addQuad(scene, origin, v, u, material);
  };
  face(low, x, y);
  face(low, y, z);
  face(low, z, x);
  face(high, -y, -x);
  face(high, -z, -y);
  face(high, -x, -z);
}

/// A room of side 5 m from the origin, all of one reflectance, with a point luminaire under the ceiling's centre.
inline kalos::SceneDescription litRoom(double reflectance, double flux = 10000)
{
  kalos::SceneDescription scene;
  addBox(scene, {0, 0, 0}, {5, 5, 5}, addMaterial(scene, reflectance), true);
  kalos::Luminaire lamp;
  lamp.position = {2.5, 2.5, 4.999};
  lamp.flux = flux;
  scene.luminaires.push_back(lamp);
  return scene;
}

/// A closed room with two boxes standing in it, where E = exitance / (1 - reflectance) at every point.
inline kalos::SceneDescription furnace(double reflectance, double exitance)
{
  kalos::SceneDescription scene;
  const auto material = addMaterial(scene, reflectance, exitance);
  addBox(scene, {0, 0, 0}, {5, 5, 5}, material, true);
  addBox(scene, {1, 1, 0}, {1.2, 1.4, 1.5}, material, false);
  addBox(scene, {3, 2.4, 0}, {1.1, 1, 3}, material, false);
  return scene;
}

/// The same room with its boxes, lit from a point instead of glowing.
inline kalos::SceneDescription furnishedRoom(double reflectance)
{
  kalos::SceneDescription scene = furnace(reflectance, 0);
  scene.luminaires = litRoom(reflectance).luminaires;
  return scene;
}

inline void translate(kalos::SceneDescription& scene, const Vec3& by)
{
  for (Vec3& p : scene.points)
    p += by;
  for (kalos::Luminaire& l : scene.luminaires)
    l.position += by;
}
}  // namespace rooms

#endif
