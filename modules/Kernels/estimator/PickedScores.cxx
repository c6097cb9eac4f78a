// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/PickedScores.h"

#include "estimator/Multiversion.h"

namespace kalos
{
namespace
{
constexpr int lane = 16;  // scores are summed in groups of this many

// score[i] = kernel[i] luminous[i], padded with zeros to whole groups; sum of every group; returns the largest score.
KALOS_MULTIVERSION
float weigh(const float* kernel, const float* luminous, int count, float* score, float* groups)
{
  for (int i = 0; i < count; ++i)
    score[i] = kernel[i] * luminous[i];
  for (int i = count; i < (count + lane - 1) / lane * lane; ++i)
    score[i] = 0;
  float largest[lane] = {};
  for (int g = 0; g * lane < count; ++g)
  {
    float parts[lane];
    for (int i = 0; i < lane; ++i)
    {
      parts[i] = score[g * lane + i];
      largest[i] = largest[i] > parts[i] ? largest[i] : parts[i];
    }
    // Halves are added to halves: vector additions, and the same order on every processor.
    for (int half = lane / 2; half > 0; half /= 2)
      for (int i = 0; i < half; ++i)
        parts[i] += parts[i + half];
    groups[g] = parts[0];
  }
  return *std::max_element(largest, largest + lane);
}

// Indices at which the cumulative score passes (k + u) total/picks, k = 0 .. picks-1; returns how many there are.
int pickSystematically(const float* score, const float* groups, int count, double total, const ShadowPicks& shadows,
                       int* picked)
{
  const double step = total / shadows.picks;
  int found = 0;
  double before = 0;
  for (int g = 0; g * lane < count && found < shadows.picks; ++g)
  {
    double reached = before;
    before += static_cast<double>(groups[g]);
    if (before <= (found + shadows.u) * step)
      continue;
    for (int i = g * lane; i < (g + 1) * lane && found < shadows.picks; ++i)
    {
      reached += static_cast<double>(score[i]);
      while (found < shadows.picks && score[i] > 0 && (found + shadows.u) * step < reached)
        picked[found++] = i;
    }
  }
  return found;
}

// Bit k is set when the k-th of these `count` <= 16 vertices is hidden from the sensor.
std::uint32_t hiddenVertices(const RayScene& rays, const VertexSet& v, const Sensor& sensor, const int* indices,
                             int count)
{
  if (count == 1)
  {
    const auto j = static_cast<std::size_t>(indices[0]);
    const double offset = v.offset[j];
    return rays.occluded(sensor.rayOrigin, v.position(j) + offset * v.normal(j));
  }
  SegmentPacket packet;
  fillPacket(v, sensor, indices, count, packet);
  return rays.occluded(packet, count);
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
  float scores[PairBlock::capacity], groups[PairBlock::capacity / lane], ones[PairBlock::capacity];
  std::fill_n(ones, block.count, 1.0f);
  double total = 0;
  for (int i = 0; i < block.count; ++i)
    scores[i] = static_cast<float>(luminousScore(v, block, i));
  const float largest = weigh(scores, ones, block.count, scores, groups);
  for (int g = 0; g * lane < block.count; ++g)
    total += static_cast<double>(groups[g]);
  int picked[SegmentPacket::width];
  const int count = pickSystematically(scores, groups, block.count, total, shadows, picked);
  if (count == 0)
    return static_cast<double>(largest);
  int vertices[SegmentPacket::width];
  for (int k = 0; k < count; ++k)
    vertices[k] = block.index[picked[k]];
  const std::uint32_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, count);
  for (int k = 0; k < count; ++k)
  {
    if (hidden >> k & 1)
      continue;
    const int i = picked[k], j = block.index[i];
    const double weight = total / shadows.picks / static_cast<double>(scores[i]) * static_cast<double>(block.kernel[i]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]) * block.factor[i][b];
  }
  return static_cast<double>(largest);
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
  alignas(64) float kernel[PairBlock::capacity], score[PairBlock::capacity], groups[PairBlock::capacity / lane];
  evaluateKernels(v, begin, count, sensor, share, kernel);
  const auto largest = static_cast<double>(weigh(kernel, &v.luminous[begin], count, score, groups));
  double total = 0;
  for (int g = 0; g * lane < count; ++g)
    total += static_cast<double>(groups[g]);
  if (!(total > 0))
    return 0;
  if (!shadows.rays)
  {
    for (std::size_t b = 0; b < v.flux.size(); ++b)
    {
      double all = 0;
      for (int i = 0; i < count; ++i)
        all += static_cast<double>(v.flux[b][begin + i]) * static_cast<double>(kernel[i]);
      sum[b] += all;
    }
    return largest;
  }
  int picked[SegmentPacket::width];
  const int found = pickSystematically(score, groups, count, total, shadows, picked);
  if (found == 0)
    return largest;
  int vertices[SegmentPacket::width];
  for (int k = 0; k < found; ++k)
    vertices[k] = static_cast<int>(begin) + picked[k];
  const std::uint32_t hidden = hiddenVertices(*shadows.rays, v, sensor, vertices, found);
  for (int k = 0; k < found; ++k)
  {
    if (hidden >> k & 1)
      continue;
    // total/picks is the luminous score of a pick; its bands are those of its vertex.
    const auto j = static_cast<std::size_t>(vertices[k]);
    const double weight = total / shadows.picks / static_cast<double>(v.luminous[j]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]);
  }
  return largest;
}
}  // namespace kalos
