// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/ReceiverDirectLight.h"

#include "estimator/direct/DirectLightAudit.h"
#include "estimator/tracing/VertexRound.h"
#include "scene/RayBatch.h"

namespace kalos
{
namespace
{
constexpr int pilotSamples = 16;                // of area emitters, to estimate their visible fraction
constexpr int trajectoriesPerHighlight = 16;    // of a replicate, per sample of highlights
constexpr std::size_t steadyAround = 2;         // receivers before and after that must see the same
constexpr int steadySaving = 8;                 // times fewer samples where the pilot found no partial shadow
constexpr std::size_t largestViews = 1u << 24;  // unshadowed illuminances kept, receivers times emitters: 128 MB
constexpr std::uint32_t largestExact = 4096;    // emitting triangles served by closed forms

std::vector<Vec3> inScene(const Scene& scene, const std::vector<Vec3>& points)
{
  std::vector<Vec3> moved;
  moved.reserve(points.size());
  for (const Vec3& p : points)
    moved.push_back(p - scene.origin());
  return moved;
}

SceneNeeds findNeeds(const Scene& scene, const Receivers& receivers, const Settings& settings)
{
  SceneNeeds needs = kalos::findNeeds(scene, inScene(scene, receivers.points));
  needs.unoccluded = needs.unoccluded && settings.uses(Technique::Convex);
  return needs;
}
}  // namespace

ReceiverDirectLight::ReceiverDirectLight(const Scene& scene, const Receivers& receivers, const Settings& settings,
                                         bool withHighlights, int trajectoriesPerSample)
    : Scene_(scene),
      PerSample(trajectoriesPerSample),
      Drawn(settings.walks()),
      Sampled(!settings.uses(Technique::ExactDirect)),
      Needs(findNeeds(scene, receivers, settings)),
      ClosedForms(!this->Sampled && this->Needs.emittingTriangles <= largestExact &&
                  this->Needs.emittingTriangles * receivers.points.size() <= largestViews),
      Exact(scene, this->ClosedForms, this->shadows() || this->Sampled),
      Luminaires(scene, false, this->shadows() || this->Sampled),
      Mirrored(scene),
      Lobes(scene, withHighlights && settings.uses(Technique::Highlights), this->shadows() || this->Sampled)
{
  this->Sensors.reserve(receivers.points.size());
  for (std::size_t i = 0; i < receivers.points.size(); ++i)
  {
    const Vec3& n = receivers.normals[i];
    Sensor sensor(placeReceiver(scene, receivers.points[i] - scene.origin(), n));
    if (i < receivers.brdfs.size() && receivers.brdfs[i])
    {
      sensor.brdf = receivers.brdfs[i];
      sensor.outgoing = receivers.outgoing[i];
      sensor.followsMirror = receivers.followsMirror[i];
    }
    sensor.highlightsApart = this->Lobes.any();
    this->Sensors.push_back(sensor);
  }
}

bool ReceiverDirectLight::prepare(Workers& workers, Tally& tally)
{
  const bool looked = workers.forEach(tileCount(this->Sensors.size()), [&](std::size_t tile) {
    for (std::size_t r = tile * tileSize; r < std::min(this->Sensors.size(), (tile + 1) * tileSize); ++r)
      this->Sensors[r].doublePrecision = isInGap(this->Scene_, this->Sensors[r].anchor);
  });
  if (!looked)
    return false;
  this->Views.resize(this->Sensors.size());
  return workers.forEach(tileCount(this->Sensors.size()), [&](std::size_t tile) {
    const std::size_t end = std::min(this->Sensors.size(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
    {
      const Bands mirrored = this->Mirrored.any() ? this->Mirrored.illuminance(this->Sensors[r]) : Bands{};
      std::copy_n(mirrored.begin(), tally.bands(), tally.fixed(r));
      if (this->Sensors[r].brdf)
        continue;
      DirectLight::View& view = this->Views[r];
      this->direct().prepareView(this->Sensors[r], view);
      this->measureVisibility(r);
      for (int b = 0; b < tally.bands(); ++b)
        tally.fixed(r)[b] += view.points[b] + view.visibleShare * view.areas[b];
    }
  });
}

void ReceiverDirectLight::measureVisibility(std::size_t r)
{
  if (this->Sampled)
    this->Views[r].visibleShare = 0;
  if (this->Sampled || !this->direct().fluctuates())
    return;
  const Walks walks = this->Drawn.ofReceiver(r);
  DirectLight::View& view = this->Views[r];
  view.visibleShare = 0;
  double visible = 0;
  Bands w;
  for (int s = 0; s < pilotSamples; ++s)
  {
    SampleStream random = walks.stream(pilotReplicate, Purpose::DirectLight, s);
    visible += this->direct().sampleAreas(this->Sensors[r], view, random, w);
  }
  view.visibleShare = visible / pilotSamples;
}

double ReceiverDirectLight::illuminance(std::size_t r) const
{
  const int bands = this->Scene_.bands();
  return photometric(this->Views[r].points, bands) +
         this->Views[r].visibleShare * photometric(this->Views[r].areas, bands);
}

bool ReceiverDirectLight::isSteady(std::size_t r) const
{
  if (this->Sampled || this->direct().hasOpenings())
    return false;
  const double share = this->Views[r].visibleShare;
  const std::size_t end = std::min(this->Views.size(), r + steadyAround + 1);
  for (std::size_t i = r - std::min(r, steadyAround); i < end; ++i)
    if (this->Views[i].visibleShare != share)
      return false;
  return share == 0 || share == 1;
}

Bands ReceiverDirectLight::fluctuation(std::size_t r, int replicate, long long first, int count) const
{
  const Sensor& sensor = this->Sensors[r];
  if (!sensor.brdf && !this->direct().fluctuates())
    return {};
  const int each = this->PerSample * (sensor.brdf || !this->isSteady(r) ? 1 : steadySaving);
  const int samples = (count + each - 1) / each;
  const Walks walks = this->Drawn.ofReceiver(r);
  Bands sum{};
  for (int s = 0; s < samples; ++s)
  {
    SampleStream random = walks.stream(replicate, Purpose::DirectLight, first + s);
    Bands light;
    double excess = 1;
    if (sensor.brdf)
      light = this->Luminaires.sample(sensor, random);
    else
      excess = this->direct().sampleAreas(sensor, this->Views[r], random, light);
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += light[b] * excess;
  }
  for (int b = 0; b < this->Scene_.bands(); ++b)
    sum[b] *= static_cast<double>(count) / samples;
  return sum;
}

Bands ReceiverDirectLight::highlights(std::size_t r, int replicate, long long first, int count) const
{
  Bands sum{};
  const int samples = (count + trajectoriesPerHighlight - 1) / trajectoriesPerHighlight;
  const Walks walks = this->Drawn.ofReceiver(r);
  for (int s = 0; s < samples; ++s)
  {
    SampleStream random = walks.stream(replicate, Purpose::Highlight, first + s);
    const Bands light = this->Lobes.sample(this->Sensors[r], random);
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += light[b] * count / samples;
  }
  return sum;
}

void ReceiverDirectLight::score(std::size_t r, int replicate, long long first, int count, Tally& tally) const
{
  if (tally.converged(r))
    return;
  const Bands light = this->fluctuation(r, replicate, first, count);
  for (int b = 0; b < tally.bands(); ++b)
  {
    tally.total(r, replicate)[b] += light[b];
    tally.direct(r, replicate)[b] += light[b];
  }
  if (!this->Lobes.any())
    return;
  const Bands reflected = this->highlights(r, replicate, first, count);
  for (int b = 0; b < tally.bands(); ++b)
    tally.total(r, replicate)[b] += reflected[b];
}

bool ReceiverDirectLight::scoreAll(long long first, int count, Workers& workers, Tally& tally) const
{
  return workers.forEachReplicate(
      tally.replicates(), tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
        for (std::size_t r = tile * tileSize; r < std::min(tally.receivers(), (tile + 1) * tileSize); ++r)
          this->score(r, replicate, first, count, tally);
      });
}

std::vector<AuditLine> ReceiverDirectLight::audit() const
{
  const auto meshes = this->ClosedForms  ? EmittingMeshes::ClosedForms
                      : this->MeshesSeen ? EmittingMeshes::MetByPaths
                      : this->Sampled    ? EmittingMeshes::SampledAsRequested
                                         : EmittingMeshes::TooMany;
  std::vector<AuditLine> lines = auditDirectLight({this->Scene_, this->Needs, this->Sensors, this->Mirrored, meshes});
  if (this->Lobes.any())
    lines.push_back({"highlights",
                     "by " + std::to_string(this->Scene_.glossyPlanes().planes().size()) + " glossy planes",
                     "light of luminaires by a glossy plane is sampled about the lamp's mirror image"});
  return lines;
}
}  // namespace kalos
