// SPDX-License-Identifier: BSD-3-Clause
// Also known as: spherical averaging of the kernel; akin to virtual spherical lights (Hasan et al. 2009).
//
// Methods `sphere-published` and `sphere-exact`: where a vertex lies nearer than delta, the kernel is replaced by a
// one-sample estimate of its average over the ball of radius epsilon about the receiver (Budak et al. 2023, section 2).
//
// A point r_m of the ball is drawn with density proportional to 1/|r_m - y|^2 from an enclosing region (equations
// 14-19), and scores W cos(theta) cos(theta') / pi. The printed text leaves five choices open:
//  (a) A point counts when |r - r_m| < epsilon. (The paper prints the distance to the vertex instead.)
//  (b) The published weight is C/V of the *enclosing* region: W = 3/(3 d^2 + epsilon^2) for d > epsilon, else
//      3/(d + epsilon)^2. With re-drawing until a point counts it is low by a factor of 0.49 at d = epsilon/2, at worst
//      0.41; with rejects scored as zero by 1/(1 + d/epsilon)^3 for d < epsilon.
//  (c) The exact weight is C_ball/V_ball when re-drawing, C_ball = 2 pi epsilon + pi (epsilon^2 - d^2)/d
//      ln|(epsilon + d)/(epsilon - d)|, and C_enclosing/V_ball with rejects scored as zero.
//  (d) A vertex has the incident weight times one reflectance; (9) and (10) print one too many.
//  (e) Visibility, absent from (5), is that between the receiver and the vertex.
// `sphere-published` is {published, re-draw}, `sphere-exact` is {exact, re-draw}.
//
// Bias: of `sphere-exact` O(epsilon^2) of the illuminance's curvature away from edges; at an edge the ball reaches
// behind the walls, where the receiver's hemisphere sees less: low by up to about a half at h << epsilon.
// `sphere-published` is low on top of that by (b) for every vertex nearer than delta.
#ifndef kalos_estimator_kernel_SphereAverage_h
#define kalos_estimator_kernel_SphereAverage_h

#include "estimator/kernel/KernelRegularization.h"

namespace kalos
{
struct SphereChoices
{
  bool exactWeight = true;  ///< (c), else (b)
  bool redraw = true;       ///< re-draw points outside the ball, else score them as zero
};

/// The weight W of choices (b) and (c), 1/m2, for a vertex at distance d.
double sphereWeight(double d, double epsilon, SphereChoices choices);

class SphereAverage : public KernelRegularization
{
public:
  SphereAverage(double delta, double epsilon, SphereChoices choices) : Delta(delta), Epsilon(epsilon), Choices(choices)
  {
  }

  double reach(std::size_t) const override { return this->Delta; }
  double kernel(std::size_t, const Sensor& sensor, const Vec3& y, const Vec3& n, double plain,
                RandomStream& random) const override;
  std::string describe() const override;

private:
  double Delta, Epsilon;
  SphereChoices Choices;
};
}  // namespace kalos

#endif
