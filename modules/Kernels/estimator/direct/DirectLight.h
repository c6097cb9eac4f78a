// SPDX-License-Identifier: BSD-3-Clause
// Direct illuminance, from luminaires and emitting meshes without reflections.
#ifndef kalos_estimator_direct_DirectLight_h
#define kalos_estimator_direct_DirectLight_h

#include <vector>

#include "estimator/direct/LightSampler.h"
#include "estimator/direct/LuminousArea.h"
#include "sampling/SampleStream.h"

namespace kalos
{
/// Point luminaires: E = I(omega) cos(theta) V / d^2, deterministic. So are luminous openings of measured luminaires
/// for sensors that are not near (see isNear); near by they are areas of luminance I(omega) / (A cos(theta')), with A
/// the opening's area, and wholly sampled.
///
/// Rectangles and emitting triangles: E = beta U + mean of w (V - beta). U = sum of M_k F_k is the closed form of
/// Lambert's polygon, unshadowed; a sample draws an emitter in proportion to its luminous M_k F_k and a direction
/// uniform in its solid angle, w is its unshadowed score and V its visibility; beta is the visible share, from samples
/// used nowhere else. So there is no spike where a lamp touches the receiver, no variance where the emitters are fully
/// visible or fully hidden, and no bias.
class DirectLight
{
public:
  /// `withMeshes` false leaves emitting triangles to the vertices of the trajectories (when there are very many).
  /// `shadows` false: nothing can occlude.
  DirectLight(const Scene& scene, bool withMeshes, bool shadows);

  /// The emitters as seen from one receiver; reused for all its samples.
  struct View
  {
    Bands points{};                  ///< lx, of the point luminaires, shadows included
    Bands areas{};                   ///< U, lx, unshadowed
    double visibleShare = 1;         ///< beta; to be set by the caller where surfaces may occlude
    std::vector<double> cumulative;  ///< what area emitters are drawn in proportion to, up to and including emitter i
  };
  void prepareView(const Sensor& sensor, View& view) const;

  /// One sample of the area emitters: w (lx per band). Returns V - beta, or V for an opening, which U does not hold.
  double sampleAreas(const Sensor& sensor, const View& view, SampleStream& random, Bands& w) const;

  /// One sample of all direct light at the sensor, weighted by its response, with a single shadow ray: an emitter is
  /// drawn about in proportion to its unshadowed light at a Lambertian sensor (LightSampler).
  /// At a glossy sensor a direction drawn from its lobe is combined with the areas by MIS (balance heuristic), for
  /// lobes narrower than a lamp. Unbiased; for the vertices that gather rays find and for glossy sensors. Of luminaires
  /// only, without meshes.
  Bands sample(const Sensor& sensor, SampleStream& random) const;

  /// The contribution of sample() if nothing hides its target; false when it is 0 in any case.
  struct Sample
  {
    RayAnchor target;
    Bands light;            ///< lx per band, weighted by the sensor's response
    std::size_t luminaire;  ///< that was drawn
  };
  /// The same without the shadow ray; the lobe's sample traces its own shadow rays and is added to `known`.
  bool sampleUnshadowed(const Sensor& sensor, SampleStream& random, Sample& sample, Bands& known) const;

  /// Samples at `count` <= SegmentPacket::width sensors without BRDF, their shadow rays in one packet, in single
  /// precision: for sensors that are seen from so far that a narrow gap does not matter. No light where it is hidden.
  void sample(const Sensor* sensors, int count, SampleStream& random, Sample* samples) const;

  /// Adds throughput times the exitance of every luminous rectangle that a ray from a mirror passes through before it
  /// ends at y.
  void addSeen(const Vec3& origin, const Vec3& direction, const SurfacePoint& y, const Bands& throughput,
               double* sum) const;

  /// Whether samples add to what prepareView() finds: something may hide area emitters, or openings are near.
  bool hasOpenings() const { return this->HasOpenings; }
  bool fluctuates() const { return this->HasOpenings || (this->Shadows && !this->Areas.empty()); }

private:
  double pointIlluminance(const Luminaire& luminaire, const Sensor& sensor) const;  // unshadowed, lx; 0 for areas
  bool shinesAt(const LuminousArea& area, const Sensor& sensor) const;      // as an area, from the side that is lit
  double formFactor(const LuminousArea& area, const Sensor& sensor) const;  // unshadowed, 0 where it does not shine
  void weigh(const Sensor& sensor, LuminaireWeights& weights) const;        // of luminaires, by which sample() draws

  // The contribution of sample() if nothing hides it; false when it is 0. A lobe's sample goes to `lobe`.
  bool aim(const Sensor& sensor, SampleStream& random, AreaSample& sample, Bands& arriving, Bands& lobe) const;
  void sampleLobe(const Sensor& sensor, SampleStream& random, const LuminaireWeights& weights, Bands& sum) const;

  static constexpr std::size_t noArea = ~std::size_t{0};

  const Scene& Scene_;
  bool Shadows;
  bool HasOpenings = false;
  std::vector<LuminousArea> Areas;
  std::vector<std::size_t> LuminaireOf, AreaOf;  // of an area that belongs to no mesh; of a luminaire, or noArea
  LightSampler Choice;
};
}  // namespace kalos

#endif
