// SPDX-License-Identifier: BSD-3-Clause
// Gather rays of many sensors under way together, step by step, so that their rays go in packets (scene/RayBatch.h).
// What each finds does not depend on the others.
#ifndef kalos_estimator_gathering_WavefrontGather_h
#define kalos_estimator_gathering_WavefrontGather_h

#include "estimator/gathering/GatherContext.h"
#include "scene/RayBatch.h"

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
        Later(gathering.blockShare(pool.trajectories, rayBlock))
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

  /// The same along a ray that is given, of a sensor without BRDF that met the surface point y.
  std::size_t follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y, const Start& start,
                     const SampleStream& random);

  /// Adds an estimate of all light at a sensor without BRDF but that of luminaires, lx per band: by a block of the
  /// pool's vertices, and by a gather ray that takes what these leave.
  std::size_t indirectLight(const Sensor& sensor, bool doublePrecision, const SampleStream& random);

  /// Follows all rays to their ends.
  void run();

  /// Forgets them, for others.
  void clear();

  /// What the ray of this index has found, per band, and the part of it that is exitance met by its first ray.
  const double* light(std::size_t i) const { return &this->Found[2 * i * this->Count]; }
  const double* emission(std::size_t i) const { return &this->Found[(2 * i + 1) * this->Count]; }

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
  // Where gather rays have come to, and what their sensor's light weighs.
  struct PathState
  {
    Sensor at;
    SampleStream random;
    Bands throughput;
    double share;
    bool seesEmission, doublePrecision, first;
    DirectionSample sampled;
  };
  std::size_t add(const Sensor& sensor, const Start& start, const SampleStream& random, bool first);
  bool draw(PathState& path) const;
  bool advance(std::size_t i, const SurfacePoint& y);
  void addEmission(std::size_t i, const SurfacePoint& y, double kernel, bool whole);
  bool survives(PathState& path) const;
  void addLuminaires(std::size_t i);
  void addVertices(std::size_t i, int blockSize);
  void addBlock(std::size_t i, const VertexSet& set, int blockSize, double share);
  void addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share, double weight);
  double* found(std::size_t i) { return &this->Found[2 * i * this->Count]; }
  void addWeighted(std::size_t i, const Bands& light);
  void addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light);
  void addSeen();

  const GatherContext& Rays;
  const GatherPool& Pool;
  std::size_t Count;  // of bands
  double Later;       // share of the rays after the first
  std::vector<PathState> Paths;
  std::vector<double> Found;                 // light and emission, by each
  std::vector<std::size_t> Active;           // that have not ended
  std::vector<ShadowRay> Shadows;            // to be traced
  std::vector<double> PendingContributions;  // what each of them adds
  std::vector<std::size_t> PendingPath;      // whose it is
};
}  // namespace kalos

#endif
