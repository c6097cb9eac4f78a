// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/DarkReceivers.h"

#include <algorithm>
#include <sstream>

#include "estimator/ProbeRays.h"

namespace kalos
{
namespace
{
constexpr double rounding = 1e-12;
constexpr std::size_t mostLookedAt = 4096, mostEmitters = 64;
constexpr int rays = 32;

// `values`, or so many of them evenly spread.
template <class T>
std::vector<T> thinned(std::vector<T> values, std::size_t most)
{
  if (values.size() <= most)
    return values;
  std::vector<T> some;
  for (std::size_t i = 0; i < most; ++i)
    some.push_back(values[i * values.size() / most]);
  return some;
}

// A point of something that shines.
struct Emitter
{
  RayAnchor anchor;
  bool oneSided = false;  // a triangle, which shines on the side of its normal only
  Vec3 normal;
};

std::vector<Emitter> emitters(const Scene& scene)
{
  std::vector<Emitter> points;
  for (std::size_t i = 0; i < scene.data().luminaires.size(); ++i)
    if (scene.data().luminaires[i].flux > 0)
      points.push_back({scene.luminaireAnchor(i), false, {}});
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
    {
      const Vec3 centre = (1.0 / 3) * (scene.corner(t, 0) + scene.corner(t, 1) + scene.corner(t, 2));
      points.push_back({scene.anchor(t, centre, scene.normal(t)), true, scene.normal(t)});
    }
  return thinned(std::move(points), mostEmitters);
}

bool seesOne(const Scene& scene, const RayAnchor& from, const std::vector<Emitter>& emitters)
{
  return std::any_of(emitters.begin(), emitters.end(), [&](const Emitter& e) {
    const Vec3 d = from.point - e.anchor.point;
    const bool front = !e.oneSided || dot(e.normal, d) > 1e-6 * length(d);
    return front && !scene.rays().occluded(from, e.anchor);
  });
}

bool hasLightInSight(const Scene& scene, const RayAnchor& here, const std::vector<Emitter>& emitters)
{
  if (seesOne(scene, here, emitters))
    return true;
  const Frame frame(here.normal);
  for (int i = 0; i < rays; ++i)
  {
    const SurfacePoint y = scene.trace(here, probeDirection(frame, i));
    if (y.valid && seesOne(scene, scene.anchor(y), emitters))
      return true;
  }
  return false;
}
}  // namespace

std::vector<AuditLine> auditDarkReceivers(const Scene& scene, const Receivers& receivers, const Result& result)
{
  const std::vector<double>& values = result.illuminance;
  if (values.empty())
    return {};
  const double dark = rounding * *std::max_element(values.begin(), values.end());
  std::vector<std::size_t> found;
  for (std::size_t r = 0; r < values.size(); ++r)
    if (values[r] <= dark)
      found.push_back(r);
  if (found.empty())
    return {};
  const std::vector<Emitter> shining = emitters(scene);
  if (shining.empty())
    return {};

  const std::vector<std::size_t> some = thinned(found, mostLookedAt);
  std::vector<std::size_t> cutOff;
  for (const std::size_t r : some)
  {
    const Vec3 p = receivers.points[r] - scene.origin();
    if (!hasLightInSight(scene, placeReceiver(scene, p, receivers.normals[r]), shining))
      cutOff.push_back(r);
  }
  const std::string looked =
      some.size() < found.size() ? " of the " + std::to_string(some.size()) + " that were looked at" : "";
  std::vector<AuditLine> lines{
      {"dark receivers", std::to_string(found.size()) + " of " + std::to_string(values.size()),
       std::to_string(some.size() - cutOff.size()) + looked + " are in full shadow or turned away from the light"}};
  if (!cutOff.empty())
  {
    const Vec3& p = receivers.points[cutOff.front()];
    std::ostringstream reason;
    reason << "0 lx there: outside of a closed room, below a floor or inside a solid? The first is number "
           << cutOff.front() << " at (" << p.x << ", " << p.y << ", " << p.z << ")";
    lines.push_back(
        {"warning", "receivers with nothing lit in sight: " + std::to_string(cutOff.size()) + looked, reason.str()});
  }
  return lines;
}
}  // namespace kalos
