// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/quantities/LostLuminaires.h"

#include <algorithm>
#include <map>

#include "estimator/tally/ProbeRays.h"

namespace kalos
{
namespace
{
constexpr std::size_t mostReceivers = 64, mostLost = 8;
constexpr int rays = 32, reflections = 4;

bool isInRoom(const Scene& scene, const RayAnchor& receiver)
{
  const Frame frame(receiver.normal);
  for (int i = 0; i < rays; ++i)
  {
    const SurfacePoint y = scene.trace(receiver, probeDirection(frame, i));
    if (!y.valid || !y.front)
      return false;
  }
  return true;
}

std::vector<RayAnchor> someOf(const Scene& scene, const Receivers& receivers, const std::vector<char>& valid)
{
  const bool anyValid = std::find(valid.begin(), valid.end(), 1) != valid.end();
  std::vector<std::size_t> places;
  for (std::size_t r = 0; r < valid.size(); ++r)
    if (valid[r] || !anyValid)
      places.push_back(r);
  const std::size_t tested = std::min(places.size(), mostReceivers);
  std::vector<RayAnchor> some;
  for (std::size_t i = 0; i < tested; ++i)
  {
    const std::size_t r = places[i * places.size() / tested];
    const RayAnchor here = placeReceiver(scene, receivers.points[r] - scene.origin(), receivers.normals[r]);
    if (anyValid || isInRoom(scene, here))
      some.push_back(here);
  }
  return some;
}

bool reachesOne(const Scene& scene, const RayAnchor& from, const std::vector<RayAnchor>& receivers)
{
  return std::any_of(receivers.begin(), receivers.end(),
                     [&](const RayAnchor& r) { return !scene.rays().occluded(from, r); });
}

// Whether light of a luminaire gets to a receiver; else `ends` counts, by surfaces, where its rays end.
bool isSeen(const Scene& scene, std::size_t luminaire, const std::vector<RayAnchor>& receivers,
            std::map<std::size_t, int>& ends)
{
  const RayAnchor& lamp = scene.luminaireAnchor(luminaire);
  if (reachesOne(scene, lamp, receivers))
    return true;
  for (int i = 0; i < rays; ++i)
  {
    double u1, u2;
    sobolPoint(1, static_cast<std::uint32_t>(i), u1, u2);
    SurfacePoint y = scene.trace(lamp, sampleDirection(scene.data().luminaires[luminaire], u1, u2));
    if (y.valid)
      ++ends[scene.surface(y.triangle)];
    for (int k = 0; y.valid && k <= reflections; ++k)
    {
      const RayAnchor here = scene.anchor(y);
      if (reachesOne(scene, here, receivers))
        return true;
      y = scene.trace(here, probeDirection(Frame(y.normal), i + k));
    }
  }
  return false;
}

std::string nameOf(const Scene& scene, std::size_t luminaire)
{
  const auto& names = scene.data().luminaireNames;
  return luminaire < names.size() && !names[luminaire].empty() ? names[luminaire]
                                                               : "number " + std::to_string(luminaire);
}
}  // namespace

std::vector<AuditLine> findLostLuminaires(const Scene& scene, const Receivers& receivers,
                                          const std::vector<char>& valid)
{
  std::vector<AuditLine> lost;
  const std::vector<RayAnchor> some = someOf(scene, receivers, valid);
  if (some.empty() || scene.data().triangles.empty())
    return lost;
  for (std::size_t i = 0; i < scene.data().luminaires.size() && lost.size() < mostLost; ++i)
  {
    std::map<std::size_t, int> ends;
    if (!(scene.data().luminaires[i].flux > 0) || isSeen(scene, i, some, ends))
      continue;
    const auto most =
        std::max_element(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    lost.push_back({"warning", "no light of luminaire " + nameOf(scene, i) + " gets to a receiver",
                    ends.empty() ? "it shines away from all surfaces"
                                 : std::to_string(most->second) + " of " + std::to_string(rays) +
                                       " of its rays end on " + scene.surfaceName(most->first) +
                                       ": it is above a ceiling, in a closed housing or outside of the room"});
  }
  return lost;
}
}  // namespace kalos
