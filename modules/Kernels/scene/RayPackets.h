// SPDX-License-Identifier: BSD-3-Clause
// Sixteen rays, or ends of rays, side by side, in single precision.
#ifndef kalos_scene_RayPackets_h
#define kalos_scene_RayPackets_h

#include <cstdint>

#include "scene/RayAnchor.h"

namespace kalos
{
/// Sixteen segments in structure-of-arrays form: from o to o + d.
struct alignas(64) SegmentPacket
{
  static constexpr int width = 16;
  float ox[width], oy[width], oz[width], dx[width], dy[width], dz[width];

  void set(int i, const Vec3& o, const Vec3& d)
  {
    this->ox[i] = static_cast<float>(o.x);
    this->oy[i] = static_cast<float>(o.y);
    this->oz[i] = static_cast<float>(o.z);
    this->dx[i] = static_cast<float>(d.x);
    this->dy[i] = static_cast<float>(d.y);
    this->dz[i] = static_cast<float>(d.z);
  }

  /// Between two anchors, both lifted.
  void set(int i, const RayAnchor& from, const RayAnchor& to)
  {
    const Vec3 o = from.liftedFor(to.point);
    this->set(i, o, to.liftedFor(from.point) - o);
  }

  void copy(int i, const SegmentPacket& from, int k)
  {
    this->ox[i] = from.ox[k];
    this->oy[i] = from.oy[k];
    this->oz[i] = from.oz[k];
    this->dx[i] = from.dx[k];
    this->dy[i] = from.dy[k];
    this->dz[i] = from.dz[k];
  }
};

/// Sixteen anchors, in the same form and precision.
struct alignas(64) AnchorPacket
{
  static constexpr int width = SegmentPacket::width;
  float px[width], py[width], pz[width], nx[width], ny[width], nz[width], base[width], slope[width];

  void set(int i, const RayAnchor& a)
  {
    this->px[i] = static_cast<float>(a.point.x);
    this->py[i] = static_cast<float>(a.point.y);
    this->pz[i] = static_cast<float>(a.point.z);
    this->nx[i] = static_cast<float>(a.normal.x);
    this->ny[i] = static_cast<float>(a.normal.y);
    this->nz[i] = static_cast<float>(a.normal.z);
    this->base[i] = static_cast<float>(a.base);
    this->slope[i] = static_cast<float>(a.slope);
  }

  /// Anchor i, lifted, as a point in free space.
  Vec3 point(int i) const
  {
    const RayAnchor a({this->px[i], this->py[i], this->pz[i]}, {this->nx[i], this->ny[i], this->nz[i]},
                      static_cast<double>(this->base[i]), static_cast<double>(this->slope[i]));
    return a.lifted();
  }
};

/// The segments from one anchor to sixteen, as SegmentPacket::set() makes them, in single precision.
void connect(const RayAnchor& from, const AnchorPacket& to, SegmentPacket& segments);

/// Where sixteen rays end. Of ray i: `triangle` is noTriangle when it ends nowhere, `distance` is in lengths of its
/// direction, u and v are as in Hit.
struct alignas(64) HitPacket
{
  static constexpr std::uint32_t noTriangle = ~0u;
  std::uint32_t triangle[SegmentPacket::width];
  float distance[SegmentPacket::width], u[SegmentPacket::width], v[SegmentPacket::width];
};
}  // namespace kalos

#endif
