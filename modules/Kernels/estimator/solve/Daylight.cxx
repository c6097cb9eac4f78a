// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Daylight.h"

#include <iomanip>
#include <sstream>

#include "scene/Placement.h"

namespace kalos
{
namespace
{
constexpr std::size_t mostReceivers = 4096;  // that rays are sent from

std::string number(double value, int digits = 3)
{
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}
}  // namespace

SkyOpenings findOpenings(const Scene& scene, const Receivers& receivers, const Settings& settings)
{
  if (!scene.data().sky)
    return {};
  const std::size_t count = std::min(receivers.points.size(), mostReceivers);
  std::vector<RayAnchor> anchors;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t r = i * receivers.points.size() / count;
    anchors.push_back(placeReceiver(scene, receivers.points[r] - scene.origin(), receivers.normals[r]));
  }
  return SkyOpenings(scene, anchors, settings.walks());
}

std::vector<AuditLine> auditDaylight(const Scene& scene, const SkyOpenings& openings)
{
  if (!scene.data().sky)
    return {};
  const Sky& sky = *scene.data().sky;
  std::string light = number(sky.horizontalIlluminance(), 6) + " lx on the horizontal";
  if (sky.hasSun())
    light += ", sun " + number(sky.sunIlluminance(), 6) + " lx across its rays";
  std::vector<AuditLine> lines{{"sky", light,
                                sky.groundReflectance() > 0
                                    ? "the ground below the horizon has " + number(sky.groundLuminance()) + " cd/m2"
                                    : "the ground below the horizon is black"}};
  if (openings.followed() == 0)
    return lines;
  if (openings.isOutdoors())
    lines.push_back({"openings", "none needed", "most of what the receivers see is sky"});
  if (openings.escaped() == 0)
    lines.push_back({"warning", "no sky enters the room",
                     "none of " + std::to_string(openings.followed()) +
                         " paths from the receivers left the scene; expected an opening or glass"});
  double area = 0;
  std::string shares;
  for (const SkyOpenings::Rectangle& r : openings.all())
  {
    area += r.area;
    const Vec3 centre = r.corner + 0.5 * (r.u + r.v) + scene.origin();
    shares += (shares.empty() ? "" : "; ") + number(length(r.u)) + " x " + number(length(r.v)) + " m at (" +
              number(centre.x) + ", " + number(centre.y) + ", " + number(centre.z) + ") lets in " +
              number(100 * r.rays) + " %";
  }
  if (openings.any())
    lines.push_back({"openings", std::to_string(openings.all().size()) + ", " + number(area) + " m2",
                     shares + " of the " + std::to_string(openings.escaped()) +
                         " rays that left the scene; light that enters elsewhere is found with more noise"});
  return lines;
}
}  // namespace kalos
