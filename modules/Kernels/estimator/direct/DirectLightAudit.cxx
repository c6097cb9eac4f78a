// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/DirectLightAudit.h"

#include <iomanip>
#include <sstream>

namespace kalos
{
namespace
{
AuditLine auditOpenings(const std::vector<Luminaire>& luminaires, const std::vector<Sensor>& sensors)
{
  std::size_t openings = 0, areas = 0;
  std::vector<char> near(sensors.size(), 0);
  for (const Luminaire& l : luminaires)
  {
    if (!l.isOpening())
      continue;
    bool area = false;
    for (std::size_t r = 0; r < sensors.size(); ++r)
      if (isNear(l, sensors[r].position))
      {
        area = true;
        near[r] = 1;
      }
    ++openings;
    areas += area;
  }
  const auto receivers = std::count(near.begin(), near.end(), 1);
  const std::string far = areas == openings ? "" : std::to_string(openings - areas) + " as points, exact";
  const std::string close = areas == 0 ? ""
                                       : std::to_string(areas) + " as areas to " + std::to_string(receivers) + " of " +
                                             std::to_string(sensors.size()) + " receivers, else points";
  return {"luminous openings", far + (far.empty() || close.empty() ? "" : "; ") + close,
          "a receiver closer than 5 times its larger side sees the extent of an opening"};
}

AuditLine auditMirrors(const MirrorImages& mirrors)
{
  std::ostringstream left;
  left << "omitted chains of mirrors between a point and a receiver reflect at most " << std::setprecision(2)
       << 100 * mirrors.leftOut() << " % together";
  if (mirrors.truncated())
    return {"warning",
            "mirrors face each other too often: point luminaires have more than " +
                std::to_string(MirrorImages::mostImages) + " images",
            "further ones are left out, so that values are too low and no error is to be trusted; a small luminous "
            "rectangle instead of a point is found by gather rays in any number of mirrors"};
  return {"point luminaires in mirrors", std::to_string(mirrors.size()) + " images, exact",
          mirrors.leftOut() > 0 ? left.str() : "every chain of mirrors is followed"};
}

AuditLine auditMeshes(std::uint32_t triangles, EmittingMeshes meshes)
{
  const std::string count = std::to_string(triangles);
  switch (meshes)
  {
    case EmittingMeshes::ClosedForms:
      return {"emitting triangles", count + ", polygon formula", "only what hides it is sampled"};
    case EmittingMeshes::MetByPaths:
      return {"emitting triangles", count + ", met by paths", "paths from the receivers find all light"};
    case EmittingMeshes::SampledAsRequested:
      return {"emitting triangles", count + ", trajectory starts", "as requested"};
    case EmittingMeshes::TooMany:
      break;
  }
  return {"emitting triangles", count + ", trajectory starts", "too many for a closed form at every receiver"};
}
}  // namespace

std::vector<AuditLine> auditDirectLight(const DirectLightChoices& choices)
{
  std::vector<AuditLine> lines;
  if (choices.needs.unoccluded)
    lines.push_back({"shadow rays", "none", "the room is convex and empty: nothing can stand between two points"});
  else
    lines.push_back({"shadow rays", "traced", "surfaces may stand between two points"});
  const std::vector<Luminaire>& luminaires = choices.scene.data().luminaires;
  const auto points =
      std::count_if(luminaires.begin(), luminaires.end(), [](const Luminaire& l) { return l.isPoint(); });
  if (points)
    lines.push_back({"point luminaires", std::to_string(points) + ", exact", "their direct light has a closed form"});
  const auto openings =
      std::count_if(luminaires.begin(), luminaires.end(), [](const Luminaire& l) { return l.isOpening(); });
  if (openings)
    lines.push_back(auditOpenings(luminaires, choices.sensors));
  if (static_cast<std::size_t>(points + openings) < luminaires.size())
    lines.push_back({"luminous rectangles", std::to_string(luminaires.size() - points - openings) + ", polygon formula",
                     "only what hides it is sampled"});
  if (choices.mirrors.any())
    lines.push_back(auditMirrors(choices.mirrors));
  if (choices.needs.emittingTriangles)
    lines.push_back(auditMeshes(choices.needs.emittingTriangles, choices.meshes));
  return lines;
}
}  // namespace kalos
