// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/Emission.h"

#include <algorithm>

#include "geometry/Polygon.h"
#include "sampling/Warp.h"

namespace kalos
{
Emission::Emission(const Scene& scene, const SkyOpenings* openings) : Scene_(scene), FromSky(scene, openings)
{
  const auto count = static_cast<std::uint32_t>(scene.data().triangles.size());
  for (std::uint32_t t = 0; t < count; ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
      for (const std::array<Vec3, 3>& part : scene.luminousParts(t))
        this->Parts.push_back({t, part});
  this->Cumulative.resize(this->luminaires() + this->Parts.size() + (this->FromSky.flux() > 0 ? 1 : 0));
  this->sum();
  this->TotalFlux = this->TotalWeight;
}

void Emission::prefer(Preference preference)
{
  this->Preferred = std::move(preference);
  this->sum();
}

void Emission::sum()
{
  this->TotalWeight = 0;
  for (std::size_t i = 0; i < this->Cumulative.size(); ++i)
    this->Cumulative[i] = this->TotalWeight += this->flux(i) * this->factor(i);
}

double Emission::flux(std::size_t i) const
{
  if (i < this->luminaires())
    return this->Scene_.data().luminaires[i].flux;
  if (i >= this->luminaires() + this->Parts.size())
    return this->FromSky.flux();
  const auto& [t, part] = this->Parts[i - this->luminaires()];
  return photometric(this->Scene_.material(t).exitance, this->Scene_.bands()) * 0.5 *
         length(cross(part[1] - part[0], part[2] - part[0]));
}

double Emission::probability(std::size_t i) const
{
  return this->TotalWeight > 0 ? this->flux(i) * this->factor(i) / this->TotalWeight : 0;
}

double Emission::firstHitDensity(std::size_t i, const Vec3& p, const Vec3& n) const
{
  if (i >= this->Scene_.data().luminaires.size())
    return 0;
  const Luminaire& l = this->Scene_.data().luminaires[i];
  const Vec3 d = p - l.position;
  double share = 0;  // of the luminaire's flux, 1/m2
  if (l.isPoint() || (l.isOpening() && !isNear(l, p)))
  {
    const double squared = dot(d, d), cosine = -dot(d, n);
    share =
        cosine > 0 ? intensity(l, (1 / std::sqrt(squared)) * d) / l.flux * cosine / (squared * std::sqrt(squared)) : 0;
  }
  else if (!l.isOneSided() || dot(d, l.axis) > 0)
  {
    const Vec3 u = 0.5 * l.sideU, v = 0.5 * l.sideV, c = l.position;
    const Vec3 corners[4] = {c - u - v, c + u - v, c + u + v, c - u + v};
    share = polygonFormFactor(p, n, corners, 4) / length(cross(l.sideU, l.sideV));
  }
  return this->probability(i) * share;
}

double Emission::startDensity(std::uint32_t t) const
{
  if (!(this->TotalWeight > 0))
    return 0;
  const double exitance = photometric(this->Scene_.material(t).exitance, this->Scene_.bands());
  if (!this->isGuided() || !(exitance > 0))
    return exitance / this->TotalWeight;
  const auto found =
      std::lower_bound(this->Parts.begin(), this->Parts.end(), t,
                       [](const Part& part, std::uint32_t triangle) { return part.triangle < triangle; });
  return exitance * this->factor(this->luminaires() + static_cast<std::size_t>(found - this->Parts.begin())) /
         this->TotalWeight;
}

Portals::Mask Emission::portalsFor(const EmissionSample& start) const
{
  if (start.fromSky)
    return 0;
  return start.onSurface ? this->Through.forTrajectories(start.anchor.point, start.anchor.normal)
                         : this->Through.forLuminaire(start.emitter);
}

double Emission::directionDensity(const EmissionSample& start, const Vec3& direction) const
{
  if (start.onSurface)
    return std::max(0.0, dot(start.anchor.normal, direction)) / pi;
  const Luminaire& luminaire = this->Scene_.data().luminaires[start.emitter];
  return intensity(luminaire, direction) / luminaire.flux;
}

EmissionSample Emission::sample(SampleStream& random) const
{
  const double target = random.next() * this->TotalWeight;
  const auto found = std::upper_bound(this->Cumulative.begin(), this->Cumulative.end(), target);
  const auto i = std::min<std::size_t>(found - this->Cumulative.begin(), this->Cumulative.size() - 1);
  // Reuse the remainder of the choice as a uniform number, so that emitter, point and direction use one Sobol' block.
  const double before = i ? this->Cumulative[i - 1] : 0;
  const double u = std::min((target - before) / (this->Cumulative[i] - before), 0x1.fffffffffffffp-1);
  if (i >= this->luminaires() + this->Parts.size())
    return this->fromSky(u, random);
  EmissionSample start = i < this->luminaires() ? this->fromLuminaire(i, u, random) : this->fromTriangle(i, u, random);
  if (this->isGuided())
    start.stratum = this->Preferred.strata[i];
  return start;
}

EmissionSample Emission::fromSky(double u, SampleStream& random) const
{
  const double u1 = random.next(), u2 = random.next(), u3 = random.next(), u4 = random.next();
  const SkyEmission::Line line = this->FromSky.sample(u, u1, u2, u3, u4);
  EmissionSample start;
  start.fromSky = true;
  start.anchor = line.start;
  start.direction = line.direction;
  start.weight = uniformBands(line.weight * this->TotalWeight / this->FromSky.flux());
  return start;
}

EmissionSample Emission::fromLuminaire(std::size_t i, double u, SampleStream& random) const
{
  const Luminaire& luminaire = this->Scene_.data().luminaires[i];
  EmissionSample start;
  start.emitter = i;
  start.fromPoint = luminaire.isPoint();
  start.anchor = this->Scene_.luminaireAnchor(i);  // a lamp mounted flush with a ceiling shines into the room
  start.weight = uniformBands(this->TotalWeight / this->factor(i));
  double u1 = u;
  if (!luminaire.isPoint())
  {
    start.anchor.point += (u - 0.5) * luminaire.sideU + (random.next() - 0.5) * luminaire.sideV;
    u1 = random.next();
  }
  const double u2 = random.next();
  start.direction = sampleDirection(luminaire, u1, u2);
  return start;
}

EmissionSample Emission::fromTriangle(std::size_t i, double u, SampleStream& random) const
{
  double b1, b2;
  uniformTriangle(u, random.next(), b1, b2);
  const auto& [t, corners] = this->Parts[i - this->luminaires()];
  const Vec3& a = corners[0];
  EmissionSample start;
  start.onSurface = true;
  start.triangle = t;
  const Vec3& n = this->Scene_.normal(t);
  start.anchor = this->Scene_.anchor(t, a + b1 * (corners[1] - a) + b2 * (corners[2] - a), n);
  const double v1 = random.next(), v2 = random.next();
  start.direction = Frame(n).toWorld(cosineHemisphere(v1, v2));
  const Bands& exitance = this->Scene_.material(t).exitance;
  start.density = photometric(exitance, this->Scene_.bands()) * this->factor(i) / this->TotalWeight;
  const double scale = 1 / start.density;
  for (int b = 0; b < maxBands; ++b)
    start.weight[b] = scale * exitance[b];
  return start;
}
}  // namespace kalos
