// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/Emission.h"

#include "geometry/Polygon.h"
#include "sampling/Warp.h"

namespace kalos
{
Emission::Emission(const Scene& scene) : Scene_(scene)
{
  auto add = [this](double flux) { this->Cumulative.push_back(this->TotalFlux += flux); };
  for (const Luminaire& luminaire : scene.data().luminaires)
    add(luminaire.flux);
  const auto count = static_cast<std::uint32_t>(scene.data().triangles.size());
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const double exitance = photometric(scene.material(t).exitance, scene.bands());
    if (!(exitance > 0))
      continue;
    for (const std::array<Vec3, 3>& part : scene.luminousParts(t))
    {
      this->Parts.push_back({t, part});
      add(exitance * 0.5 * length(cross(part[1] - part[0], part[2] - part[0])));
    }
  }
}

double Emission::probability(std::size_t i) const
{
  return (this->Cumulative[i] - (i ? this->Cumulative[i - 1] : 0)) / this->TotalFlux;
}

double Emission::firstHitDensity(std::size_t i, const Vec3& p, const Vec3& n) const
{
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

EmissionSample Emission::sample(SampleStream& random) const
{
  const double target = random.next() * this->TotalFlux;
  const auto found = std::upper_bound(this->Cumulative.begin(), this->Cumulative.end(), target);
  const auto i = std::min<std::size_t>(found - this->Cumulative.begin(), this->Cumulative.size() - 1);
  // Reuse the remainder of the choice as a uniform number, so that emitter, point and direction use one Sobol' block.
  const double before = i ? this->Cumulative[i - 1] : 0;
  const double u = std::min((target - before) / (this->Cumulative[i] - before), 0x1.fffffffffffffp-1);
  const std::size_t luminaires = this->Scene_.data().luminaires.size();
  return i < luminaires ? this->fromLuminaire(i, u, random)
                        : this->fromTriangle(this->Parts[i - luminaires], u, random);
}

EmissionSample Emission::fromLuminaire(std::size_t i, double u, SampleStream& random) const
{
  const Luminaire& luminaire = this->Scene_.data().luminaires[i];
  EmissionSample start;
  start.emitter = i;
  start.fromPoint = luminaire.isPoint();
  start.anchor = this->Scene_.luminaireAnchor(i);  // a lamp mounted flush with a ceiling shines into the room
  start.weight = uniformBands(this->TotalFlux);
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

EmissionSample Emission::fromTriangle(const Part& part, double u, SampleStream& random) const
{
  double b1, b2;
  uniformTriangle(u, random.next(), b1, b2);
  const auto& [t, corners] = part;
  const Vec3& a = corners[0];
  EmissionSample start;
  start.onSurface = true;
  start.triangle = t;
  const Vec3& n = this->Scene_.normal(t);
  start.anchor = this->Scene_.anchor(t, a + b1 * (corners[1] - a) + b2 * (corners[2] - a), n);
  const double v1 = random.next(), v2 = random.next();
  start.direction = Frame(n).toWorld(cosineHemisphere(v1, v2));
  const Bands& exitance = this->Scene_.material(t).exitance;
  start.density = photometric(exitance, this->Scene_.bands()) / this->TotalFlux;
  const double scale = 1 / start.density;
  for (int b = 0; b < maxBands; ++b)
    start.weight[b] = scale * exitance[b];
  return start;
}
}  // namespace kalos
