// SPDX-License-Identifier: BSD-3-Clause
// Also known as: multiple importance sampling of gather rays and virtual point lights.
//
// What a gather ray finds beside a lamp grows without bound, and such spots are so small that rays find them by luck.
// Light vertices lie dense there. So each part of a surface's light is split between the two:
//
//   vertices take  A/(1 + B G),  gather rays the remainder;  A = max(0, 1 - D0/D),  B = 4 n/(N D)
//
// D: density of the vertices that carry this part of the light, per m2 and trajectory; G: kernel of the receiver;
// n: gather rays of its group; N: trajectories. D0 is four times the lower quartile G0 of the kernels where the
// receivers' rays end. Of each vertex's light the share A is drawn by keeping the vertex with probability A, so that
// few vertices score in an ordinary room.
//
// Any D keeps the estimate unbiased; one with E <= Phi D bounds the scores. For reflectance rho and total flux Phi:
//
//   singularity                               who draws it boundedly      bound of a score at the receiver
//   lamp near a surface, E unbounded          light vertices              of a gather ray: rho Phi (4 G0 + 4 G)/N
//   vertex near a receiver, G unbounded       gather rays                 of a vertex: rho E/(4 n)
//   small bright mesh that emits              its starts, as vertices     of a gather ray: Phi (4 G0 + 4 G)/N
//   spot of indirect light                    vertices, where the pilot's density resolves it
//   lamp near a surface, seen by a cell's     light vertices: the same density enters the balance heuristic of
//   own gather ray                            estimator/gathering/WavefrontGather.h
//   light of lamps by mirrors, glossy light   gather rays only: not bounded here
//
// Density: exact for the direct light of luminaires (Emission::firstHitDensity) and of emitting meshes; for later
// collisions the pilot's. Source: multiple importance sampling (Veach and Guibas 1995).
#ifndef kalos_estimator_gathering_BrightSpots_h
#define kalos_estimator_gathering_BrightSpots_h

#include "estimator/gathering/GatherContext.h"
#include "estimator/kernel/Sensor.h"

namespace kalos
{
class BrightSpots
{
public:
  /// How one part of a surface's light is split.
  struct Split
  {
    double least = 1;           ///< 1 - A
    double inverseDensity = 0;  ///< 1/D

    bool isShared() const { return this->least < 1; }

    /// MIS weight of gather rays of a receiver that sends `rays` per trajectory, as they count for G*.
    double gathered(double kernel, double rays) const
    {
      const double ratio = rays * kernel * this->inverseDensity;
      return (this->least + ratio) / (1 + ratio);
    }
  };

  explicit BrightSpots(const GatherContext& gathering) : Rays(gathering) {}

  /// Chooses D0 for these receivers.
  void prepare(const std::vector<Sensor>& sensors);

  bool any() const { return std::isfinite(this->Least); }

  /// Of light that vertices of this density carry.
  Split split(double density) const;

  /// The vertices of a round that take a share: each with probability A, by a random number u in [0,1).
  LightVertices select(const LightVertices& pool, double u) const;

private:
  void select(const VertexSet& from, double u, VertexSet& to) const;

  const GatherContext& Rays;
  double Least = std::numeric_limits<double>::infinity();  // D0
};
}  // namespace kalos

#endif
