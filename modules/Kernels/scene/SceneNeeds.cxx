// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneNeeds.h"

namespace kalos
{
namespace
{
constexpr double largestHullSearch = 2e7;  // pairs of a triangle and a point

// Range of the signed distances of points to a plane.
struct Sides
{
  double low = 0, high = 0;
  void include(double distance)
  {
    this->low = std::min(this->low, distance);
    this->high = std::max(this->high, distance);
  }
  bool oneSided(double tolerance) const { return this->low > -tolerance || this->high < tolerance; }
};

bool nothingOccludes(const Scene& scene, const std::vector<Vec3>& receivers)
{
  const SceneDescription& data = scene.data();
  if (static_cast<double>(data.triangles.size()) * static_cast<double>(data.points.size() + receivers.size()) >
      largestHullSearch)
    return false;
  const double tolerance = 1e-6 * scene.size();
  std::vector<char> used(data.points.size(), 0);
  for (const Triangle& t : data.triangles)
    for (auto corner : t)
      used[corner] = 1;
  for (std::uint32_t t = 0; t < data.triangles.size(); ++t)
  {
    const Vec3 a = scene.corner(t, 0), n = scene.normal(t);
    Sides sides;
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (used[i])
        sides.include(dot(data.points[i] - a, n));
    for (const Luminaire& l : data.luminaires)
      for (int corner = 0; corner < 4; ++corner)
        sides.include(dot(l.position + ((corner & 1) - 0.5) * l.sideU + ((corner >> 1) - 0.5) * l.sideV - a, n));
    for (const Vec3& r : receivers)
      sides.include(dot(r - a, n));
    if (!sides.oneSided(tolerance))
      return false;
  }
  return true;
}
}  // namespace

bool reflects(const Scene& scene)
{
  const auto& materials = scene.data().materials;
  return std::any_of(materials.begin(), materials.end(), [&](const Material& m) {
    return photometric(m.reflectance, scene.bands()) > 0 || m.specular > 0 || m.mirror > 0;
  });
}

SceneNeeds findNeeds(const Scene& scene, const std::vector<Vec3>& receivers)
{
  SceneNeeds needs;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    needs.emittingTriangles += photometric(scene.material(t).exitance, scene.bands()) > 0;
  needs.reflects = reflects(scene);
  needs.unoccluded = nothingOccludes(scene, receivers);
  return needs;
}
}  // namespace kalos
