// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/PairKernel.h"

namespace kalos
{
namespace
{
struct FloatVector
{
  float x, y, z;
  explicit FloatVector(const Vec3& v)
      : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z))
  {
  }
};

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
      const double kept = v.arrival[j] == Arrival::StraightOnPlane ? keptLobeShare(sensor, incident) : 1;
      const Bands f = v.brdf[j]->timesPi(v.normal(j), v.incident[j], -incident, kept);
      if (v.arrival[j] == Arrival::Scattered)
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
  if (v.isGlossy() || sensor.brdf || sensor.diffuseOf)
    return formGlossyPairs(v, begin, count, sensor, share, block);
  block.factor.clear();
  alignas(64) float kernel[PairBlock::capacity];
  evaluateKernels({v, begin, count}, sensor, share, kernel);

  // Compact without branches: most pairs score in a convex room, few in a furnished one.
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

  // Add near vertices whose plain kernel is 0; a regularized kernel may be positive.
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

void fillPacket(const VertexSet& v, const Sensor& sensor, const int* indices, int count, SegmentPacket& packet)
{
  AnchorPacket vertices;
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    const int j = indices[std::min(i, count - 1)];
    vertices.px[i] = v.px[j];
    vertices.py[i] = v.py[j];
    vertices.pz[i] = v.pz[j];
    vertices.nx[i] = v.nx[j];
    vertices.ny[i] = v.ny[j];
    vertices.nz[i] = v.nz[j];
    vertices.base[i] = v.lift[j];
    vertices.slope[i] = v.slope[j];
  }
  connect(sensor.anchor, vertices, packet);
}

void keepVisible(const RayScene& rays, const VertexSet& v, const Sensor& sensor, PairBlock& block)
{
  SegmentPacket packet;
  int kept = 0;
  auto isHidden = [&](int i) {
    return rays.occluded(sensor.anchor, v.anchor(static_cast<std::size_t>(block.index[i])));
  };
  for (int first = 0; first < block.count; first += SegmentPacket::width)
  {
    const int count = std::min(SegmentPacket::width, block.count - first);
    std::uint32_t hidden = 0;
    if (sensor.doublePrecision)
      for (int i = 0; i < count; ++i)
        hidden |= (isHidden(first + i) ? 1u : 0u) << i;
    else
    {
      fillPacket(v, sensor, block.index + first, count, packet);
      hidden = rays.occluded(packet, count);
    }
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
}  // namespace kalos
