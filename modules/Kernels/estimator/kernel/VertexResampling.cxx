// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/VertexResampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kalos
{
namespace
{
constexpr int lanes = VertexTile::lanes;

// The picked vertices, each listed once with its multiplicity.
struct Picks
{
  int count = 0;
  int index[ShadowPicks::mostPicks];
  int times[ShadowPicks::mostPicks];
};

// The first vertex of a lane where the sum along the lane is beyond the threshold; there is one. Branch-free bisection,
// because the branches would be unpredictable.
int firstBeyond(const TileScores& scores, int lane, double threshold)
{
  int length = scores.count / lanes, first = lane;
  while (length > 1)
  {
    const int half = length / 2;
    first += static_cast<double>(scores.reached[first + (half - 1) * lanes]) <= threshold ? half * lanes : 0;
    length -= half;
  }
  return first;
}

// Where the cumulative score, lane after lane, passes (k + u) total/picks, k = 0 .. picks-1.
Picks pickSystematically(const TileScores& scores, double total, const ShadowPicks& shadows)
{
  const double step = total / shadows.picks;
  Picks found;
  int k = 0;
  double before = 0, next = shadows.u * step;
  for (int lane = 0; lane < lanes; ++lane)
  {
    const double sum = static_cast<double>(scores.laneSum(lane));
    while (k < shadows.picks && next - before < sum)
    {
      const int i = firstBeyond(scores, lane, next - before);
      found.index[found.count] = i;
      found.times[found.count] = 0;
      do
      {
        ++found.times[found.count];
        next = (++k + shadows.u) * step;
      } while (k < shadows.picks && next - before < static_cast<double>(scores.reached[i]));
      ++found.count;
    }
    before += sum;
  }
  return found;
}

// Bit k is set when the k-th of these vertices is hidden from the sensor.
std::uint64_t hiddenVertices(const RayScene& rays, const VertexSet& v, const Sensor& sensor, const int* indices,
                             int count)
{
  std::uint64_t hidden = 0;
  if (count == 1 || sensor.doublePrecision)
  {
    for (int k = 0; k < count; ++k)
    {
      const bool isHidden = rays.occluded(sensor.anchor, v.anchor(static_cast<std::size_t>(indices[k])));
      hidden |= static_cast<std::uint64_t>(isHidden) << k;
    }
    return hidden;
  }
  SegmentPacket packet;
  for (int first = 0; first < count; first += SegmentPacket::width)
  {
    const int size = std::min(SegmentPacket::width, count - first);
    fillPacket(v, sensor, indices + first, size, packet);
    hidden |= static_cast<std::uint64_t>(rays.occluded(packet, size)) << first;
  }
  return hidden;
}

void countPicks(const Picks& picks, std::uint64_t hidden, double total, const ShadowPicks& shadows)
{
  if (!shadows.counted)
    return;
  shadows.counted->possible += total;
  shadows.counted->tried += picks.count;
  for (int k = 0; k < picks.count; ++k)
    shadows.counted->seen += hidden >> k & 1 ? 0 : 1;
}

// A non-finite total becomes NaN in the sums and in the score, so that checkFinite() reports it.
double addNone(std::size_t bands, double* sum)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::fill_n(sum, bands, none);
  return none;
}

// As scoreTile(), of pairs with BRDF factors.
void scorePairs(const VertexSet& v, const PairBlock& block, float* luminous, TileScores& scores)
{
  scores.count = VertexTile{v, 0, block.count}.paddedCount();
  for (int i = 0; i < scores.count; ++i)
  {
    luminous[i] = i < block.count ? static_cast<float>(luminousScore(v, block, i)) : 0;
    scores.reached[i] = (i < lanes ? 0 : scores.reached[i - lanes]) + luminous[i];
    scores.largest = std::max(scores.largest, luminous[i]);
  }
}

// The general case: pairs with BRDF factors.
double addPickedPairs(const VertexSet& v, const Sensor& sensor, PairBlock& block, const ShadowPicks& shadows,
                      double* sum)
{
  if (!shadows.rays || shadows.picks == 0 || block.count <= shadows.picks)
  {
    if (shadows.rays)
      keepVisible(*shadows.rays, v, sensor, block);
    return addScores(v, block, sum);
  }
  TileScores scores{};
  float luminous[PairBlock::capacity];
  scorePairs(v, block, luminous, scores);
  const auto largest = static_cast<double>(scores.largest);
  const double total = scores.total();
  if (!std::isfinite(total))
    return addNone(v.flux.size(), sum);
  const Picks picks = pickSystematically(scores, total, shadows);
  int vertices[ShadowPicks::mostPicks];
  for (int k = 0; k < picks.count; ++k)
    vertices[k] = block.index[picks.index[k]];
  const std::uint64_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, picks.count);
  countPicks(picks, hidden, total, shadows);
  for (int k = 0; k < picks.count; ++k)
  {
    if (hidden >> k & 1)
      continue;
    const int i = picks.index[k], j = block.index[i];
    const double weight = picks.times[k] * total / shadows.picks / static_cast<double>(luminous[i]) *
                          static_cast<double>(block.kernel[i]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]) * block.factor[i][b];
  }
  return largest;
}

// A pick of one by u; false when nothing scores, or when the total is not finite. With pickSystematically() a solve
// took 1 % more instructions.
bool pickOne(const TileScores& scores, double u, int& i, double& total)
{
  double reached[lanes] = {};
  total = 0;
  for (int lane = 0; lane < lanes && scores.count > 0; ++lane)
    reached[lane] = total += static_cast<double>(scores.laneSum(lane));
  if (!std::isfinite(total))
    return false;
  const double threshold = u * total;
  for (int lane = 0; lane < lanes; ++lane)
    if (threshold < reached[lane])
    {
      i = firstBeyond(scores, lane, threshold - (lane > 0 ? reached[lane - 1] : 0));
      return true;
    }
  return false;
}

bool noScore(const VertexSet& v, ResampledScore& pick)
{
  addNone(v.flux.size(), pick.light.data());
  return true;
}

// The general case: pairs with BRDF factors.
bool pickPair(const VertexSet& v, const PairBlock& block, double u, ResampledScore& pick)
{
  TileScores scores{};
  float luminous[PairBlock::capacity] = {};
  scorePairs(v, block, luminous, scores);
  int i;
  double total;
  if (!pickOne(scores, u, i, total))
    return !std::isfinite(total) && noScore(v, pick);
  const auto j = static_cast<std::size_t>(block.index[i]);
  pick.target = v.anchor(j);
  const double weight = total / static_cast<double>(luminous[i]) * static_cast<double>(block.kernel[i]);
  for (std::size_t b = 0; b < v.flux.size(); ++b)
    pick.light[b] = weight * static_cast<double>(v.flux[b][j]) * block.factor[i][b];
  return true;
}
}  // namespace

double addResampledScores(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double share,
                          const ShadowPicks& shadows, double* sum)
{
  if (v.isGlossy() || sensor.brdf || shadows.picks == 0)
  {
    PairBlock block;
    formPairs(v, begin, count, sensor, share, block);
    return addPickedPairs(v, sensor, block, shadows, sum);
  }
  const VertexTile tile{v, begin, count};
  TileScores scores;
  scoreTile(tile, sensor, share, scores);
  const auto largest = static_cast<double>(scores.largest);
  const double total = scores.total();
  if (!std::isfinite(total))
    return addNone(v.flux.size(), sum);
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
  const Picks picks = pickSystematically(scores, total, shadows);
  int vertices[ShadowPicks::mostPicks];
  for (int k = 0; k < picks.count; ++k)
    vertices[k] = static_cast<int>(begin) + picks.index[k];
  const std::uint64_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, picks.count);
  countPicks(picks, hidden, total, shadows);
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

bool resampleOne(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double share, double u,
                 ResampledScore& pick)
{
  if (v.isGlossy() || sensor.brdf)
  {
    PairBlock block;
    formPairs(v, begin, count, sensor, share, block);
    return pickPair(v, block, u, pick);
  }
  TileScores scores;
  scoreTile({v, begin, count}, sensor, share, scores);
  int i;
  double total;
  if (!pickOne(scores, u, i, total))
    return !std::isfinite(total) && noScore(v, pick);
  const std::size_t j = begin + static_cast<std::size_t>(i);
  pick.target = v.anchor(j);
  for (std::size_t b = 0; b < v.flux.size(); ++b)
    pick.light[b] = total / static_cast<double>(v.luminous[j]) * static_cast<double>(v.flux[b][j]);
  return true;
}
}  // namespace kalos
