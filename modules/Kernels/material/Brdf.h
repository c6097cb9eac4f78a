// SPDX-License-Identifier: BSD-3-Clause
// Reflection by diffuse + GGX + mirror, energy-conserving and reciprocal.
//
//   f = rho/pi (1 - A(mu_i)) (1 - A(mu_o)) / (1 - A_mean)  +  (1 - m) D F G2 / (4 mu_i mu_o)  +  m (mirror)
//
// D is the GGX distribution of width alpha = roughness^2, G2 Smith's height-correlated masking, F Schlick's Fresnel
// term from F0 = specular; A(mu) is the albedo of the glossy lobe (without m) for incidence at cosine mu, A_mean its
// cosine-weighted mean. The diffuse part takes what the lobe leaves (Kelemen and Szirmay-Kalos 2001), so that with
// rho + m <= 1 no direction reflects more than it receives; at F0 = 0 it is Lambert's law. Swapping the directions
// changes nothing. All directions point away from the surface.
#ifndef kalos_material_Brdf_h
#define kalos_material_Brdf_h

#include <array>

#include "geometry/Vector.h"
#include "material/Material.h"

namespace kalos
{
/// A direction drawn from a Brdf, or none when the light is absorbed.
struct BrdfSample
{
  bool alive = false;
  bool mirror = false;  ///< drawn from the mirror: density is meaningless
  Vec3 direction;
  double density = 0;  ///< per sr, of being alive in this direction (not from the mirror)
  Bands weight{};      ///< f cos(theta) / density per band; the mirror's share over its probability
};

class Brdf
{
public:
  Brdf(const Material& material, int bands);

  const Material& material() const { return this->Surface; }
  bool isLambertian() const { return this->Surface.isLambertian(); }

  /// pi f per band (without the mirror) for light from wi to wo about the normal n; 0 below the surface.
  Bands timesPi(const Vec3& n, const Vec3& wi, const Vec3& wo) const;

  /// pi f of the lobe alone (without the mirror), neutral.
  double lobeTimesPi(const Vec3& n, const Vec3& wi, const Vec3& wo) const;

  /// The same as timesPi() with the lobe times a factor.
  Bands timesPi(const Vec3& n, const Vec3& wi, const Vec3& wo, double lobeFactor) const;

  /// Luminous share of the lobe in pi f, [0, 1].
  double lobeShare(const Vec3& n, const Vec3& wi, const Vec3& wo) const;

  /// What the diffuse part keeps of Lambert's law: pi f = rho incidence(mu_i) towards(mu_o), which is 1 without a lobe.
  double diffuseIncidence(double mu) const { return this->Surface.specular > 0 ? 1 - this->lobeAlbedo(mu) : 1; }
  double diffuseTowards(double mu) const { return this->diffuseIncidence(mu) / (1 - this->MeanAlbedo); }

  /// Width alpha of the distribution of normals, and the lobe's albedo A(mu).
  double lobeWidth() const { return this->Alpha; }
  double lobeAlbedo(double mu) const;

  /// Density per sr with which sample() is alive in direction wi (without the mirror), for light of bands `carried`.
  double density(const Vec3& n, const Vec3& wo, const Vec3& wi, const Bands& carried) const;

  /// Draws a direction for light of bands `carried` coming from (or going to) wo. The probability to be absorbed is the
  /// luminous share that the surface absorbs, so that the luminous weight stays about constant. u0, u1, u2 in [0,1).
  BrdfSample sample(const Vec3& n, const Vec3& wo, const Bands& carried, double u0, double u1, double u2) const;

  /// Luminous share of `carried` reflected by diffuse part and lobe (without the mirror) for incidence at cosine mu.
  double albedo(double mu, const Bands& carried) const;

private:
  static constexpr int tableSize = 33;

  double diffuseShare(const Bands& carried) const;
  double localLobe(const Vec3& wi, const Vec3& wo) const;    // pi f in the local frame
  double lobeDensity(const Vec3& wo, const Vec3& wi) const;  // local frame, per sr

  Material Surface;
  int BandCount;
  double Alpha;
  std::array<double, tableSize> Albedo{};
  double MeanAlbedo = 0;
};
}  // namespace kalos

#endif
