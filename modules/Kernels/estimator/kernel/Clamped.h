// SPDX-License-Identifier: BSD-3-Clause
// Also known as: VPL clamping (clamped virtual point lights).
//
// Method `clamped`: min(G, G*) with G* = 1/(pi delta^2), the kernel of two elements that face each other at distance
// delta.
//
// Bias: low, by the part of the illuminance that arrives with G > G*: near a concave right angle at distance h << delta
// that is the light of the strip of the other wall nearer than about delta. Source: common practice with virtual point
// lights (Keller 1997); kept for comparison.
#ifndef kalos_estimator_kernel_Clamped_h
#define kalos_estimator_kernel_Clamped_h

#include "estimator/kernel/KernelRegularization.h"

namespace kalos
{
class Clamped : public KernelRegularization
{
public:
  explicit Clamped(double delta) : Delta(delta), Limit(1 / (pi * delta * delta)) {}

  double reach(std::size_t) const override { return this->Delta; }  // G > G* only there
  double kernel(std::size_t, const Sensor&, const Vec3&, const Vec3&, double plain, RandomStream&) const override
  {
    return std::min(plain, this->Limit);
  }
  std::string describe() const override { return "at most " + std::to_string(this->Limit) + " per m2"; }

private:
  double Delta, Limit;
};
}  // namespace kalos

#endif
