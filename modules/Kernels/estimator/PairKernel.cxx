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

// G of every vertex, 0 where one of them looks away.
KALOS_MULTIVERSION
void evaluate(const float* px, const float* py, const float* pz, const float* nx, const float* ny, const float* nz,
              int count, const float* r, const float* n, float* g)
{
  const float rx = r[0], ry = r[1], rz = r[2], mx = n[0], my = n[1], mz = n[2];
  for (int i = 0; i < count; ++i)
  {
    const float dx = px[i] - rx, dy = py[i] - ry, dz = pz[i] - rz;
    const float d2 = dx * dx + dy * dy + dz * dz;
    const float atReceiver = dx * mx + dy * my + dz * mz;            // d cos(theta)
    const float atVertex = -(dx * nx[i] + dy * ny[i] + dz * nz[i]);  // d cos(theta')
    const float product = (atReceiver > 0 ? atReceiver : 0) * (atVertex > 0 ? atVertex : 0);
    g[i] = product / (3.14159265f * d2 * d2 + 1e-30f);
  }
}
}  // namespace

void formPairs(const VertexSet& v, std::size_t begin, int count, const ReceiverPoint& receiver, PairBlock& block)
{
  const float r[3] = {static_cast<float>(receiver.position.x), static_cast<float>(receiver.position.y),
                      static_cast<float>(receiver.position.z)};
  const float n[3] = {static_cast<float>(receiver.normal.x), static_cast<float>(receiver.normal.y),
                      static_cast<float>(receiver.normal.z)};
  alignas(64) float g[PairBlock::capacity];
  evaluate(&v.px[begin], &v.py[begin], &v.pz[begin], &v.nx[begin], &v.ny[begin], &v.nz[begin], count, r, n, g);

  // Compact without branches: most pairs of a convex room score, few of a furnished one do.
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    block.index[kept] = static_cast<int>(begin) + i;
    block.g[kept] = g[i];
    kept += g[i] > 0;
  }
  block.count = kept;
}

void keepVisible(const RayScene& rays, const VertexSet& v, const ReceiverPoint& receiver, PairBlock& block)
{
  const float ox = static_cast<float>(receiver.rayOrigin.x), oy = static_cast<float>(receiver.rayOrigin.y),
              oz = static_cast<float>(receiver.rayOrigin.z);
  SegmentPacket packet;
  int kept = 0;
  for (int first = 0; first < block.count; first += SegmentPacket::width)
  {
    const int count = std::min(SegmentPacket::width, block.count - first);
    for (int i = 0; i < SegmentPacket::width; ++i)
    {
      const int j = block.index[first + std::min(i, count - 1)];  // idle lanes repeat the last segment
      packet.ox[i] = ox;
      packet.oy[i] = oy;
      packet.oz[i] = oz;
      packet.dx[i] = v.px[j] + v.offset[j] * v.nx[j] - ox;
      packet.dy[i] = v.py[j] + v.offset[j] * v.ny[j] - oy;
      packet.dz[i] = v.pz[j] + v.offset[j] * v.nz[j] - oz;
    }
    const std::uint32_t hidden = rays.occluded(packet, count);
    for (int i = 0; i < count; ++i)
    {
      block.index[kept] = block.index[first + i];
      block.g[kept] = block.g[first + i];
      kept += !(hidden >> i & 1);
    }
  }
  block.count = kept;
}
}  // namespace kalos
