// SPDX-License-Identifier: BSD-3-Clause
#include "material/Glass.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace kalos
{
double Glass::clearest(double n)
{
  const double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
  return (1 - r) / (1 + r);
}

Glass::Glass(double tau, double n) : Normal(tau), Index(n)
{
  if (!(n >= 1 && n <= 4))
    throw std::invalid_argument("glass: the refractive index is " + std::to_string(n) + "; expected 1 to 4");
  if (!(tau > 0 && tau <= 1))
    throw std::invalid_argument("glass: the transmittance is " + std::to_string(tau) +
                                "; expected above 0 and at most 1");
  if (tau > clearest(n) * (1 + 1e-9))
    throw std::invalid_argument("glass: the transmittance is " + std::to_string(tau) +
                                ", but the two sides of refractive index " + std::to_string(n) + " let through only " +
                                std::to_string(clearest(n)));
  // tau r^2 a^2 + (1 - r)^2 a - tau = 0
  const double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1)), through = (1 - r) * (1 - r);
  this->Once = std::min(1.0, 2 * tau / (through + std::sqrt(through * through + 4 * tau * tau * r * r)));
}

Glass::Shares Glass::shares(double cosine) const
{
  const double c = std::min(1.0, std::abs(cosine)), n = this->Index;
  const double inside = std::sqrt(1 - (1 - c * c) / (n * n));
  if (!(inside > 0))
    return {0, 1};  // grazing, without refraction
  const double a = std::pow(this->Once, 1 / inside);
  const double across = (c - n * inside) / (c + n * inside), along = (n * c - inside) / (n * c + inside);
  Shares sum{0, 0};
  for (const double r : {across * across, along * along})
  {
    const double through = (1 - r) * (1 - r) * a / (1 - r * r * a * a);
    if (r >= 1)
    {
      sum.reflected += 0.5;
      continue;
    }
    sum.transmitted += 0.5 * through;
    sum.reflected += 0.5 * r * (1 + a * through);
  }
  return sum;
}

double Glass::transmittance(double cosine) const
{
  return this->Index == 1 && this->Once == 1 ? 1 : this->shares(cosine).transmitted;
}

double Glass::reflectance(double cosine) const
{
  return this->Index == 1 ? 0 : this->shares(cosine).reflected;
}
}  // namespace kalos
