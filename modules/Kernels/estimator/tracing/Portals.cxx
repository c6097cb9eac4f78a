// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/Portals.h"

#include <algorithm>
#include <cmath>

#include "sampling/Warp.h"

namespace kalos
{
bool Portal::meets(const Vec3& p, const Vec3& d, double& t) const
{
  const double slope = dot(d, this->onward);
  if (slope == 0)
    return false;
  t = dot(this->corner - p, this->onward) / slope;
  if (!(t > 0))
    return false;
  const Vec3 at = p + t * d - this->corner;
  const double s = dot(at, this->u), r = dot(at, this->v);
  return s >= 0 && s <= dot(this->u, this->u) && r >= 0 && r <= dot(this->v, this->v);
}

Portals::Portals(std::vector<Portal> portals, RegionMap map, std::vector<Mask> fromLight, std::vector<Mask> beyond,
                 std::vector<Mask> fromLuminaires)
    : All(std::move(portals)),
      Map(std::move(map)),
      FromLight(std::move(fromLight)),
      Beyond(std::move(beyond)),
      FromLuminaires(std::move(fromLuminaires))
{
}

Portals::Mask Portals::mask(const std::vector<Mask>& ofRegions, const Vec3& p, const Vec3& n, bool before) const
{
  if (!this->any())
    return 0;
  const int region = this->Map.find(p, n);
  if (region == RegionMap::none)
    return 0;
  Mask found = ofRegions[static_cast<std::size_t>(region)];
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    const Portal& portal = this->All[k];
    if ((dot(p - portal.corner, portal.onward) < 0) != before)
      found &= static_cast<Mask>(~(1u << k));
  }
  return found;
}

double Portals::shares(Mask portals, const Vec3& p, double* share) const
{
  double sum = 0;
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    const Portal& portal = this->All[k];
    const Vec3 d = portal.point(0.5, 0.5) - p;
    const double squared = dot(d, d), seen = std::abs(dot(d, portal.onward)) / std::sqrt(squared + 1e-300) + 0.01;
    share[k] = portals >> k & 1 ? portal.area * seen / (squared + portal.area) : 0;
    sum += share[k];
  }
  return sum;
}

Portals::Aim Portals::aim(Mask portals, const Vec3& p, double u0, double u1, double u2) const
{
  double share[most];
  double left = u0 * this->shares(portals, p, share);
  int chosen = -1;
  for (std::size_t k = 0; k < this->All.size(); ++k)
    if (share[k] > 0 && (chosen < 0 || left >= 0))
    {
      chosen = static_cast<int>(k);
      left -= share[k];
    }
  return {normalized(this->All[static_cast<std::size_t>(chosen)].point(u1, u2) - p), chosen};
}

Vec3 Portals::gather(Mask portals, const Vec3& p, const Vec3& n, std::array<double, 3> u, double& density) const
{
  constexpr double aimed = 0.5;
  const Vec3 direction = u[0] < aimed ? this->aim(portals, p, u[0] / aimed, u[1], u[2]).direction
                                      : Frame(n).toWorld(cosineHemisphere(u[1], u[2]));
  density = aimed * this->density(portals, p, direction) + (1 - aimed) * std::max(0.0, dot(direction, n)) / pi;
  return direction;
}

double Portals::density(Mask portals, const Vec3& p, const Vec3& direction) const
{
  double share[most];
  const double sum = this->shares(portals, p, share);
  double density = 0;
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    double t;
    const Portal& portal = this->All[k];
    if (share[k] > 0 && portal.meets(p, direction, t))
      density += share[k] / sum * t * t / (portal.area * std::abs(dot(direction, portal.onward)));
  }
  return density;
}

bool Portals::cross(Mask portals, const Vec3& p, const Vec3& q) const
{
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    double t;
    if (portals >> k & 1 && this->All[k].meets(p, q - p, t) && t < 1)
      return true;
  }
  return false;
}
}  // namespace kalos
