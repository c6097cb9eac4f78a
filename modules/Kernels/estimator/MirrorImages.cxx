// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/MirrorImages.h"

namespace kalos
{
MirrorImages::MirrorImages(const Scene& scene) : Lit(scene)
{
  const auto& luminaires = scene.data().luminaires;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    if (!(scene.material(t).mirror > 0))
      continue;
    for (std::size_t l = 0; l < luminaires.size(); ++l)
    {
      const double height = dot(luminaires[l].position - scene.corner(t, 0), scene.normal(t));
      if (luminaires[l].isPoint() && std::abs(height) > 1e-9 * scene.size())
        this->Images.push_back({l, t, luminaires[l].position - 2 * height * scene.normal(t)});
    }
  }
}

bool MirrorImages::covers(std::uint32_t t, const Vec3& p) const
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 a = this->Lit.corner(t, i), b = this->Lit.corner(t, (i + 1) % 3);
    const double side = dot(cross(b - a, p - a), this->Lit.normal(t));
    // A point on the common side of two triangles belongs to one of them: the one on its left.
    const bool leftwards = b.x != a.x ? b.x > a.x : b.y != a.y ? b.y > a.y : b.z > a.z;
    if (side < 0 || (side == 0 && !leftwards))
      return false;
  }
  return true;
}

Bands MirrorImages::illuminance(const Sensor& sensor) const
{
  const int bands = this->Lit.bands();
  Bands sum{};
  for (const Image& image : this->Images)
  {
    // The line of sight to the image must pass through the mirror, from the side that the luminaire is on.
    const Vec3& n = this->Lit.normal(image.triangle);
    const Vec3 toImage = image.position - sensor.position, corner = this->Lit.corner(image.triangle, 0);
    const double height = dot(sensor.position - corner, n), depth = dot(image.position - corner, n);
    const double d2 = dot(toImage, toImage), cosine = dot(toImage, sensor.normal) / std::sqrt(d2);
    if (!(cosine > 0) || !(height * depth < 0))
      continue;
    const Vec3 q = sensor.position + (height / (height - depth)) * toImage;
    if (!this->covers(image.triangle, q))
      continue;
    const Luminaire& luminaire = this->Lit.data().luminaires[image.luminaire];
    const Vec3 fromLamp = q - luminaire.position;
    const double e = this->Lit.material(image.triangle).mirror *
                     intensity(luminaire, (1 / length(fromLamp)) * fromLamp) * cosine / d2;
    const RayAnchor front = this->Lit.anchor(q, height > 0 ? n : -n);
    if (!(e > 0) || this->Lit.rays().occluded(sensor.anchor, front) ||
        this->Lit.rays().occluded(front, this->Lit.shadowTarget(luminaire)))
      continue;
    const Bands weight = response(sensor, (1 / std::sqrt(d2)) * toImage, bands);
    for (int b = 0; b < bands; ++b)
      sum[b] += weight[b] * e;
  }
  return sum;
}
}  // namespace kalos
