// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Audit.h"

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

Audit auditScene(const Scene& scene, const std::vector<Vec3>& receivers)
{
  Audit audit;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    audit.emittingTriangles += photometric(scene.material(t).exitance, scene.bands()) > 0;
  for (const Material& m : scene.data().materials)
    audit.reflects = audit.reflects || photometric(m.reflectance, scene.bands()) > 0 || m.specular > 0 || m.mirror > 0;
  audit.unoccluded = nothingOccludes(scene, receivers);
  return audit;
}
}  // namespace kalos
