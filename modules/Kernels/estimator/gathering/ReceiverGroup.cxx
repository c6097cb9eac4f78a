// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/ReceiverGroup.h"

#include <numeric>

#include "scene/RayBatch.h"

namespace kalos
{
void ReceiverGroup::add(std::size_t receiver, const Sensor& sensor)
{
  const int k = this->Count++;
  this->Receiver[k] = receiver;
  this->Position[k] = sensor.position;
  this->Normal[k] = sensor.normal;
  this->At.set(k, sensor.anchor);
  this->Near[k] = static_cast<float>(squaredNearness(sensor.anchor));
}

ReceiverGroup::Shares ReceiverGroup::onlyFinder(const Sensor& y, int finder) const
{
  const Vec3 d = y.position - this->Position[finder];
  const double squared = dot(d, d),
               product = std::max(0.0, dot(d, this->Normal[finder])) * std::max(0.0, -dot(d, y.normal));
  Shares shares;
  shares.share[finder] = 1;
  shares.kernel[finder] = static_cast<float>(product / (pi * squared * squared));
  return shares;
}

ReceiverGroup::Shares ReceiverGroup::share(const Sensor& y, int finder, bool near, const RayScene* rays) const
{
  if (near || this->Count == 1)
    return this->onlyFinder(y, finder);
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
    return this->onlyFinder(y, finder);
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
  constexpr auto perPi = static_cast<float>(1 / pi);
  Shares shares;
  auto take = [&](int k) {
    shares.share[k] = g[k] / sum;
    shares.kernel[k] = g[k] * perPi;
  };
  for (int i = 0; i < count; ++i)
    if (!(hidden >> i & 1))
      take(lane[i]);
  take(finder);
  return shares;
}

namespace
{
// The bits of a number below 2^20 with two zeros before each.
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t axisOf(const Vec3& n)
{
  const int axis = mainAxis(n);
  return 2 * static_cast<std::uint64_t>(axis) + ((axis == 0 ? n.x : axis == 1 ? n.y : n.z) < 0 ? 1 : 0);
}
}  // namespace

std::vector<std::size_t> orderOf(const std::vector<Sensor>& sensors)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), steps = (1 << 20) - 1;
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (const Sensor& s : sensors)
  {
    low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y), std::min(low.z, s.position.z)};
    high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y), std::max(high.z, s.position.z)};
  }
  const double extent = maxAbs(high - low), scale = extent > 0 ? steps / extent : 0;
  std::vector<std::uint64_t> key;
  key.reserve(sensors.size());
  for (const Sensor& s : sensors)
  {
    const Vec3 p = scale * (s.position - low);
    auto along = [](double x) { return spread(static_cast<std::uint64_t>(x)); };
    key.push_back(axisOf(s.normal) << 60 | along(p.x) | along(p.y) << 1 | along(p.z) << 2);
  }
  std::vector<std::size_t> order(sensors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  return order;
}
}  // namespace kalos
