// SPDX-License-Identifier: BSD-3-Clause
#include "material/Brdf.h"

#include "sampling/Warp.h"

namespace kalos
{
namespace
{
double square(double x)
{
  return x * x;
}

double fresnel(double f0, double cosine)
{
  return f0 + (1 - f0) * std::pow(1 - std::max(0.0, cosine), 5);
}

// GGX distribution of normals, per sr.
double distribution(double alpha, const Vec3& m)
{
  const double t = (m.x * m.x + m.y * m.y) / (alpha * alpha) + m.z * m.z;
  return m.z > 0 ? 1 / (pi * alpha * alpha * t * t) : 0;
}

// Smith's Lambda for direction w.
double lambda(double alpha, const Vec3& w)
{
  const double tangent2 = (w.x * w.x + w.y * w.y) / square(w.z);
  return 0.5 * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
}

// A normal visible from wo, in proportion to its projected area (Heitz 2018).
Vec3 visibleNormal(double alpha, const Vec3& wo, double u1, double u2)
{
  const Vec3 stretched = normalized({alpha * wo.x, alpha * wo.y, wo.z});
  const double r = std::sqrt(u1), phi = 2 * pi * u2;
  // The disc seen from the stretched direction; its two axes lie in the plane z = 0 and above it.
  const double horizontal = std::hypot(stretched.x, stretched.y);
  const Vec3 t1 = horizontal > 0 ? Vec3{-stretched.y / horizontal, stretched.x / horizontal, 0} : Vec3{1, 0, 0};
  const Vec3 t2 = cross(stretched, t1);
  const double p1 = r * std::cos(phi), blend = 0.5 * (1 + stretched.z);
  const double p2 = (1 - blend) * std::sqrt(1 - p1 * p1) + blend * r * std::sin(phi);
  const Vec3 m = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1 - p1 * p1 - p2 * p2)) * stretched;
  return normalized({alpha * m.x, alpha * m.y, std::max(1e-12, m.z)});
}
}  // namespace

Brdf::Brdf(const Material& material, int bands)
    : Surface(material), BandCount(bands), Alpha(std::max(1e-4, square(material.roughness)))
{
  if (material.specular == 0)
    return;
  // A(mu) = mean of F G2/G1 over visible normals, by a midpoint rule.
  constexpr int steps = 48;
  for (int k = 0; k < tableSize; ++k)
  {
    const double mu = std::max(1e-3, static_cast<double>(k) / (tableSize - 1));
    const Vec3 wo{std::sqrt(1 - mu * mu), 0, mu};
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j)
      {
        const Vec3 m = visibleNormal(this->Alpha, wo, (i + 0.5) / steps, (j + 0.5) / steps);
        const Vec3 wi = reflected(wo, m);
        if (wi.z <= 0)
          continue;
        const double lo = lambda(this->Alpha, wo), li = lambda(this->Alpha, wi);
        sum += fresnel(material.specular, dot(wo, m)) * (1 + lo) / (1 + lo + li);
      }
    this->Albedo[k] = sum / (steps * steps);
  }
  // Cosine-weighted mean of the piecewise linear table, exactly: 2 integral of A mu dmu.
  const double h = 1.0 / (tableSize - 1);
  for (int k = 0; k + 1 < tableSize; ++k)
  {
    const double a = this->Albedo[k], b = this->Albedo[k + 1], mu = k * h;
    this->MeanAlbedo += 2 * h * (mu * (a + b) / 2 + h * (a / 6 + b / 3));
  }
}

double Brdf::lobeAlbedo(double mu) const
{
  const double x = std::clamp(mu, 0.0, 1.0) * (tableSize - 1);
  const int k = std::min(tableSize - 2, static_cast<int>(x));
  return this->Albedo[k] + (x - k) * (this->Albedo[k + 1] - this->Albedo[k]);
}

double Brdf::localLobe(const Vec3& wi, const Vec3& wo) const
{
  const Vec3 half = wi + wo;
  const Vec3 m = normalized(half);
  const double masking = 1 / (1 + lambda(this->Alpha, wo) + lambda(this->Alpha, wi));
  return (1 - this->Surface.mirror) * pi * distribution(this->Alpha, m) * fresnel(this->Surface.specular, dot(wo, m)) *
         masking / (4 * wi.z * wo.z);
}

double Brdf::lobeDensity(const Vec3& wo, const Vec3& wi) const
{
  const Vec3 m = normalized(wi + wo);
  return distribution(this->Alpha, m) / ((1 + lambda(this->Alpha, wo)) * 4 * wo.z);
}

double Brdf::lobeTimesPi(const Vec3& n, const Vec3& wi, const Vec3& wo) const
{
  if (this->Surface.specular == 0 || !(dot(n, wi) > 0 && dot(n, wo) > 0))
    return 0;
  const Frame frame(n);
  return this->localLobe(frame.toLocal(wi), frame.toLocal(wo));
}

double Brdf::lobeShare(const Vec3& n, const Vec3& wi, const Vec3& wo) const
{
  const double lobe = this->lobeTimesPi(n, wi, wo);
  const double all = photometric(this->timesPi(n, wi, wo), this->BandCount);
  return all > 0 ? std::min(1.0, lobe / all) : 0;
}

Bands Brdf::timesPi(const Vec3& n, const Vec3& wi, const Vec3& wo) const
{
  return this->timesPi(n, wi, wo, 1);
}

Bands Brdf::timesPi(const Vec3& n, const Vec3& wi, const Vec3& wo, double lobeFactor) const
{
  Bands result{};
  const double mi = dot(n, wi), mo = dot(n, wo);
  if (!(mi > 0 && mo > 0))
    return result;
  if (this->Surface.specular == 0)
    return this->Surface.reflectance;
  const Frame frame(n);
  const double lobe = lobeFactor * this->localLobe(frame.toLocal(wi), frame.toLocal(wo));
  const double diffuse = (1 - this->lobeAlbedo(mi)) * (1 - this->lobeAlbedo(mo)) / (1 - this->MeanAlbedo);
  for (int b = 0; b < this->BandCount; ++b)
    result[b] = diffuse * this->Surface.reflectance[b] + lobe;
  return result;
}

double Brdf::diffuseShare(const Bands& carried) const
{
  Bands reflected{};
  for (int b = 0; b < this->BandCount; ++b)
    reflected[b] = carried[b] * this->Surface.reflectance[b];
  const double total = photometric(carried, this->BandCount);
  return total > 0 ? photometric(reflected, this->BandCount) / total : 0;
}

double Brdf::albedo(double mu, const Bands& carried) const
{
  const double lobe = this->Surface.specular > 0 ? this->lobeAlbedo(mu) : 0;
  return this->diffuseShare(carried) * (1 - lobe) + (1 - this->Surface.mirror) * lobe;
}

double Brdf::density(const Vec3& n, const Vec3& wo, const Vec3& wi, const Bands& carried) const
{
  const double mi = dot(n, wi), mo = dot(n, wo);
  if (!(mi > 0 && mo > 0))
    return 0;
  const double diffuse = this->diffuseShare(carried);
  if (this->Surface.specular == 0)
    return diffuse * mi / pi;
  const double lobe = this->lobeAlbedo(mo);
  const Frame frame(n);
  return diffuse * (1 - lobe) * mi / pi +
         (1 - this->Surface.mirror) * lobe * this->lobeDensity(frame.toLocal(wo), frame.toLocal(wi));
}

BrdfSample Brdf::sample(const Vec3& n, const Vec3& wo, const Bands& carried, double u0, double u1, double u2) const
{
  BrdfSample s;
  const double mo = dot(n, wo);
  if (!(mo > 0))
    return s;
  const double lobe = this->Surface.specular > 0 ? this->lobeAlbedo(mo) : 0;
  const double diffusePart = this->diffuseShare(carried) * (1 - lobe), lobePart = (1 - this->Surface.mirror) * lobe;
  const Frame frame(n);
  if (u0 < this->Surface.mirror)
  {
    s.alive = s.mirror = true;
    s.direction = reflected(wo, n);
    s.weight = uniformBands(1);
    return s;
  }
  if (u0 < this->Surface.mirror + diffusePart)
    s.direction = frame.toWorld(cosineHemisphere(u1, u2));
  else if (u0 < this->Surface.mirror + diffusePart + lobePart)
  {
    const Vec3 local = frame.toLocal(wo);
    s.direction = frame.toWorld(reflected(local, visibleNormal(this->Alpha, local, u1, u2)));
  }
  else
    return s;
  const double mi = dot(n, s.direction);
  if (!(mi > 0))
    return s;
  s.density = this->density(n, wo, s.direction, carried);
  const Bands f = this->timesPi(n, s.direction, wo);
  for (int b = 0; b < this->BandCount; ++b)
    s.weight[b] = f[b] * mi / (pi * s.density);
  s.alive = s.density > 0;
  return s;
}
}  // namespace kalos
