// SPDX-License-Identifier: BSD-3-Clause
// Receivers beside each other that share their gather rays.
//
// Where a ray of one ends, all are lit: the light that leaves y is there already, and what is missing is a shadow ray
// to each, an eighth of a gather ray's time. Receiver r takes from a hit the share G(r,y) V(r,y) / sum_k G(k,y) V(k,y)
// over all receivers k that send as many rays: the balance heuristic (Veach and Guibas 1995) over the ways in which y
// could have been found. So every receiver's mean is right, whatever the group, and no share is above 1.
//
// Where y is so near to r that rays in single precision do not serve, r takes the hits of its own rays alone, whole.
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

  /// What each receiver takes of the light that leaves the surface at y, where a ray of receiver `finder` has ended;
  /// `rays` null: nothing can occlude. `near`: to the finder. `shares` has room for `capacity`, 0 for those that are
  /// not.
  void share(const Sensor& y, int finder, bool near, const RayScene* rays, float* shares) const;

private:
  int Count = 0;
  std::size_t Receiver[capacity];
  AnchorPacket At = {};                   // a normal of 0, which sees nothing, of none
  alignas(64) float Near[capacity] = {};  // m2, see squaredNearness()
};

/// The receivers in an order in which those that follow each other lie beside each other and look the same way: by the
/// axis that the normal is nearest to, then along a curve that fills space (Morton 1966). On a grid of 64 x 64, sixteen
/// are a square of four; in rows they took 1.6 times longer to the same error on a floor, as long on walls.
std::vector<std::size_t> orderOf(const std::vector<Sensor>& sensors);
}  // namespace kalos

#endif
