// SPDX-License-Identifier: BSD-3-Clause
// Luminaires: points with an intensity distribution, luminous rectangles, and the luminous openings of measured
// luminaires. They emit but have no body.
#ifndef kalos_luminaire_Luminaire_h
#define kalos_luminaire_Luminaire_h

#include <memory>

#include "photometry/CandelaTable.h"

namespace kalos
{
enum class Distribution
{
  Isotropic,   ///< I = flux / (4 pi)
  Lambertian,  ///< I = flux cos(theta) / pi on the side of the axis
  Measured     ///< I = flux times the table's intensity per lumen
};

struct Luminaire
{
  Vec3 position;        ///< m; the centre of a rectangle, the photometric centre of a measured luminaire
  Vec3 axis{0, 0, -1};  ///< unit vector of the photometric axis
  double flux = 0;      ///< lm, >= 0, neutral in all bands
  Distribution distribution = Distribution::Lambertian;
  Vec3 sideU, sideV;                          ///< full sides of a luminous rectangle, m; both zero for a point
  Vec3 up{0, 1, 0};                           ///< unit vector across the axis, to the half-plane C = 90 deg
  std::shared_ptr<const CandelaTable> table;  ///< of a measured distribution, with flux() > 0

  bool isPoint() const { return this->sideU.x == 0 && this->sideU.y == 0 && this->sideU.z == 0; }
  /// Measured, with an opening: a point from afar, and an area whose every spot radiates like the whole from near by.
  bool isOpening() const { return this->distribution == Distribution::Measured && !this->isPoint(); }
  /// Nothing leaves behind the plane across the axis: mounted flush with a ceiling, it shines into the room.
  bool isOneSided() const
  {
    return this->distribution == Distribution::Lambertian ||
           (this->distribution == Distribution::Measured && this->table->isOneSided());
  }
};

/// Distance in units of an opening's larger side below which it is an area.
constexpr double nearOpening = 5;

/// Whether p is so close to an opening that it must be an area.
bool isNear(const Luminaire& opening, const Vec3& p);

/// Luminous intensity of the whole luminaire into the unit direction, cd.
double intensity(const Luminaire& luminaire, const Vec3& direction);

/// A unit direction drawn in proportion to the intensity, for u1, u2 in [0,1): every sample carries the flux.
Vec3 sampleDirection(const Luminaire& luminaire, double u1, double u2);
}  // namespace kalos

#endif
