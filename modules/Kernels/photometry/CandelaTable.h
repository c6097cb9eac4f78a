// SPDX-License-Identifier: BSD-3-Clause
// A measured intensity distribution: candela over photometric planes and polar angles.
#ifndef kalos_photometry_CandelaTable_h
#define kalos_photometry_CandelaTable_h

#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
/// Intensity is bilinear in the two angles between the entries, as the standards say, and 0 outside the table.
///
/// Directions are given in the luminaire's photometric frame: x lies in the half-plane C = 0, y in C = 90 deg, z is the
/// photometric axis (gamma = 0). The planes share a pole: the photometric axis in types C and A (a type A angle V is
/// gamma = V + 90 deg), the y axis in type B (planes are V, from the photometric axis towards C = 0; the polar angle is
/// 90 deg - H). So all three types are looked up where they were measured, none is resampled.
class CandelaTable
{
public:
  enum class Pole
  {
    Axis,  ///< types C and A
    Side   ///< type B
  };

  /// `planes` and `angles` in degrees, strictly ascending, two or more; angles within [0, 180], planes spanning at most
  /// 360; `candela[p * angles.size() + a]` >= 0 and finite. Planes that span 360 close the circle.
  CandelaTable(std::vector<double> planes, std::vector<double> angles, std::vector<double> candela, Pole pole);

  const std::vector<double>& planes() const { return this->Planes; }
  const std::vector<double>& angles() const { return this->Angles; }
  const std::vector<double>& candela() const { return this->Candela; }
  Pole pole() const { return this->SharedPole; }

  double flux() const { return this->Flux; }          ///< lm, the integral of the bilinear intensity in closed form
  double largest() const { return this->Largest; }    ///< cd
  double upwardFlux() const { return this->Upward; }  ///< lm on the far side of the plane across the axis
  bool isOneSided() const { return this->Upward == 0; }

  /// cd in plane `plane` at angle `angle` from the pole, degrees.
  double intensity(double plane, double angle) const;
  /// cd into a unit direction of the photometric frame.
  double intensity(const Vec3& direction) const;

  /// Unit direction in proportion to the intensity, for u1, u2 in [0,1); only when flux() > 0.
  Vec3 sample(double u1, double u2) const;

private:
  double at(std::size_t plane, std::size_t angle) const { return this->Candela[plane * this->Angles.size() + angle]; }
  Vec3 direction(double plane, double angle) const;
  double sumUpward() const;

  std::vector<double> Planes, Angles, Candela;
  std::vector<double> Columns;  // per plane, integral of I sin(angle) up to and including angle a
  std::vector<double> Slabs;    // lm up to and including the slab between planes p and p + 1
  Pole SharedPole;
  double Flux = 0, Largest = 0, Upward = 0;
};
}  // namespace kalos

#endif
