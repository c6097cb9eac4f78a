// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Panes.h"

namespace kalos
{
std::vector<Triangle> collapsed(const std::vector<Triangle>& triangles,
                                const std::vector<std::shared_ptr<const Glass>>& glass, bool panesOnly)
{
  std::vector<Triangle> kept = triangles;
  for (std::size_t t = 0; t < glass.size(); ++t)
    if ((glass[t] != nullptr) != panesOnly)
      kept[t] = {kept[t][0], kept[t][0], kept[t][0]};
  return kept;
}

Panes::Panes(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
             std::vector<std::shared_ptr<const Glass>> glass)
    : Of(std::move(glass)), Rays(points, collapsed(triangles, this->Of, true))
{
  for (const Triangle& t : triangles)
    this->Normals.push_back(normalized(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])));
}

bool Panes::reflects() const
{
  return std::any_of(this->Of.begin(), this->Of.end(), [](const auto& glass) { return glass && glass->reflects(); });
}

double Panes::transmittance(const RayAnchor& a, const RayAnchor& b) const
{
  const Vec3 from = a.liftedFor(b.point), to = b.liftedFor(a.point), way = normalized(to - from);
  double through = 1;
  this->Rays.crossings(from, to, [&](std::uint32_t t) {
    if (this->Of[t])
      through *= this->Of[t]->transmittance(dot(way, this->Normals[t]));
  });
  return through;
}

double RayScene::transmittance(const RayAnchor& a, const RayAnchor& b) const
{
  return this->Glass ? this->Glass->transmittance(a, b) : 1;
}
}  // namespace kalos
