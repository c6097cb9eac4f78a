// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/DirectLight.h"

#include "geometry/Polygon.h"

namespace kalos
{
DirectLight::DirectLight(const Scene& scene, bool withMeshes, bool shadows) : Lit(scene), Shadows(shadows)
{
  for (const Luminaire& l : scene.data().luminaires)
  {
    if (l.isPoint())
      continue;
    const Vec3 u = 0.5 * l.sideU, v = 0.5 * l.sideV, c = scene.offset(l.position, l.axis);
    const double area = length(cross(l.sideU, l.sideV));
    this->Areas.push_back({{c - u - v, c + u - v, c + u + v, c - u + v}, 4, l.axis, uniformBands(l.flux / area)});
  }
  if (!withMeshes)
    return;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    const Bands& exitance = scene.material(t).exitance;
    if (photometric(exitance, scene.bands()) > 0)
      this->Areas.push_back(
          {{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2), {}}, 3, scene.normal(t), exitance});
  }
}

Bands DirectLight::pointIlluminance(const Luminaire& luminaire, const ReceiverPoint& receiver) const
{
  Vec3 lamp = luminaire.position;
  if (luminaire.distribution == Distribution::Lambertian)
    lamp = this->Lit.offset(lamp, luminaire.axis);  // as its trajectories start
  const Vec3 toLamp = lamp - receiver.position;
  const double d2 = dot(toLamp, toLamp);
  const double cosine = dot(toLamp, receiver.normal);  // times d
  if (!(cosine > 0))
    return {};
  const double d = std::sqrt(d2);
  const double e = intensity(luminaire, (-1 / d) * toLamp) * cosine / (d2 * d);
  if (e > 0 && this->Shadows && this->Lit.rays().occluded(receiver.rayOrigin, lamp))
    return {};
  return uniformBands(e);
}

void DirectLight::look(const ReceiverPoint& receiver, View& view) const
{
  view.points = view.areas = {};
  view.cumulative.clear();
  for (const Luminaire& luminaire : this->Lit.data().luminaires)
  {
    if (!luminaire.isPoint())
      continue;
    const Bands e = this->pointIlluminance(luminaire, receiver);
    for (int b = 0; b < this->Lit.bands(); ++b)
      view.points[b] += e[b];
  }
  double sum = 0;
  for (const Area& area : this->Areas)
  {
    if (dot(receiver.position - area.corner[0], area.normal) > 0)
    {
      const double factor = polygonFormFactor(receiver.position, receiver.normal, area.corner, area.count);
      for (int b = 0; b < this->Lit.bands(); ++b)
        view.areas[b] += factor * area.exitance[b];
      sum += factor * photometric(area.exitance, this->Lit.bands());
    }
    view.cumulative.push_back(sum);
  }
}

void DirectLight::sampleHidden(const ReceiverPoint& receiver, const View& view, RandomStream& random,
                               Bands& hidden) const
{
  const double u0 = random.next(), u1 = random.next(), u2 = random.next(), u3 = random.next();
  if (!this->Shadows || view.cumulative.empty() || !(view.cumulative.back() > 0))
    return;

  // Draw an emitter in proportion to its unshadowed illuminance.
  const double total = view.cumulative.back();
  const auto found = std::upper_bound(view.cumulative.begin(), view.cumulative.end(), u0 * total);
  const std::size_t k = std::min<std::size_t>(found - view.cumulative.begin(), view.cumulative.size() - 1);
  const double share = (view.cumulative[k] - (k ? view.cumulative[k - 1] : 0)) / total;
  const Area& area = this->Areas[k];

  // Draw a direction uniform in its solid angle; a rectangle is two triangles.
  const Vec3& r = receiver.position;
  SphericalTriangle part(r, area.corner[0], area.corner[1], area.corner[2]);
  double solidAngle = part.solidAngle();
  if (area.count == 4)
  {
    const SphericalTriangle other(r, area.corner[0], area.corner[2], area.corner[3]);
    const double first = solidAngle;
    solidAngle += other.solidAngle();
    if (u1 * solidAngle >= first)
      part = other;
  }
  if (!(part.solidAngle() > 0) || !(share > 0))
    return;
  const Vec3 direction = part.sample(u2, u3);
  const double cosine = dot(direction, receiver.normal);
  const double facing = -dot(direction, area.normal);
  if (!(cosine > 0) || !(facing > 0))
    return;

  // Where the ray is stopped before the emitter, its contribution is missing.
  const double distance = dot(area.corner[0] - r, area.normal) / -facing;
  const Vec3 target = this->Lit.offset(r + distance * direction, area.normal);
  if (!this->Lit.rays().occluded(receiver.rayOrigin, target))
    return;
  for (int b = 0; b < this->Lit.bands(); ++b)
    hidden[b] += area.exitance[b] / pi * cosine * solidAngle / share;
}
}  // namespace kalos
