// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/Bidirectional.h"

#include <numeric>

#include "estimator/tracing/VertexRound.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
// Whether trajectories, too, find paths that go on from the last of these nodes by a mirror.
bool isJoined(const std::vector<PathNode>& nodes)
{
  bool mirror = nodes.empty() || nodes.front().byMirror;
  for (const PathNode& node : nodes)
  {
    if (!mirror && !node.mirror)
      return true;
    mirror = node.mirror;
  }
  return false;
}
}  // namespace

Bidirectional::Bidirectional(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, false),
      Luminaires(scene, false, this->Direct.shadows())
{
}

Pace Bidirectional::pace() const
{
  Pace pace;
  pace.smallest = 16;
  pace.work = 512;  // a pair of halves takes about as long as scoring the vertices of so many trajectories
  return pace;
}

LightHalf Bidirectional::traceLight(int replicate, long long i, EnergySums& energy) const
{
  SampleStream random = this->Settings_.walks().stream(replicate, Purpose::Trajectory, i);
  LightHalf half;
  half.start = this->Source.sample(random);
  const int bands = this->Scene_.bands();
  Bands weight = half.start.weight;
  Vec3 direction = half.start.direction;
  energy.emitted() += photometric(weight, bands);
  energy.trajectories() += 1;
  SurfacePoint y = this->Scene_.trace(half.start.anchor, direction);
  while (y.valid)
  {
    const Brdf& brdf = this->Scene_.brdf(y.triangle);
    half.nodes.push_back({this->Scene_.anchor(y), &brdf, y.triangle, -direction, weight, false, false});
    energy.absorbed() +=
        photometric(weight, bands) * (1 - brdf.material().mirror - brdf.albedo(-dot(y.normal, direction), weight));
    const double u0 = random.next(), u1 = random.next(), u2 = random.next();
    const BrdfSample next = brdf.sample(y.normal, -direction, weight, u0, u1, u2);
    if (!next.alive)
      return half;
    half.nodes.back().mirror = next.mirror;
    for (int b = 0; b < bands; ++b)
      weight[b] *= next.weight[b];
    direction = next.direction;
    y = this->Scene_.trace(half.nodes.back().anchor, direction);
  }
  energy.escaped() += photometric(weight, bands);
  return half;
}

std::vector<PathNode> Bidirectional::traceReceiver(std::size_t r, int replicate, long long i, const LightHalf& light,
                                                   Scores& scores) const
{
  const Sensor& sensor = this->Direct.sensors()[r];
  SampleStream random = this->Settings_.walks().ofReceiver(r).stream(replicate, Purpose::Gather, i);
  const Bands white = uniformBands(1);
  std::vector<PathNode> nodes;
  BrdfSample next;
  const double first1 = random.next(), first2 = random.next();
  if (sensor.brdf)
    next = sensor.brdf->sample(sensor.normal, sensor.outgoing, white, random.next(), first1, first2);
  else
    next = {true, false, Frame(sensor.normal).toWorld(cosineHemisphere(first1, first2)), 0, white};
  if (next.mirror && !sensor.followsMirror)
    return nodes;
  Bands throughput = white;
  RayAnchor from = sensor.anchor;
  while (next.alive)
  {
    for (int b = 0; b < this->Scene_.bands(); ++b)
      throughput[b] *= next.weight[b];
    const SurfacePoint y = this->Scene_.trace(from, next.direction);
    if (next.mirror && !isJoined(nodes))
      this->Luminaires.addSeen(from.lifted(), next.direction, y, throughput, scores.sum.data());
    if (!y.valid)
      break;
    const Brdf& brdf = this->Scene_.brdf(y.triangle);
    nodes.push_back({this->Scene_.anchor(y), &brdf, y.triangle, -next.direction, throughput, false, next.mirror});
    this->meet(r, nodes, y, light, scores);
    const double u0 = random.next(), u1 = random.next(), u2 = random.next();
    next = brdf.sample(y.normal, nodes.back().incident, white, u0, u1, u2);
    nodes.back().mirror = next.alive && next.mirror;
    from = nodes.back().anchor;
  }
  return nodes;
}

void Bidirectional::meet(std::size_t r, const std::vector<PathNode>& nodes, const SurfacePoint& y,
                         const LightHalf& light, Scores& scores) const
{
  const Material& material = this->Scene_.material(y.triangle);
  const bool straight = nodes.size() == 1 && !this->Direct.sensors()[r].brdf;
  if (!y.front || !(photometric(material.exitance, this->Scene_.bands()) > 0) ||
      (straight && this->Direct.exactMeshes(r)))
    return;
  const JoinedPath path(this->Scene_, this->Source, this->Direct.sensors()[r], nodes, nodes.size(), light, 0, true);
  const double share = path.share(this->Settings_.own.connections);
  for (int b = 0; b < this->Scene_.bands(); ++b)
  {
    const double e = share * nodes.back().weight[b] * material.exitance[b];
    scores.sum[b] += e;
    scores.directSum[b] += straight ? e : 0;
  }
}

void Bidirectional::join(std::size_t r, const std::vector<PathNode>& nodes, const LightHalf& light,
                         Scores& scores) const
{
  for (std::size_t m = 0; m <= nodes.size(); ++m)
    for (std::size_t j = 0; j <= light.nodes.size(); ++j)
    {
      const bool direct = m == 0 && j == 0;  // in closed form, but for meshes at some receivers
      if (direct && !(light.start.onSurface && !this->Direct.exactMeshes(r)))
        continue;
      this->joinOne(r, nodes, m, light, j, scores);
    }
}

void Bidirectional::joinOne(std::size_t r, const std::vector<PathNode>& nodes, std::size_t m, const LightHalf& light,
                            std::size_t j, Scores& scores) const
{
  Sensor at = this->Direct.sensors()[r];
  Bands throughput = uniformBands(1);
  if (m > 0)
  {
    at = Sensor(nodes[m - 1].anchor);
    at.brdf = nodes[m - 1].brdf;
    at.outgoing = nodes[m - 1].incident;
    throughput = nodes[m - 1].weight;
  }
  const RayAnchor& target = j > 0 ? light.nodes[j - 1].anchor : light.start.anchor;
  const Vec3 d = target.point - at.position;
  const double squared = dot(d, d);
  const Vec3 towards = normalized(d);
  const double cosine = dot(at.normal, towards);
  if (!(cosine > 0) || !(squared > 0))
    return;
  // What the emitter or the vertex sends this way, per steradian and unit of its weight.
  Bands sent{};
  if (j == 0)
    sent = uniformBands(emissionDensity(light.start.luminaire, target.normal, -towards));
  else
  {
    const PathNode& vertex = light.nodes[j - 1];
    const double leaving = -dot(target.normal, towards);
    sent = leaving > 0 ? vertex.brdf->timesPi(target.normal, vertex.incident, -towards) : Bands{};
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sent[b] *= leaving / pi;
  }
  const Bands& weight = j > 0 ? light.nodes[j - 1].weight : light.start.weight;
  const Bands seen = response(at, towards, this->Scene_.bands());
  Bands score{};
  for (int b = 0; b < this->Scene_.bands(); ++b)
    score[b] = throughput[b] * seen[b] * sent[b] * weight[b] * cosine / squared;
  if (!(photometric(score, this->Scene_.bands()) > 0))
    return;
  const JoinedPath path(this->Scene_, this->Source, this->Direct.sensors()[r], nodes, m, light, j, false);
  const double share = path.share(this->Settings_.own.connections);
  if (!(share > 0))
    return;
  for (double& s : score)
    s *= share;
  scores.rays.push_back({at.anchor, target, at.doublePrecision});
  scores.light.push_back(score);
  scores.direct.push_back(m == 0 && j == 0);
}

bool Bidirectional::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  std::vector<std::vector<LightHalf>> halves(static_cast<std::size_t>(tally.replicates()));
  if (!workers.forEachReplicate(tally.replicates(), 1, [&](int replicate, std::size_t) {
        EnergySums energy(this->Scene_.surfaces());
        for (long long i = first; i < first + count; ++i)
          halves[replicate].push_back(this->traceLight(replicate, i, energy));
        tally.energy(replicate).add(energy);
      }))
    return false;
  // A task owns its tile and replicate, so that no sum depends on the threads.
  return workers.forEachReplicate(
      tally.replicates(), tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
        for (std::size_t r = tile * tileSize; r < std::min(tally.receivers(), (tile + 1) * tileSize); ++r)
        {
          if (tally.converged(r))
            continue;
          const std::vector<std::size_t> partner = this->partners(r, replicate, first, count);
          for (int i = 0; i < count; ++i)
            this->scorePair(r, replicate, first + i, halves[replicate][partner[i]], tally);
          this->Direct.score(r, replicate, first, count, tally);
        }
      });
}

std::vector<std::size_t> Bidirectional::partners(std::size_t r, int replicate, long long first, int count) const
{
  std::vector<std::size_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random = receiverStream(this->Settings_.seed, replicate, Purpose::Selection, r, first);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.next() * static_cast<double>(i))]);
  return order;
}

void Bidirectional::scorePair(std::size_t r, int replicate, long long i, const LightHalf& light, Tally& tally) const
{
  Scores scores;
  const std::vector<PathNode> nodes = this->traceReceiver(r, replicate, i, light, scores);
  this->join(r, nodes, light, scores);
  if (this->Direct.shadows())
    shadowTogether(this->Scene_.rays(), scores.rays);
  for (std::size_t k = 0; k < scores.rays.size(); ++k)
    for (int b = 0; b < tally.bands() && !scores.rays[k].hidden; ++b)
    {
      scores.sum[b] += scores.light[k][b];
      scores.directSum[b] += scores.direct[k] ? scores.light[k][b] : 0;
    }
  for (int b = 0; b < tally.bands(); ++b)
  {
    tally.total(r, replicate)[b] += scores.sum[b];
    tally.direct(r, replicate)[b] += scores.directSum[b];
  }
  tally.noteScore(r, replicate, photometric(scores.sum, tally.bands()));
}

std::vector<AuditLine> Bidirectional::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  const int only = this->Settings_.own.connections;
  if (only > 0)
    lines.push_back({"connections", std::to_string(only) + "-fold estimates",
                     "paths with fewer bounces by the longest receiver's half that they have; unbiased"});
  else
    lines.push_back({"connections", "all", "weighed by the balance heuristic: unbiased and bounded"});
  return lines;
}
}  // namespace kalos
