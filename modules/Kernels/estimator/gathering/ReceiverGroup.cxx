// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/ReceiverGroup.h"

#include "scene/RayBatch.h"

namespace kalos
{
void ReceiverGroup::add(std::size_t receiver, const Sensor& sensor)
{
  const int k = this->Count++;
  this->Receiver[k] = receiver;
  this->At.set(k, sensor.anchor);
  this->Near[k] = static_cast<float>(squaredNearness(sensor.anchor));
}

void ReceiverGroup::share(const Sensor& y, int finder, bool near, const RayScene* rays, float* shares) const
{
  std::fill_n(shares, capacity, 0.0f);
  shares[finder] = 1;
  if (near || this->Count == 1)
    return;
  alignas(64) float g[capacity];
  const auto px = static_cast<float>(y.position.x), py = static_cast<float>(y.position.y),
             pz = static_cast<float>(y.position.z), nx = static_cast<float>(y.normal.x),
             ny = static_cast<float>(y.normal.y), nz = static_cast<float>(y.normal.z);
  for (int k = 0; k < capacity; ++k)
  {
    const float dx = px - this->At.px[k], dy = py - this->At.py[k], dz = pz - this->At.pz[k];
    const float squared = dx * dx + dy * dy + dz * dz;
    const float here = dx * this->At.nx[k] + dy * this->At.ny[k] + dz * this->At.nz[k],
                there = -(dx * nx + dy * ny + dz * nz);
    const bool sees = here > 0 && there > 0 && squared > this->Near[k];
    g[k] = sees ? here * there / (squared * squared) : 0;
  }
  if (!(g[finder] > 0))
    return;
  std::uint32_t hidden = 0;
  int lane[capacity], count = 0;
  SegmentPacket all, packet;
  connect(y.anchor, this->At, all);
  for (int k = 0; k < this->Count; ++k)
    if (k != finder && g[k] > 0)
    {
      packet.copy(count, all, k);
      lane[count++] = k;
    }
  if (rays && count > 0)
    hidden = rays->occluded(packet, count);
  float sum = g[finder];
  for (int i = 0; i < count; ++i)
    if (!(hidden >> i & 1))
      sum += g[lane[i]];
  for (int i = 0; i < count; ++i)
    shares[lane[i]] = hidden >> i & 1 ? 0 : g[lane[i]] / sum;
  shares[finder] = g[finder] / sum;
}
}  // namespace kalos
