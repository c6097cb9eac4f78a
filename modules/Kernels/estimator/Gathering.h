// SPDX-License-Identifier: BSD-3-Clause
// Gather rays: what a sensor sees of the surfaces around it, estimated where each ray ends.
#ifndef kalos_estimator_Gathering_h
#define kalos_estimator_Gathering_h

#include "estimator/DirectLight.h"
#include "estimator/MirrorImages.h"
#include "estimator/PickedScores.h"
#include "estimator/Pilot.h"
#include "estimator/Settings.h"
#include "estimator/Workers.h"

namespace kalos
{
/// The vertices of one replicate's round, annotated by the pilot, as gather rays use them.
struct GatherPool
{
  const VertexPool* vertices = nullptr;
  int trajectories = 0;  ///< that left them
};

class Gathering
{
public:
  Gathering(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows);

  const Pilot& pilot() const { return this->Density; }

  /// From now on rays meet no vertices: all light is found by paths that end late, estimator/PathTrial.h.
  void goAlone() { this->Alone = true; }
  bool alone() const { return this->Alone; }

  /// The vertices of trajectories [first, first + count) of every replicate, annotated by the pilot; of a sixteenth of
  /// them when alone, for the energy balance. None when aborted.
  std::vector<VertexPool> trace(const Emission& emission, const Walks& walks, int replicates, long long first,
                                int count, Workers& workers) const;

  struct Start
  {
    double share;       ///< gather rays of the sensor per trajectory that scores at it; infinite: no vertex does
    bool seesEmission;  ///< add (1 - a) of the exitance where the first ray ends; false when it is known exactly
  };

  /// One gather ray: the share 1 - a of the light that reaches the sensor from surfaces, lx per band weighted by its
  /// response. The illuminance where the ray ends is estimated by a block of the pool's vertices, the luminaires, and
  /// a gather ray of its own; ended by Russian roulette. The part that is exitance met by the first ray is added to
  /// `emission` too.
  Bands gather(const Sensor& sensor, const GatherPool& pool, const Start& start, SampleStream& random,
               Bands& emission) const;

  /// The same along a ray that is given, of a sensor without BRDF that met the surface point y.
  Bands follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y, const GatherPool& pool,
               const Start& start, SampleStream& random, Bands& emission) const;

  /// All light that reaches a sensor from luminaires, straight or by mirrors, with one shadow ray for the former.
  Bands luminaireLight(const Sensor& sensor, SampleStream& random) const;

  /// The same at up to SegmentPacket::width sensors without BRDF that are seen from afar: see DirectLight.
  void luminaireLight(const Sensor* sensors, int count, SampleStream& random, Bands* light) const;

  /// All other light at a sensor without BRDF, lx per band: by a block of the pool's vertices, and by a gather ray that
  /// takes what these leave.
  Bands indirectLight(const Sensor& sensor, const GatherPool& pool, SampleStream& random) const;

private:
  // Vertices scored where a gather ray ends, and for an estimate that many rays share. One of a block is picked for the
  // shadow ray, so that a larger block is hardly less noisy: 16 took 7 % less time than 64 on a floor, and 20 to 40 %
  // at a furnace's edges.
  static constexpr int rayBlock = 16, cellBlock = 256;
  static_assert(cellBlock <= VertexTile::capacity, "a block is scored as one tile");

  struct Ray
  {
    Vec3 direction;
    double density;  // per sr
    bool mirror;
  };
  // Where a chain of gather rays has come to, and what its sensor's light weighs.
  struct Chain
  {
    Sensor at;
    Bands throughput = uniformBands(1);
    double share;
    bool seesEmission, first = true;
  };
  // Follows a ray that has met y; false when the chain has ended.
  bool advance(Chain& chain, const Ray& ray, const SurfacePoint& y, const GatherPool& pool, SampleStream& random,
               Bands& sum, Bands& emission) const;
  void finish(Chain& chain, const GatherPool& pool, SampleStream& random, Bands& sum, Bands& emission) const;
  bool draw(const Sensor& sensor, SampleStream& random, Ray& ray, Bands& throughput) const;
  void addMirrored(const Sensor& sensor, Bands& light) const;
  double blockShare(int trajectories, int blockSize) const;  // infinite when alone
  void addVertexLight(const Sensor& sensor, const GatherPool& pool, int blockSize, SampleStream& random,
                      const Bands& throughput, Bands& sum) const;
  void scoreBlock(const Sensor& sensor, const VertexSet& set, int blockSize, double share, SampleStream& random,
                  Bands& sum) const;

  const Scene& Lit;
  Pilot Density;
  bool Shadows, Alone = false;
  int Picks;  // shadow rays to a block; 0: to every pair
  DirectLight Luminaires;
  MirrorImages Mirrored;
};
}  // namespace kalos

#endif
