// SPDX-License-Identifier: BSD-3-Clause
// Gather rays: what a sensor sees of the surfaces around it, estimated where each ray ends.
#ifndef kalos_estimator_Gathering_h
#define kalos_estimator_Gathering_h

#include "estimator/DirectLight.h"
#include "estimator/PairKernel.h"
#include "estimator/Trajectories.h"

namespace kalos
{
/// The vertices of one replicate's round, as gather rays use them.
struct GatherPool
{
  const VertexPool* vertices = nullptr;
  int trajectories = 0;  ///< that left them
};

/// Vertices expected per m2 and trajectory: the density against which gather rays are balanced. Taken from a pilot
/// whose random numbers are used nowhere else, so that the weights do not depend on what they weigh.
struct CollisionDensity
{
  double reflected = 0;                      ///< of collisions, Lambertian and glossy
  double emitted = 0;                        ///< of starts on emitting meshes, per m2 of those
  double surfaceArea = 0, emittingArea = 0;  ///< m2
};
CollisionDensity measureDensity(const Scene& scene, const Emission& emission, std::uint64_t seed);

/// G* (1/m2) of a sensor that vertices score at: a = 1/(1 + G/G*) is what they keep, 1 - a is gathered.
struct PairLimits
{
  double reflected, emitted;
};

class Gathering
{
public:
  Gathering(const Scene& scene, const CollisionDensity& density, bool shadows);

  /// Balance heuristic for a sensor scored by all vertices of `trajectories` that sends `rays` gather rays.
  PairLimits limits(double trajectories, double rays) const;

  struct Start
  {
    PairLimits limits;
    bool seesEmission;  ///< add (1 - a) of the exitance where the first ray ends; false when it is known exactly
    double u1, u2;      ///< direction of the first ray, in [0,1)
  };

  /// One gather ray: the share 1 - a of the light that reaches the sensor from surfaces, lx per band weighted by its
  /// response. The illuminance where the ray ends is estimated by a block of the pool's vertices, the luminaires, and
  /// a gather ray of its own; ended by Russian roulette. The part that is exitance met by the first ray is added to
  /// `emission` too.
  Bands gather(const Sensor& sensor, const GatherPool& pool, const Start& start, RandomStream& random,
               Bands& emission) const;

private:
  static constexpr int blockSize = 128;  // vertices scored where a gather ray ends

  struct Ray
  {
    Vec3 direction;
    double density;  // per sr
    bool mirror;
  };
  bool draw(const Sensor& sensor, double u1, double u2, RandomStream& random, Ray& ray, Bands& throughput) const;
  PairLimits blockLimits(int trajectories) const;
  void addVertexLight(const Sensor& sensor, const GatherPool& pool, RandomStream& random, const Bands& throughput,
                      Bands& sum) const;
  void scoreBlock(const Sensor& sensor, const VertexSet& set, double limit, RandomStream& random, Bands& sum) const;

  const Scene& Lit;
  CollisionDensity Density;
  bool Shadows;
  DirectLight Luminaires;
};
}  // namespace kalos

#endif
