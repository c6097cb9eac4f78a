// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/MirrorImages.h"

#include <algorithm>

namespace kalos
{
MirrorImages::MirrorImages(const Scene& scene) : Scene_(scene)
{
  const auto& luminaires = scene.data().luminaires;
  if (std::none_of(luminaires.begin(), luminaires.end(), [](const Luminaire& l) { return l.isPoint(); }))
    return;
  this->findPlanes();
  for (std::size_t l = 0; l < luminaires.size(); ++l)
    for (std::size_t p = 0; luminaires[l].isPoint() && p < this->Planes.size(); ++p)
      this->addImage(l, p, -1);
  // Images of images, those of fewer reflections first.
  double brightest = 0;
  for (const Plane& plane : this->Planes)
    brightest = std::max(brightest, plane.reflectance);
  for (std::size_t i = 0; i < this->Images.size() && this->Planes.size() > 1; ++i)
  {
    const Image image = this->Images[i];
    const bool follows = this->Images.size() < mostImages;
    this->Truncated = this->Truncated || (!follows && image.reflectance * brightest >= leastReflectance);
    if (!follows || image.reflectance * brightest < leastReflectance)
      this->LeftOut = std::max(this->LeftOut, image.reflectance * brightest);
    for (std::size_t p = 0; follows && p < this->Planes.size(); ++p)
      if (p != image.plane && image.reflectance * this->Planes[p].reflectance >= leastReflectance)
        this->addImage(image.luminaire, p, static_cast<int>(i));
  }
}

void MirrorImages::findPlanes()
{
  for (std::uint32_t t = 0; t < this->Scene_.data().triangles.size(); ++t)
  {
    const double reflectance = this->Scene_.material(t).mirror;
    if (!(reflectance > 0))
      continue;
    const Vec3 p = this->Scene_.corner(t, 0), n = this->Scene_.normal(t);
    // Triangles of one mirror follow each other: a longer search would take quadratic time.
    const auto last = this->Planes.size() > 64 ? this->Planes.rbegin() + 64 : this->Planes.rend();
    const auto same = std::find_if(this->Planes.rbegin(), last, [&](const Plane& plane) {
      return length(cross(n, plane.normal)) < 1e-9 &&
             std::abs(dot(p - plane.point, plane.normal)) < 1e-9 * this->Scene_.size();
    });
    if (same == last)
    {
      this->Planes.push_back({p, n, {t}, reflectance});
      continue;
    }
    same->triangles.push_back(t);
    same->reflectance = std::max(same->reflectance, reflectance);
  }
}

void MirrorImages::addImage(std::size_t luminaire, std::size_t p, int parent)
{
  const Plane& plane = this->Planes[p];
  const Vec3 source = parent < 0 ? this->Scene_.data().luminaires[luminaire].position : this->Images[parent].position;
  const double height = dot(source - plane.point, plane.normal);
  if (!(std::abs(height) > 1e-9 * this->Scene_.size()))
    return;
  const double before = parent < 0 ? 1 : this->Images[parent].reflectance;
  this->Images.push_back({luminaire, p, parent, source - 2 * height * plane.normal, before * plane.reflectance});
}

bool MirrorImages::covers(std::uint32_t t, const Vec3& p) const
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 a = this->Scene_.corner(t, i), b = this->Scene_.corner(t, (i + 1) % 3);
    const double side = dot(cross(b - a, p - a), this->Scene_.normal(t));
    // A point on the common side of two triangles belongs to one of them: the one on its left.
    const bool leftwards = b.x != a.x ? b.x > a.x : b.y != a.y ? b.y > a.y : b.z > a.z;
    if (side < 0 || (side == 0 && !leftwards))
      return false;
  }
  return true;
}

const std::uint32_t* MirrorImages::triangleAt(const Plane& plane, const Vec3& p, const Vec3& direction) const
{
  for (const std::uint32_t& t : plane.triangles)
    if (this->covers(t, p) && this->Scene_.uppermost(t, p, direction) == t)
      return &t;
  return nullptr;
}

double MirrorImages::follow(const Image& image, const Sensor& sensor) const
{
  // From the sensor back to the luminaire: each mirror must be met where the line of sight to its image passes.
  double weight = 1;
  std::vector<RayAnchor> ends{sensor.anchor};  // of the straight parts of the way
  Vec3 from = sensor.position;
  for (const Image* i = &image;; i = &this->Images[i->parent])
  {
    const Plane& plane = this->Planes[i->plane];
    const double height = dot(from - plane.point, plane.normal), depth = dot(i->position - plane.point, plane.normal);
    if (!(height * depth < 0))
      return 0;
    const Vec3 q = from + (height / (height - depth)) * (i->position - from);
    const std::uint32_t* triangle = this->triangleAt(plane, q, q - from);
    if (!triangle)
      return 0;
    weight *= this->Scene_.material(*triangle).mirror;
    ends.push_back(this->Scene_.anchor(*triangle, q, height > 0 ? plane.normal : -plane.normal));
    from = q;
    if (i->parent < 0)
      break;
  }
  const Luminaire& luminaire = this->Scene_.data().luminaires[image.luminaire];
  weight *= intensity(luminaire, normalized(from - luminaire.position));
  ends.push_back(this->Scene_.luminaireAnchor(image.luminaire));
  for (std::size_t k = 0; weight > 0 && k + 1 < ends.size(); ++k)
    if (this->Scene_.rays().occluded(ends[k], ends[k + 1]))
      return 0;
  return weight;
}

Bands MirrorImages::illuminance(const Sensor& sensor) const
{
  const int bands = this->Scene_.bands();
  Bands sum{};
  for (const Image& image : this->Images)
  {
    const Vec3 toImage = image.position - sensor.position;
    const double d2 = dot(toImage, toImage), cosine = dot(toImage, sensor.normal) / std::sqrt(d2);
    if (!(cosine > 0))
      continue;
    const double e = this->follow(image, sensor) * cosine / d2;
    if (!(e > 0))
      continue;
    const Bands weight = response(sensor, (1 / std::sqrt(d2)) * toImage, bands);
    for (int b = 0; b < bands; ++b)
      sum[b] += weight[b] * e;
  }
  return sum;
}
}  // namespace kalos
