// SPDX-License-Identifier: BSD-3-Clause
// Discomfort glare by CIE 117: the sum over the emitters in an observer's field of view in
//
//   UGR = 8 log10( (0.25 / L_b) sum L^2 omega / p^2 ),   L_b = E_indirect / pi at the eye,
//
// L the luminance of a luminaire's luminous area towards the eye, omega the solid angle of it, p Guth's position index.
#ifndef kalos_estimator_quantities_GlareRating_h
#define kalos_estimator_quantities_GlareRating_h

#include "scene/Scene.h"

namespace kalos
{
struct Observer
{
  Vec3 position;     ///< m, in world coordinates
  Vec3 sight;        ///< unit vector, the line of sight
  Vec3 up{0, 0, 1};  ///< any vector not along the sight
};

/// The sum and the number of its sources.
struct GlareSum
{
  double sum = 0;   ///< sum of L^2 omega / p^2, cd^2/m^4 sr
  int sources = 0;  ///< luminaires and emitting triangles in the field of view that are not hidden
  int small = 0;    ///< of these, without an area or below 0.005 m^2: L^2 omega = 200 I^2/d^2 (CIE 147)
  int large = 0;    ///< of these, beyond 0.1 sr, where CIE 117 was not tested
};

/// Guth's position index of a source in unit direction `to` from the eye: above the line of sight
///   ln p = (35.2 - 0.31889 t - 1.22 exp(-2 t/9)) 1e-3 s + (21 + 0.26667 t - 0.002963 t^2) 1e-5 s^2,
/// s the angle to the line of sight, t that of its plane to the vertical one, degrees (Levin 1975; within 12 % of
/// Guth's curves, mostly 4 % of the table that CIE 117 interpolates: at most 0.8, mostly 0.3 in UGR); below it
///   p = 1 + 0.8 r, from r = 0.6 on 1 + 1.2 r, r = tan s, at most 3 (Iwata and Tokura 1997).
/// Infinite behind the eye, and outside the field of CIE 117's table: 3 times the distance ahead to a side, 1.9 times
/// up.
double positionIndex(const Observer& observer, const Vec3& to);

/// The sum over all luminaires and emitting surfaces. The visible share of an area comes from shadow rays to the
/// middles of 8 x 8 parts; an emitting triangle is cut into pieces no larger than a quarter of their distance.
GlareSum glareSum(const Scene& scene, const Observer& observer);

/// UGR from the sum and the indirect illuminance at the eye (lx); minus infinity without glare, NaN without background.
double unifiedGlareRating(double sum, double indirectIlluminance);
}  // namespace kalos

#endif
