// SPDX-License-Identifier: BSD-3-Clause
// A point where light is measured.
#ifndef kalos_estimator_kernel_Sensor_h
#define kalos_estimator_kernel_Sensor_h

#include <limits>

#include "scene/Placement.h"

namespace kalos
{
/// Measures the illuminance on its hemisphere; or, with a BRDF, pi times the luminance that the surface reflects into
/// `outgoing`: the illuminance weighted by pi f(incident, outgoing). For a Lambertian surface that is rho E, so
/// only glossy surfaces need a BRDF here. Coordinates about the scene's origin.
struct Sensor
{
  Vec3 position, normal;
  RayAnchor anchor;            ///< where its rays leave the surface that it may lie on
  const Brdf* brdf = nullptr;  ///< null: illuminance
  /// Of an illuminance, or null: it is weighted by what the diffuse part of this glossy material keeps by incidence, so
  /// that rho Brdf::diffuseTowards() times it is reflected. Unlike the whole reflection, it does not depend on the
  /// viewer.
  const Brdf* diffuseOf = nullptr;
  Vec3 outgoing;  ///< unit, away from the surface; with brdf
  bool doublePrecision =
      false;  ///< its rays are traced singly, because it lies in a gap or near other surfaces: see isInGap()
  bool followsMirror = true;  ///< false: the mirror part of the BRDF is left out
  /// G/G* of the gather ray that found this glossy surface: its vertices already score there with a share
  /// a = 1/(1 + f^ G/G*), where f^ is pi f over the albedo; what is measured here is the share 1 - a. Infinite: all of
  /// it.
  double ratio = std::numeric_limits<double>::infinity();
  /// Light that comes from luminaires by the lobe of a glossy plane is sampled by Highlights, but for the share that
  /// falls into the sensor's own lobe (keptLobeShare); vertices and gather rays leave it out.
  bool highlightsApart = false;
  /// Of a glossy surface that a gather ray has found: factor of its lobe for light straight from luminaires. Below 1
  /// where the sensor that sent the ray has highlights apart.
  double keptLobe = 1;

  Sensor() = default;
  explicit Sensor(const RayAnchor& a) : position(a.point), normal(a.normal), anchor(a) {}
};

/// x / (1 + x), also for infinite x: the MIS weight (balance heuristic) of gather rays for a pair whose G/G* is x.
inline double gatheredShare(double x)
{
  return std::isinf(x) ? 1.0 : x / (1 + x);
}

/// pi f over the albedo, of neutral light: 1 for a Lambertian surface, large in a narrow lobe.
inline double lobeRatio(const Brdf& brdf, const Vec3& normal, const Vec3& towardsLight, const Bands& timesPi, int bands)
{
  const Bands white = uniformBands(1);
  const double albedo = brdf.albedo(dot(normal, towardsLight), white);
  return albedo > 0 ? photometric(timesPi, bands) / albedo : 0;
}

/// Weight of an illuminance from the unit direction `incident`.
inline double incidence(const Sensor& s, const Vec3& incident)
{
  return s.diffuseOf ? s.diffuseOf->diffuseIncidence(dot(s.normal, incident)) : 1;
}

/// Response to light from the unit direction `incident`, per band: 1, or pi f times the gathered share.
inline Bands response(const Sensor& s, const Vec3& incident, int bands)
{
  if (!s.brdf)
    return uniformBands(incidence(s, incident));
  Bands f = s.brdf->timesPi(s.normal, incident, s.outgoing);
  if (std::isinf(s.ratio))  // infinity times a zero lobe, as a mirror's, would be NaN
    return f;
  const double share = gatheredShare(s.ratio * lobeRatio(*s.brdf, s.normal, incident, f, bands));
  for (int b = 0; b < bands; ++b)
    f[b] *= share;
  return f;
}

/// Share of the response to light from `incident` that is the sensor's own lobe; 1 where no highlights are apart.
inline double keptLobeShare(const Sensor& s, const Vec3& incident)
{
  if (!s.highlightsApart)
    return 1;
  return s.brdf ? s.brdf->lobeShare(s.normal, incident, s.outgoing) : 0;
}

/// Response to light straight from a luminaire, per band: vertices score such light with a share a = 1/(1 + G/G*),
/// without the factor f^, as no ray drawn from the lobe can hit a point.
inline Bands responseToLuminaires(const Sensor& s, const Vec3& incident, int bands)
{
  if (!s.brdf)
    return uniformBands(incidence(s, incident));
  Bands f = s.brdf->timesPi(s.normal, incident, s.outgoing, s.keptLobe);
  const double share = gatheredShare(s.ratio);
  for (int b = 0; b < bands; ++b)
    f[b] *= share;
  return f;
}

/// Density per sr with which a gather ray leaves the sensor in direction `incident`.
inline double gatherDensity(const Sensor& s, const Vec3& incident)
{
  if (s.brdf)
    return s.brdf->density(s.normal, s.outgoing, incident, uniformBands(1));
  return std::max(0.0, dot(s.normal, incident)) / pi;
}
}  // namespace kalos

#endif
