// SPDX-License-Identifier: BSD-3-Clause
// A thin pane of clear glass: what it lets through and reflects by direction.
#ifndef kalos_material_Glass_h
#define kalos_material_Glass_h

namespace kalos
{
/// A slab in air with all internal reflections, for unpolarised light. With the reflectance R of one side by Fresnel
/// and the share a that crosses the slab once, each polarisation has
///   tau = (1 - R)^2 a / (1 - R^2 a^2),   rho = R + R (1 - R)^2 a^2 / (1 - R^2 a^2),   a = a0^(1 / cos theta_t).
/// a0 is what gives the transmittance at normal incidence.
class Glass
{
public:
  /// Lets everything through.
  Glass() = default;

  /// Throws std::invalid_argument when the transmittance is not in (0, 1], or above what the two sides let through, or
  /// the refractive index is not in [1, 4].
  Glass(double normalTransmittance, double refractiveIndex);

  double transmittance(double cosine) const;  ///< of light at this angle to the normal; the sign does not matter
  double reflectance(double cosine) const;

  double normalTransmittance() const { return this->Normal; }
  double refractiveIndex() const { return this->Index; }
  bool reflects() const { return this->Index > 1; }

  /// The largest normal transmittance of a refractive index: without absorption.
  static double clearest(double refractiveIndex);

private:
  struct Shares
  {
    double transmitted, reflected;
  };
  Shares shares(double cosine) const;

  double Normal = 1, Index = 1, Once = 1;  // transmittance, n, a0
};
}  // namespace kalos

#endif
