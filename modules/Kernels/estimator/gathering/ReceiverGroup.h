// SPDX-License-Identifier: BSD-3-Clause
// Groups of neighbouring receivers that share their gather rays.
//
// A hit y of one receiver's ray lights all of the group. The luminance at y is already known; each receiver needs one
// more shadow ray, an eighth of a gather ray's time. Receiver r weights a hit by G(r,y) V(r,y) / sum_k G(k,y)
// V(k,y) over all receivers k that send as many rays: the balance heuristic (Veach and Guibas 1995) over the receivers
// that could have hit y. So the estimate is unbiased for any group, and no MIS weight is above 1.
//
// Where y is too near to r for rays in single precision, r takes only the hits of its own rays, with weight 1.
#ifndef kalos_estimator_gathering_ReceiverGroup_h
#define kalos_estimator_gathering_ReceiverGroup_h

#include <vector>

#include "estimator/kernel/Sensor.h"
#include "scene/RayScene.h"

namespace kalos
{
class ReceiverGroup
{
public:
  static constexpr int capacity = SegmentPacket::width;

  int size() const { return this->Count; }
  std::size_t receiver(int k) const { return this->Receiver[k]; }

  /// Adds a receiver without BRDF.
  void add(std::size_t receiver, const Sensor& sensor);

  /// Each receiver's MIS weight for the light from the surface at y, hit by a ray of receiver `finder`, and its kernel
  /// G (1/m2), which is 0 where the weight is; `rays` null: nothing can occlude. `near`: to the finder.
  struct Shares
  {
    float share[capacity] = {}, kernel[capacity] = {};
  };
  Shares share(const Sensor& y, int finder, bool near, const RayScene* rays) const;

private:
  int Count = 0;
  Shares onlyFinder(const Sensor& y, int finder) const;

  std::size_t Receiver[capacity];
  Vec3 Position[capacity], Normal[capacity];
  AnchorPacket At = {};                   // a normal of 0, which sees nothing, of none
  alignas(64) float Near[capacity] = {};  // m2, see squaredNearness()
};

/// The receivers in an order that keeps neighbours of similar orientation together: by the
/// axis that the normal is nearest to, then along a curve that fills space (Morton 1966). On a grid of 64 x 64, sixteen
/// are a square of four; in rows they took 1.6 times longer to the same error on a floor, as long on walls.
std::vector<std::size_t> orderOf(const std::vector<Sensor>& sensors);
}  // namespace kalos

#endif
