// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/LocalEstimation.h"

namespace kalos
{
namespace
{
constexpr int chunkSize = 512;                  // trajectories traced by one task
constexpr std::size_t tileSize = 16;            // receivers scored by one task
constexpr int trajectoriesPerShadow = 4;        // trajectories per shadow sample of an area emitter
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
}  // namespace

LocalEstimation::LocalEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Lit(scene),
      Wanted(settings),
      Found(auditScene(scene, inScene(scene, receivers.points))),
      ExactMeshes(this->Found.emittingTriangles <= largestExact &&
                  this->Found.emittingTriangles * receivers.points.size() <= largestViews),
      Source(scene),
      Direct(scene, this->ExactMeshes, !this->Found.unoccluded)
{
  this->Points.reserve(receivers.points.size());
  for (std::size_t i = 0; i < receivers.points.size(); ++i)
    this->Points.emplace_back(scene, receivers.points[i], receivers.normals[i]);
}

bool LocalEstimation::prepare(Workers& workers, Tally& tally)
{
  this->Views.resize(this->Points.size());
  const std::size_t tiles = (this->Points.size() + tileSize - 1) / tileSize;
  return workers.forEach(tiles,
                         [&](std::size_t tile)
                         {
                           const std::size_t end = std::min(this->Points.size(), (tile + 1) * tileSize);
                           for (std::size_t r = tile * tileSize; r < end; ++r)
                           {
                             DirectLight::View& view = this->Views[r];
                             this->Direct.look(this->Points[r], view);
                             for (int b = 0; b < tally.bands(); ++b)
                               tally.fixed(r)[b] = view.points[b] + view.areas[b];
                           }
                         });
}

bool LocalEstimation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene

  // Trace the trajectories of all replicates.
  const int replicates = tally.replicates();
  const int chunksEach = (count + chunkSize - 1) / chunkSize;
  std::vector<TrajectoryChunk> chunks(static_cast<std::size_t>(replicates) * chunksEach);
  const bool traced = workers.forEach(
      chunks.size(),
      [&](std::size_t i)
      {
        const int replicate = static_cast<int>(i / chunksEach), begin = static_cast<int>(i % chunksEach) * chunkSize;
        chunks[i] = traceTrajectories(this->Lit, this->Source, this->Wanted.seed, replicate, first + begin,
                                      std::min(chunkSize, count - begin));
      });

  // Score them at every receiver; a task owns its tile and replicate, so that no sum depends on the threads.
  const std::size_t tiles = (this->Points.size() + tileSize - 1) / tileSize;
  return traced && workers.forEach(tiles * replicates,
                                   [&](std::size_t task)
                                   {
                                     const int replicate = static_cast<int>(task % replicates);
                                     const std::size_t tile = task / replicates,
                                                       end = std::min(this->Points.size(), (tile + 1) * tileSize);
                                     for (std::size_t r = tile * tileSize; r < end; ++r)
                                     {
                                       double* total = tally.total(r, replicate);
                                       for (int c = 0; c < chunksEach; ++c)
                                       {
                                         const TrajectoryChunk& chunk =
                                             chunks[static_cast<std::size_t>(replicate) * chunksEach + c];
                                         this->scoreVertices(this->Points[r], chunk.reflected, total);
                                         if (this->ExactMeshes)
                                           continue;
                                         Bands emitted{};
                                         this->scoreVertices(this->Points[r], chunk.emitted, emitted.data());
                                         for (int b = 0; b < tally.bands(); ++b)
                                         {
                                           total[b] += emitted[b];
                                           tally.direct(r, replicate)[b] += emitted[b];
                                         }
                                       }
                                       this->scoreHidden(r, replicate, first, count, tally);
                                     }
                                   });
}

void LocalEstimation::scoreVertices(const ReceiverPoint& receiver, const VertexSet& vertices, double* sum) const
{
  PairBlock block;
  for (std::size_t begin = 0; begin < vertices.size(); begin += PairBlock::capacity)
  {
    const auto count = static_cast<int>(std::min<std::size_t>(PairBlock::capacity, vertices.size() - begin));
    formPairs(vertices, begin, count, receiver, block);
    if (!this->Found.unoccluded)
      keepVisible(this->Lit.rays(), vertices, receiver, block);
    for (int b = 0; b < this->Lit.bands(); ++b)
    {
      const float* flux = vertices.flux[b].data();
      double score = 0;
      for (int i = 0; i < block.count; ++i)
        score += static_cast<double>(flux[block.index[i]]) * static_cast<double>(block.g[i]);
      sum[b] += score;
    }
  }
}

void LocalEstimation::scoreHidden(std::size_t r, int replicate, long long first, int count, Tally& tally) const
{
  if (!this->Direct.hasAreas() || this->Found.unoccluded)
    return;
  const int samples = (count + trajectoriesPerShadow - 1) / trajectoriesPerShadow;
  RandomStream random(this->Wanted.seed + r * 0x2545f4914f6cdd1dull, replicate, Purpose::DirectLight, first);
  Bands hidden{};
  for (int s = 0; s < samples; ++s)
    this->Direct.sampleHidden(this->Points[r], this->Views[r], random, hidden);
  for (int b = 0; b < tally.bands(); ++b)
  {
    const double missing = hidden[b] * count / samples;  // as much weight as the round's trajectories
    tally.total(r, replicate)[b] -= missing;
    tally.direct(r, replicate)[b] -= missing;
  }
}

std::vector<AuditLine> LocalEstimation::audit() const
{
  std::vector<AuditLine> lines;
  if (this->Found.unoccluded)
    lines.push_back({"shadow rays", "none", "the room is convex and empty: nothing can stand between two points"});
  else
    lines.push_back({"shadow rays", "one per score", "surfaces may stand between two points"});
  const auto& luminaires = this->Lit.data().luminaires;
  const auto points =
      std::count_if(luminaires.begin(), luminaires.end(), [](const Luminaire& l) { return l.isPoint(); });
  if (points)
    lines.push_back({"point luminaires", std::to_string(points) + ", exact", "their direct light has a closed form"});
  if (static_cast<std::size_t>(points) < luminaires.size())
    lines.push_back({"luminous rectangles", std::to_string(luminaires.size() - points) + ", polygon formula",
                     "only the hidden part is sampled"});
  if (this->Found.emittingTriangles)
    lines.push_back(
        {"emitting triangles",
         std::to_string(this->Found.emittingTriangles) +
             (this->ExactMeshes ? ", polygon formula" : ", by trajectory starts"),
         this->ExactMeshes ? "only the hidden part is sampled" : "too many for a closed form at every receiver"});
  return lines;
}
}  // namespace kalos
