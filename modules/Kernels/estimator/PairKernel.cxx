// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/PairKernel.h"

namespace kalos
{
namespace
{
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define KALOS_MULTIVERSION __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define KALOS_MULTIVERSION
#endif

struct FloatVector
{
  float x, y, z;
  explicit FloatVector(const Vec3& v)
      : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z))
  {
  }
};

// kernel = G / (1 + G share / density) of every vertex, 0 where one of the two looks away.
KALOS_MULTIVERSION
void evaluate(const float* px, const float* py, const float* pz, const float* nx, const float* ny, const float* nz,
              const float* inverseDensity, int count, FloatVector r, FloatVector n, float share, float* kernel)
{
  for (int i = 0; i < count; ++i)
  {
    const float dx = px[i] - r.x, dy = py[i] - r.y, dz = pz[i] - r.z;
    const float d2 = dx * dx + dy * dy + dz * dz;
    const float atSensor = dx * n.x + dy * n.y + dz * n.z;           // d cos(theta)
    const float atVertex = -(dx * nx[i] + dy * ny[i] + dz * nz[i]);  // d cos(theta')
    const float product = (atSensor > 0 ? atSensor : 0) * (atVertex > 0 ? atVertex : 0);
    // G = product / (pi d^4), so that G / (1 + G/G*) = product / (pi d^4 + product/G*).
    kernel[i] = product / (3.14159265f * d2 * d2 + product * share * inverseDensity[i] + 1e-30f);
  }
}

void evaluate(const VertexSet& v, std::size_t begin, int count, const Sensor& s, double share, float* kernel)
{
  evaluate(&v.px[begin], &v.py[begin], &v.pz[begin], &v.nx[begin], &v.ny[begin], &v.nz[begin], &v.inverseDensity[begin],
           count, FloatVector(s.position), FloatVector(s.normal), static_cast<float>(share), kernel);
}

// The general case, one pair at a time: a glossy vertex, a glossy sensor or both.
void formGlossyPairs(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double share,
                     PairBlock& block)
{
  const int bands = static_cast<int>(v.flux.size());
  block.count = 0;
  block.factor.clear();
  for (std::size_t j = begin; j < begin + count; ++j)
  {
    const Vec3 d = v.position(j) - sensor.position;
    const double d2 = dot(d, d);
    const Vec3 incident = (1 / std::sqrt(d2)) * d;
    const double atSensor = dot(incident, sensor.normal), atVertex = -dot(incident, v.normal(j));
    if (!(atSensor > 0 && atVertex > 0))
      continue;
    Bands factor = response(sensor, incident, bands);
    double lobe = 1;
    if (v.isGlossy())
    {
      const Bands f = v.brdf[j]->timesPi(v.normal(j), v.incident[j], -incident);
      lobe = lobeRatio(*v.brdf[j], v.normal(j), v.incident[j], f, bands);
      for (int b = 0; b < bands; ++b)
        factor[b] *= f[b];
    }
    const double gathered = gatherDensity(sensor, incident) * atVertex / d2;  // G, for a Lambertian sensor
    block.index[block.count] = static_cast<int>(j);
    block.kernel[block.count++] = static_cast<float>(
        atSensor * atVertex / (pi * d2) / (1 + lobe * gathered * share * static_cast<double>(v.inverseDensity[j])));
    block.factor.push_back(factor);
  }
}
}  // namespace

void formPairs(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double share, PairBlock& block)
{
  if (v.isGlossy() || sensor.brdf)
    return formGlossyPairs(v, begin, count, sensor, share, block);
  block.factor.clear();
  alignas(64) float kernel[PairBlock::capacity];
  evaluate(v, begin, count, sensor, share, kernel);

  // Compact without branches: most pairs of a convex room score, few of a furnished one do.
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    block.index[kept] = static_cast<int>(begin) + i;
    block.kernel[kept] = kernel[i];
    kept += kernel[i] > 0;
  }
  block.count = kept;
}

void formNearPairs(const VertexSet& v, std::size_t begin, int count, const Sensor& sensor, double reach,
                   PairBlock& block)
{
  formPairs(v, begin, count, sensor, 0, block);
  std::copy_n(block.kernel, block.count, block.plain);

  // Add the near ones that score nothing by the plain kernel; an altered one may see them.
  std::vector<char> scores(count, 0);
  for (int i = 0; i < block.count; ++i)
    scores[block.index[i] - begin] = 1;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 d = v.position(begin + i) - sensor.position;
    if (scores[i] || dot(d, d) >= reach * reach)
      continue;
    block.index[block.count] = static_cast<int>(begin) + i;
    block.kernel[block.count] = block.plain[block.count] = 0;
    ++block.count;
    if (v.isGlossy() || sensor.brdf)
      block.factor.push_back({});  // nothing is reflected below the horizon
  }
}

namespace
{
// Segments from the sensor to up to sixteen vertices; idle lanes repeat the last one.
template <class IndexOf>
void fillPacket(const VertexSet& v, const Sensor& sensor, int count, IndexOf indexOf, SegmentPacket& packet)
{
  const FloatVector o(sensor.rayOrigin);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    const int j = indexOf(std::min(i, count - 1));
    packet.ox[i] = o.x;
    packet.oy[i] = o.y;
    packet.oz[i] = o.z;
    packet.dx[i] = v.px[j] + v.offset[j] * v.nx[j] - o.x;
    packet.dy[i] = v.py[j] + v.offset[j] * v.ny[j] - o.y;
    packet.dz[i] = v.pz[j] + v.offset[j] * v.nz[j] - o.z;
  }
}
}  // namespace

void keepVisible(const RayScene& rays, const VertexSet& v, const Sensor& sensor, PairBlock& block)
{
  SegmentPacket packet;
  int kept = 0;
  for (int first = 0; first < block.count; first += SegmentPacket::width)
  {
    const int count = std::min(SegmentPacket::width, block.count - first);
    fillPacket(
        v, sensor, count, [&](int i) { return block.index[first + i]; }, packet);
    const std::uint32_t hidden = rays.occluded(packet, count);
    for (int i = 0; i < count; ++i)
    {
      block.index[kept] = block.index[first + i];
      block.kernel[kept] = block.kernel[first + i];
      block.plain[kept] = block.plain[first + i];
      if (!block.factor.empty())
        block.factor[kept] = block.factor[first + i];
      kept += !(hidden >> i & 1);
    }
  }
  block.count = kept;
}

namespace
{
// Luminous score of pair i, lx times the number of trajectories.
double luminousScore(const VertexSet& v, const PairBlock& block, int i)
{
  const int j = block.index[i];
  const double kernel = block.kernel[i];
  if (block.factor.empty())
    return kernel * static_cast<double>(v.luminous[j]);
  Bands score{};
  for (std::size_t b = 0; b < v.flux.size(); ++b)
    score[b] = block.factor[i][b] * static_cast<double>(v.flux[b][j]);
  return kernel * photometric(score, static_cast<int>(v.flux.size()));
}
}  // namespace

double addScores(const VertexSet& v, const PairBlock& block, double* sum)
{
  double largest = 0;
  for (int i = 0; i < block.count; ++i)
    largest = std::max(largest, luminousScore(v, block, i));
  for (std::size_t b = 0; b < v.flux.size(); ++b)
  {
    const float* flux = v.flux[b].data();
    double score = 0;
    for (int i = 0; i < block.count; ++i)
      score += static_cast<double>(flux[block.index[i]]) * static_cast<double>(block.kernel[i]) *
               (block.factor.empty() ? 1.0 : block.factor[i][b]);
    sum[b] += score;
  }
  return largest;
}

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

// Bit k is set when the k-th of `count` <= 16 vertices is hidden from the sensor.
template <class IndexOf>
std::uint32_t hiddenVertices(const RayScene& rays, const VertexSet& v, const Sensor& sensor, int count, IndexOf indexOf)
{
  if (count == 1)
  {
    const auto j = static_cast<std::size_t>(indexOf(0));
    const double offset = v.offset[j];
    return rays.occluded(sensor.rayOrigin, v.position(j) + offset * v.normal(j));
  }
  SegmentPacket packet;
  fillPacket(v, sensor, count, indexOf, packet);
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
  const std::uint32_t hidden =
      hiddenVertices(*shadows.rays, v, sensor, count, [&](int k) { return block.index[picked[k]]; });
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
  evaluate(v, begin, count, sensor, share, kernel);
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
  const std::uint32_t hidden =
      hiddenVertices(*shadows.rays, v, sensor, found, [&](int k) { return static_cast<int>(begin) + picked[k]; });
  for (int k = 0; k < found; ++k)
  {
    if (hidden >> k & 1)
      continue;
    // total/picks is the luminous score of a pick; its bands are those of its vertex.
    const std::size_t j = begin + static_cast<std::size_t>(picked[k]);
    const double weight = total / shadows.picks / static_cast<double>(v.luminous[j]);
    for (std::size_t b = 0; b < v.flux.size(); ++b)
      sum[b] += weight * static_cast<double>(v.flux[b][j]);
  }
  return largest;
}
}  // namespace kalos
