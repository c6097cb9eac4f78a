// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RayPackets.h"

namespace kalos
{
void connect(const RayAnchor& from, const AnchorPacket& to, SegmentPacket& segments)
{
  auto single = [](double x) { return static_cast<float>(x); };
  const float px = single(from.point.x), py = single(from.point.y), pz = single(from.point.z);
  const float nx = single(from.normal.x), ny = single(from.normal.y), nz = single(from.normal.z);
  const float base = single(from.base), slope = single(from.slope);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    const float qx = to.px[i], qy = to.py[i], qz = to.pz[i], mx = to.nx[i], my = to.ny[i], mz = to.nz[i];
    const float here = base + slope * (std::abs(nx * qx) + std::abs(ny * qy) + std::abs(nz * qz));
    const float there = to.base[i] + to.slope[i] * (std::abs(mx * px) + std::abs(my * py) + std::abs(mz * pz));
    const float ox = px + here * nx, oy = py + here * ny, oz = pz + here * nz;
    segments.ox[i] = ox;
    segments.oy[i] = oy;
    segments.oz[i] = oz;
    segments.dx[i] = qx + there * mx - ox;
    segments.dy[i] = qy + there * my - oy;
    segments.dz[i] = qz + there * mz - oz;
  }
}
}  // namespace kalos
