// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/OverlapAudit.h"

#include <sstream>

namespace kalos
{
namespace
{
constexpr std::size_t most = 8;  // pairs that are named
constexpr const char* rule =
    "a face is seen from its own side before another's back; else a luminous face lies on top, else the later in the "
    "scene";

// As messages name a face: its surface and its material.
std::string nameOf(const Scene& scene, std::uint32_t triangle)
{
  const Material& m = scene.material(triangle);
  std::ostringstream name;
  name << scene.surfaceName(scene.surface(triangle)) << " (reflectance " << photometric(m.reflectance, scene.bands());
  const double exitance = photometric(m.exitance, scene.bands());
  if (exitance > 0)
    name << ", exitance " << exitance << " lm/m2";
  if (m.specular > 0)
    name << ", specular " << m.specular;
  if (m.mirror > 0)
    name << ", mirror " << m.mirror;
  name << ")";
  return name.str();
}

// Whether one of the two surfaces encloses the place on one side, and so hides what of the other lies there.
bool isStanding(const Scene& scene, const Overlap& overlap)
{
  for (const std::uint32_t t : {overlap.above, overlap.below})
  {
    const Vec3& n = scene.normal(t);
    const SurfacePoint met = scene.trace(scene.anchor(t, overlap.middle, -n), -n);
    if (met.valid && !met.front && scene.surface(met.triangle) == scene.surface(t))
      return true;
  }
  return false;
}
}  // namespace

std::vector<AuditLine> auditOverlaps(const Scene& scene)
{
  std::vector<AuditLine> lines;
  const std::vector<Overlap>& overlaps = scene.overlaps();
  for (std::size_t i = 0; i < std::min(most, overlaps.size()); ++i)
  {
    const Overlap& one = overlaps[i];
    std::ostringstream choice;
    choice << nameOf(scene, one.above) << (one.backToBack ? " and " : " lies on ") << nameOf(scene, one.below)
           << (one.backToBack ? " lie back to back over " : " over ") << one.area << " m2";
    const bool warns = !one.backToBack || !isStanding(scene, one);
    lines.push_back(
        {warns ? "warning" : "overlapping faces", choice.str(), std::string("their faces are in one plane: ") + rule});
  }
  double rest = 0;
  for (std::size_t i = most; i < overlaps.size(); ++i)
    rest += overlaps[i].area;
  if (rest > 0)
  {
    std::ostringstream choice;
    choice << overlaps.size() - most << " further pairs of materials lie in one plane over " << rest << " m2";
    lines.push_back({"overlapping faces", choice.str(), rule});
  }
  return lines;
}
}  // namespace kalos
