// SPDX-License-Identifier: BSD-3-Clause
#include "luminaire/Luminaire.h"

#include "sampling/Warp.h"

namespace kalos
{
double intensity(const Luminaire& luminaire, const Vec3& direction)
{
  if (luminaire.distribution == Distribution::Isotropic)
    return luminaire.flux / (4 * pi);
  return luminaire.flux / pi * std::max(0.0, dot(luminaire.axis, direction));
}

Vec3 sampleDirection(const Luminaire& luminaire, double u1, double u2)
{
  if (luminaire.distribution == Distribution::Isotropic)
    return uniformSphere(u1, u2);
  return Frame(luminaire.axis).toWorld(cosineHemisphere(u1, u2));
}
}  // namespace kalos
