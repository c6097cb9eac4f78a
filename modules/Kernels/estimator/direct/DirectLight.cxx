// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/DirectLight.h"

#include "geometry/Polygon.h"

namespace kalos
{
DirectLight::DirectLight(const Scene& scene, bool withMeshes, bool shadows)
    : Scene_(scene), Shadows(shadows), AreaOf(scene.data().luminaires.size(), noArea), Choice(scene)
{
  for (std::size_t i = 0; i < scene.data().luminaires.size(); ++i)
  {
    const Luminaire& l = scene.data().luminaires[i];
    if (l.isPoint())
      continue;
    this->AreaOf[i] = this->Areas.size();
    this->LuminaireOf.push_back(i);
    const Vec3 u = 0.5 * l.sideU, v = 0.5 * l.sideV, c = l.position;
    const double area = length(cross(l.sideU, l.sideV));
    this->Areas.push_back({{c - u - v, c + u - v, c + u + v, c - u + v},
                           4,
                           l.axis,
                           uniformBands(l.flux / area),
                           l.isOpening() ? &l : nullptr,
                           scene.luminaireAnchor(i)});
    this->HasOpenings = this->HasOpenings || l.isOpening();
  }
  if (!withMeshes)
    return;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    const Bands& exitance = scene.material(t).exitance;
    if (!(photometric(exitance, scene.bands()) > 0))
      continue;
    for (const auto& [a, b, c] : scene.luminousParts(t))
      this->Areas.push_back(
          {{a, b, c, {}}, 3, scene.normal(t), exitance, nullptr, scene.anchor(t, a, scene.normal(t))});
  }
}

double DirectLight::pointIlluminance(const Luminaire& luminaire, const Sensor& sensor) const
{
  if (!luminaire.isPoint() && !(luminaire.isOpening() && !isNear(luminaire, sensor.position)))
    return 0;
  const Vec3 toLamp = luminaire.position - sensor.position;
  const double d2 = dot(toLamp, toLamp), cosine = dot(toLamp, sensor.normal);  // times d
  if (!(cosine > 0))
    return 0;
  const double d = std::sqrt(d2);
  return intensity(luminaire, (-1 / d) * toLamp) * cosine / (d2 * d);
}

bool DirectLight::shinesAt(const LuminousArea& area, const Sensor& sensor) const
{
  if (area.opening && !isNear(*area.opening, sensor.position))
    return false;
  // A sensor in the emitter's plane, to rounding, sees nothing of it.
  const double height = dot(sensor.position - area.corner[0], area.normal);
  const double rounding = 1e-14 * (this->Scene_.size() + maxAbs(this->Scene_.origin()));
  return (area.isTwoSided() ? std::abs(height) : height) > rounding;
}

double DirectLight::formFactor(const LuminousArea& area, const Sensor& sensor) const
{
  return this->shinesAt(area, sensor) ? polygonFormFactor(sensor.position, sensor.normal, area.corner, area.count) : 0;
}

void DirectLight::prepareView(const Sensor& sensor, View& view) const
{
  view.points = view.areas = {};
  view.cumulative.clear();
  double pointSum = 0;
  for (std::size_t i = 0; i < this->Scene_.data().luminaires.size(); ++i)
  {
    const double e = this->pointIlluminance(this->Scene_.data().luminaires[i], sensor);
    if (e > 0 && !(this->Shadows && this->Scene_.rays().occluded(sensor.anchor, this->Scene_.luminaireAnchor(i))))
      pointSum += e;
  }
  view.points = uniformBands(pointSum);
  double sum = 0;
  for (const LuminousArea& area : this->Areas)
  {
    const double factor = this->formFactor(area, sensor);
    for (int b = 0; b < this->Scene_.bands() && !area.opening; ++b)
      view.areas[b] += factor * area.exitance[b];
    sum += factor * photometric(area.exitance, this->Scene_.bands());
    view.cumulative.push_back(sum);
  }
}

namespace
{
// Index drawn in proportion to the steps of a cumulative sum, and its share.
std::size_t draw(const std::vector<double>& cumulative, double u, double& share)
{
  const double total = cumulative.back();
  const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), u * total);
  const std::size_t k = std::min<std::size_t>(found - cumulative.begin(), cumulative.size() - 1);
  share = (cumulative[k] - (k ? cumulative[k - 1] : 0)) / total;
  return k;
}
}  // namespace

double DirectLight::sampleAreas(const Sensor& sensor, const View& view, SampleStream& random, Bands& w) const
{
  w = {};
  const double u0 = random.next(), u1 = random.next(), u2 = random.next(), u3 = random.next();
  if (view.cumulative.empty() || !(view.cumulative.back() > 0))
    return 0;
  double share;
  const LuminousArea& area = this->Areas[draw(view.cumulative, u0, share)];
  AreaSample sample;
  if (!(share > 0) || !area.sample(sensor, u1, u2, u3, sample))
    return 0;
  const Bands exitance = area.exitanceTowards(sample.direction);
  for (int b = 0; b < this->Scene_.bands(); ++b)
    w[b] = exitance[b] / pi * dot(sample.direction, sensor.normal) * sample.solidAngle / share;
  const bool visible = !this->Shadows || !this->Scene_.rays().occluded(sensor.anchor, sample.target);
  return visible - (area.opening ? 0 : view.visibleShare);
}

void DirectLight::weigh(const Sensor& sensor, LuminaireWeights& weights) const
{
  const auto& luminaires = this->Scene_.data().luminaires;
  if (luminaires.size() == 1)
  {
    weights.weight.assign(LuminaireWeights::lanes, 0);
    weights.weight[0] = 1;
  }
  else if (this->Choice.weigh(sensor, weights))
    for (std::size_t i = 0; i < luminaires.size(); ++i)
    {
      if (!(weights.weight[i] < 0))
        continue;
      const LuminousArea& area = this->Areas[this->AreaOf[i]];
      const double e =
          this->formFactor(area, sensor) * area.exitance[0] + this->pointIlluminance(luminaires[i], sensor);
      weights.weight[i] = static_cast<float>(e);
    }
  weights.sum();
}

bool DirectLight::aim(const Sensor& sensor, SampleStream& random, AreaSample& sample, Bands& arriving,
                      Bands& lobe) const
{
  const auto& luminaires = this->Scene_.data().luminaires;
  if (luminaires.empty())
    return false;
  std::size_t k = 0;
  double share = 1;
  if (luminaires.size() > 1 || sensor.brdf)
  {
    const double u = random.next();
    thread_local LuminaireWeights weights;
    this->weigh(sensor, weights);
    if (!(weights.total() > 0))
      return false;
    if (sensor.brdf)
      this->sampleLobe(sensor, random, weights, lobe);
    k = weights.draw(u);
    share = weights.share(k);
  }

  sample.luminaire = k;
  arriving = {};  // lx per band
  if (this->AreaOf[k] == noArea || (luminaires[k].isOpening() && !isNear(luminaires[k], sensor.position)))
  {
    const double e = this->pointIlluminance(luminaires[k], sensor);
    if (!(e > 0))
      return false;
    sample.target = this->Scene_.luminaireAnchor(k);
    sample.direction = normalized(luminaires[k].position - sensor.position);
    arriving = uniformBands(e / share);
    return true;
  }
  const LuminousArea& area = this->Areas[this->AreaOf[k]];
  const double u1 = random.next(), u2 = random.next(), u3 = random.next();
  if (!this->shinesAt(area, sensor) || !area.sample(sensor, u1, u2, u3, sample))
    return false;
  // MIS with the lobe's sample: balance heuristic.
  const double density = share / sample.solidAngle + (sensor.brdf ? gatherDensity(sensor, sample.direction) : 0);
  const Bands exitance = area.exitanceTowards(sample.direction);
  for (int b = 0; b < this->Scene_.bands(); ++b)
    arriving[b] = exitance[b] / pi * dot(sample.direction, sensor.normal) / density;
  return true;
}

bool DirectLight::sampleUnshadowed(const Sensor& sensor, SampleStream& random, Sample& sample, Bands& known) const
{
  AreaSample aimed;
  if (!this->aim(sensor, random, aimed, sample.light, known))
    return false;
  sample.target = aimed.target;
  sample.luminaire = aimed.luminaire;
  if (!sensor.brdf)
    return true;
  const Bands weight = response(sensor, aimed.direction, this->Scene_.bands());
  for (int b = 0; b < this->Scene_.bands(); ++b)
    sample.light[b] *= weight[b];
  return true;
}

Bands DirectLight::sample(const Sensor& sensor, SampleStream& random) const
{
  Sample sample;
  Bands result{};
  if (!this->sampleUnshadowed(sensor, random, sample, result) ||
      (this->Shadows && this->Scene_.rays().occluded(sensor.anchor, sample.target)))
    return result;
  for (int b = 0; b < this->Scene_.bands(); ++b)
    result[b] += sample.light[b];
  return result;
}

void DirectLight::sample(const Sensor* sensors, int count, SampleStream& random, Sample* samples) const
{
  SegmentPacket packet;
  int lit[SegmentPacket::width], rays = 0;
  for (int i = 0; i < count; ++i)
  {
    Bands unused{};
    samples[i].luminaire = 0;
    if (!this->sampleUnshadowed(sensors[i], random, samples[i], unused))
    {
      samples[i].light = {};
      continue;
    }
    packet.set(rays, sensors[i].anchor, samples[i].target);
    lit[rays++] = i;
  }
  if (!this->Shadows || rays == 0)
    return;
  const std::uint32_t hidden = this->Scene_.rays().occluded(packet, rays);
  for (int k = 0; k < rays; ++k)
    if (hidden >> k & 1)
      samples[lit[k]].light = {};
}

void DirectLight::sampleLobe(const Sensor& sensor, SampleStream& random, const LuminaireWeights& weights,
                             Bands& sum) const
{
  const double u0 = random.next(), u1 = random.next(), u2 = random.next();
  const BrdfSample ray = sensor.brdf->sample(sensor.normal, sensor.outgoing, uniformBands(1), u0, u1, u2);
  if (!ray.alive || ray.mirror)
    return;
  const Bands weight = response(sensor, ray.direction, this->Scene_.bands());
  for (std::size_t i = 0; i < this->LuminaireOf.size(); ++i)
  {
    const LuminousArea& area = this->Areas[i];
    const double share = weights.share(this->LuminaireOf[i]);
    double distance;
    if (!(share > 0) || !this->shinesAt(area, sensor) || !area.meets(sensor.position, ray.direction, distance))
      continue;
    const bool behind = dot(ray.direction, area.normal) >= 0;
    const Vec3 met = sensor.position + distance * ray.direction;
    if (this->Shadows && this->Scene_.rays().occluded(sensor.anchor, area.anchorAt(met, behind)))
      continue;
    const double density = share / area.solidAngle(sensor.position) + ray.density;
    const Bands exitance = area.exitanceTowards(ray.direction);
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += weight[b] * exitance[b] / pi * dot(ray.direction, sensor.normal) / density;
  }
}

void DirectLight::addSeen(const Vec3& origin, const Vec3& direction, const SurfacePoint& y, const Bands& throughput,
                          double* sum) const
{
  const double end = y.valid ? length(y.position - origin) : std::numeric_limits<double>::infinity();
  for (const LuminousArea& area : this->Areas)
  {
    double distance;
    if (area.count != 4 || !area.meets(origin, direction, distance) || !(distance < end))
      continue;
    const Bands exitance = area.exitanceTowards(direction);
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += throughput[b] * exitance[b];
  }
}
}  // namespace kalos
