// SPDX-License-Identifier: BSD-3-Clause
#include "luminaire/Luminaire.h"

#include "sampling/Warp.h"

namespace kalos
{
bool isNear(const Luminaire& opening, const Vec3& p)
{
  const Vec3 d = p - opening.position;
  const double u2 = dot(opening.sideU, opening.sideU), v2 = dot(opening.sideV, opening.sideV);
  return dot(d, d) < nearOpening * nearOpening * std::max(u2, v2);
}

double intensity(const Luminaire& l, const Vec3& direction)
{
  switch (l.distribution)
  {
    case Distribution::Isotropic:
      return l.flux / (4 * pi);
    case Distribution::Lambertian:
      return l.flux / pi * std::max(0.0, dot(l.axis, direction));
    case Distribution::Measured:
      break;
  }
  const double along = dot(direction, l.axis);
  if (along < 0 && l.table->isOneSided())
    return 0;
  const Vec3 local{dot(direction, cross(l.axis, l.up)), dot(direction, l.up), along};
  return l.flux / l.table->flux() * l.table->intensity(local);
}

Vec3 sampleDirection(const Luminaire& l, double u1, double u2)
{
  switch (l.distribution)
  {
    case Distribution::Isotropic:
      return uniformSphere(u1, u2);
    case Distribution::Lambertian:
      return Frame(l.axis).toWorld(cosineHemisphere(u1, u2));
    case Distribution::Measured:
      break;
  }
  const Vec3 local = l.table->sample(u1, u2);
  return local.x * cross(l.axis, l.up) + local.y * l.up + local.z * l.axis;
}
}  // namespace kalos
