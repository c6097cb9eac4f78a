// SPDX-License-Identifier: BSD-3-Clause
// Also known as: wavefront path tracing with next event estimation and MIS (balance heuristic).
//
// Advances the gather rays of many sensors together, one bounce at a time, so that they are traced in packets
// (scene/RayBatch.h). The result of each is independent of the others.
#ifndef kalos_estimator_gathering_WavefrontGather_h
#define kalos_estimator_gathering_WavefrontGather_h

#include "estimator/gathering/GatherContext.h"
#include "estimator/gathering/PendingLight.h"
#include "estimator/kernel/PickCount.h"

namespace kalos
{
class WavefrontGather
{
public:
  /// Both must outlive the wave.
  WavefrontGather(const GatherContext& gathering, const GatherPool& pool)
      : Rays(gathering),
        Pool(pool),
        Count(static_cast<std::size_t>(gathering.scene().bands())),
        Later(gathering.blockShare(pool.trajectories, rayBlock)),
        LaterStarts(gathering.startShare(pool.trajectories, rayBlock)),
        Pending(Count)
  {
  }

  struct Start
  {
    double share;       ///< gather rays of the sensor per trajectory that scores at it; infinite: no vertex does
    bool seesEmission;  ///< add (1 - a) of the exitance where the first ray ends; false when it is known exactly
    bool doublePrecision = false;  ///< the sensor lies in a gap: see isInGap()
  };

  /// Adds a gather ray: it finds the share 1 - a of the light that reaches the sensor from surfaces, lx per band
  /// weighted by its response. The illuminance where the ray ends is estimated by a block of the pool's vertices, the
  /// luminaires, and a gather ray of its own; ended by Russian roulette. Returns its index.
  std::size_t gather(const Sensor& sensor, const Start& start, const SampleStream& random);

  /// The same for a given ray of a sensor without BRDF, which hit the surface point y.
  std::size_t follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y, const Start& start,
                     const SampleStream& random);

  /// Adds an estimate of all light at a sensor without BRDF but that of luminaires, lx per band: by a block of the
  /// pool's vertices, and by a gather ray that takes what these leave.
  std::size_t indirectLight(const Sensor& sensor, bool doublePrecision, const SampleStream& random);

  /// Traces all rays until their paths end.
  void run();

  /// Clears the rays and results for the next batch.
  void clear();

  /// The light found by the ray of this index, per band, and the part that is exitance hit by its first segment.
  const double* light(std::size_t i) const { return &this->Found[2 * i * this->Count]; }
  const double* emission(std::size_t i) const { return &this->Found[(2 * i + 1) * this->Count]; }

  /// What picks of the block of vertices of an indirectLight() have seen, lx.
  const PickCount& picks(std::size_t i) const { return this->Picked[i]; }

private:
  // Vertices scored where a gather ray ends, and for an estimate that many rays share. One of a block is picked for the
  // shadow ray, so that a larger block is hardly less noisy: of 16, 64 and 256, 64 took 6 % less time than the others
  // to the same error on a floor; along an edge there was no difference.
  static constexpr int rayBlock = 64, cellBlock = 256;

  struct DirectionSample
  {
    Vec3 direction;
    double density;  // per sr
    bool mirror;
  };
  // The state of each gather ray's path.
  struct PathState
  {
    Sensor at;
    SampleStream random;
    Bands throughput;
    double share, startShare;  // as in Start; beside starts on emitting meshes
    bool seesEmission, doublePrecision, first;
    DirectionSample sampled;
  };
  std::size_t add(const Sensor& sensor, const Start& start, const SampleStream& random, bool first);
  bool draw(PathState& path) const;
  bool advance(std::size_t i, const SurfacePoint& y);
  void addEmission(std::size_t i, const SurfacePoint& y, double kernel);
  bool survives(PathState& path) const;
  // `ratio`: G/G* of the segment that led to the sensor.
  void addLuminaires(std::size_t i, double ratio);
  void addVertices(std::size_t i, int blockSize, bool counted = false);
  // `counted`: in Picked.
  void addBlock(std::size_t i, const VertexSet& set, int blockSize, double share, bool counted);
  void addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share, double weight,
              bool counted);
  double* found(std::size_t i) { return &this->Found[2 * i * this->Count]; }
  void addWeighted(std::size_t i, const Bands& light);
  void addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light, bool counted = false);
  void addSeen();

  const GatherContext& Rays;
  const GatherPool& Pool;
  std::size_t Count;          // of bands
  double Later, LaterStarts;  // shares of the rays after the first
  std::vector<PathState> Paths;
  std::vector<PickCount> Picked;    // by path
  std::vector<double> Found;        // light and emission, by each
  std::vector<std::size_t> Active;  // indices of paths that have not ended
  PendingLight Pending;
};
}  // namespace kalos

#endif
