// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/PickedScores.h"

namespace kalos
{
namespace
{
constexpr int lanes = VertexTile::lanes;

double totalOf(const TileScores& scores)
{
  double total = 0;
  for (const float part : scores.laneSum)
    total += static_cast<double>(part);
  return total;
}

// What was picked, each once.
struct Picks
{
  int count = 0;
  int index[ShadowPicks::mostPicks];
  int times[ShadowPicks::mostPicks];
};

// Where the cumulative score, lane after lane, passes (k + u) total/picks, k = 0 .. picks-1.
Picks pickSystematically(const TileScores& scores, int count, double total, const ShadowPicks& shadows)
{
  const double step = total / shadows.picks;
  Picks found;
  int k = 0;
  double before = 0;
  for (int lane = 0; lane < lanes && k < shadows.picks; ++lane)
  {
    double reached = before;
    before += static_cast<double>(scores.laneSum[lane]);
    if (before <= (k + shadows.u) * step)
      continue;
    for (int i = lane; i < count && k < shadows.picks; i += lanes)
    {
      reached += static_cast<double>(scores.score[i]);
      int times = 0;
      for (; k < shadows.picks && scores.score[i] > 0 && (k + shadows.u) * step < reached; ++k)
        ++times;
      if (times == 0)
        continue;
      found.index[found.count] = i;
      found.times[found.count++] = times;
    }
  }
  return found;
}

// Bit k is set when the k-th of these vertices is hidden from the sensor.
std::uint64_t hiddenVertices(const RayScene& rays, const VertexSet& v, const Sensor& sensor, const int* indices,
                             int count)
{
  if (count == 1)
  {
    const auto j = static_cast<std::size_t>(indices[0]);
    const double offset = v.offset[j];
    return rays.occluded(sensor.rayOrigin, v.position(j) + offset * v.normal(j));
  }
  std::uint64_t hidden = 0;
  SegmentPacket packet;
  for (int first = 0; first < count; first += SegmentPacket::width)
  {
    const int size = std::min(SegmentPacket::width, count - first);
    fillPacket(v, sensor, indices + first, size, packet);
    hidden |= static_cast<std::uint64_t>(rays.occluded(packet, size)) << first;
  }
  return hidden;
}

// The general case: pairs with BRDF factors.
double addPickedPairs(const VertexSet& v, const Sensor& sensor, PairBlock& block, const ShadowPicks& shadows,
                      double* sum)
{
  if (!shadows.rays || block.count <= shadows.picks)
  {
    if (shadows.rays)
      keepVisible(*shadows.rays, v, sensor, block);
    return addScores(v, block, sum);
  }
  TileScores scores{};
  for (int i = 0; i < block.count; ++i)
  {
    scores.score[i] = static_cast<float>(luminousScore(v, block, i));
    scores.laneSum[i % lanes] += scores.score[i];
    scores.largest = std::max(scores.largest, scores.score[i]);
  }
  const auto largest = static_cast<double>(scores.largest);
  const double total = totalOf(scores);
  const Picks picks = pickSystematically(scores, block.count, total, shadows);
  int vertices[ShadowPicks::mostPicks];
  for (int k = 0; k < picks.count; ++k)
    vertices[k] = block.index[picks.index[k]];
  const std::uint64_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, picks.count);
  for (int k = 0; k < picks.count; ++k)
  {
    if (hidden >> k & 1)
      continue;
    const int i = picks.index[k], j = block.index[i];
    const double weight = picks.times[k] * total / shadows.picks / static_cast<double>(scores.score[i]) *
                          static_cast<double>(block.kernel[i]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]) * block.factor[i][b];
  }
  return largest;
}
}  // namespace

double addPickedScores(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double share,
                       const ShadowPicks& shadows, double* sum)
{
  if (v.isGlossy() || sensor.brdf)
  {
    PairBlock block;
    formPairs(v, begin, count, sensor, share, block);
    return addPickedPairs(v, sensor, block, shadows, sum);
  }
  const VertexTile tile{v, begin, count};
  TileScores scores;
  scoreTile(tile, sensor, share, scores);
  const auto largest = static_cast<double>(scores.largest);
  const double total = totalOf(scores);
  if (!(total > 0))
    return 0;
  if (!shadows.rays)
  {
    if (v.flux.size() == 1)
    {
      sum[0] += total;
      return largest;
    }
    alignas(64) float kernel[VertexTile::capacity];
    evaluateKernels(tile, sensor, share, kernel);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
    {
      double all = 0;
      for (int i = 0; i < count; ++i)
        all += static_cast<double>(v.flux[b][begin + i]) * static_cast<double>(kernel[i]);
      sum[b] += all;
    }
    return largest;
  }
  const Picks picks = pickSystematically(scores, count, total, shadows);
  int vertices[ShadowPicks::mostPicks];
  for (int k = 0; k < picks.count; ++k)
    vertices[k] = static_cast<int>(begin) + picks.index[k];
  const std::uint64_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, picks.count);
  for (int k = 0; k < picks.count; ++k)
  {
    if (hidden >> k & 1)
      continue;
    // total/picks is the luminous score of a pick; its bands are those of its vertex.
    const auto j = static_cast<std::size_t>(vertices[k]);
    const double weight = picks.times[k] * total / shadows.picks / static_cast<double>(v.luminous[j]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]);
  }
  return largest;
}
}  // namespace kalos
