// SPDX-License-Identifier: BSD-3-Clause
// Also known as: virtual area sensor; the receiver-side counterpart of virtual spherical lights.
//
// Method `disc`: the kernel averaged over the receiver's disc of radius epsilon, or over its own mesh polygon; that is
// what a meter head or an area meter reads.
//
// The average of G over an area A about r is F/A, F the form factor from the vertex to the area: for a disc in full
// view the closed form of its vector irradiance, for a polygon, and for a disc that the vertex's horizon cuts (as the
// regular 64-gon of equal area), Lambert's formula. No sampling. Vertices farther than 32 radii keep the plain kernel,
// which differs from the average by less than (epsilon/d)^2 < 0.1 %.
//
// Bias: O(epsilon^2) of the illuminance's curvature over the disc, with no extra bias at edges as long as the disc does
// not reach through a wall; the mean over the polygon is exact for what an area meter reads. Source: Lambert 1760;
// disc: Howell, Catalog of Radiation Heat Transfer Configuration Factors, B-12 and B-13.
#ifndef kalos_estimator_kernel_DiscAverage_h
#define kalos_estimator_kernel_DiscAverage_h

#include "estimator/control/Receivers.h"
#include "estimator/kernel/KernelRegularization.h"

namespace kalos
{
/// Form factor from the element at y with unit normal n to a disc of centre c, unit normal m and the given radius,
/// which looks at y with the side of m. 0 when y lies behind the disc.
double discFormFactor(const Vec3& y, const Vec3& n, const Vec3& c, const Vec3& m, double radius);

class DiscAverage : public KernelRegularization
{
public:
  DiscAverage(const Scene& scene, const Receivers& receivers, double epsilon);

  double reach(std::size_t receiver) const override { return 32 * this->Radius[receiver]; }
  double kernel(std::size_t receiver, const Sensor& sensor, const Vec3& y, const Vec3& n, double plain,
                RandomStream&) const override;
  std::string describe() const override;

private:
  double Epsilon;
  std::vector<std::vector<Vec3>> Cells;  // corners about the scene's origin; empty: a disc
  std::vector<double> Radius;            // m, of the disc or about the cell
  std::vector<double> Area;              // m2
};
}  // namespace kalos

#endif
