// SPDX-License-Identifier: BSD-3-Clause
// Bright spots that point luminaires throw on surfaces near them, and whether gather rays have seen them.
#ifndef kalos_estimator_tally_HotSpots_h
#define kalos_estimator_tally_HotSpots_h

#include "estimator/kernel/Sensor.h"

namespace kalos
{
/// A lamp at distance d from a surface lights an area of about pi d^2 with much of its flux. A gather ray finds that
/// area with probability G pi d^2. Where that is rare, the replicates agree about what they all have missed, and their
/// spread says nothing about it.
///
/// Rays drawn from the lamps by their intensity say where their light falls. Rule: a receiver's interval is not to be
/// trusted where spots that fewer than `fewestRays` of its gather rays are expected to find send it more than
/// `largestShare` of the light that is known of.
class HotSpots
{
public:
  static constexpr double fewestRays = 16, largestShare = 0.02;

  /// `receivers` bounds what the look costs: where there are many, fewer rays leave the lamps.
  HotSpots(const Scene& scene, std::size_t receivers);

  /// Whether `rays` gather rays have seen the spots that light the sensor, which also has so much direct light, lx.
  bool areSeen(const Sensor& sensor, double rays, double direct) const;

private:
  struct Spot
  {
    Vec3 position, normal;
    double flux;  // lm that leave it
    double area;  // m2
  };
  std::vector<Spot> Spots;
};
}  // namespace kalos

#endif
