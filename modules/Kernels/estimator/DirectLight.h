// SPDX-License-Identifier: BSD-3-Clause
// The illuminance that comes straight from luminaires and emitting meshes, apart from all reflections.
#ifndef kalos_estimator_DirectLight_h
#define kalos_estimator_DirectLight_h

#include <vector>

#include "estimator/PairKernel.h"

namespace kalos
{
/// Point luminaires: E = I(omega) cos(theta) V / d^2, deterministic.
///
/// Rectangles and emitting triangles: E = sum_k M_k F_k - (hidden part). F_k is the closed form of Lambert's polygon;
/// the hidden part is estimated by drawing an emitter in proportion to its luminous M_k F_k and a direction uniform in
/// its solid angle, scored only where a shadow ray is stopped. So there is no spike where a lamp touches the receiver,
/// no variance where nothing stands between, and no bias.
class DirectLight
{
public:
  /// `withMeshes` false leaves emitting triangles to the vertices of the trajectories (when there are very many).
  /// `shadows` false: nothing can occlude.
  DirectLight(const Scene& scene, bool withMeshes, bool shadows);

  /// What one receiver can see of each area emitter, were nothing in between; reused for all shadow samples.
  struct View
  {
    Bands points{};                  ///< lx, of the point luminaires, shadows included
    Bands areas{};                   ///< lx, unshadowed
    std::vector<double> cumulative;  ///< luminous unshadowed lx up to and including area emitter i
  };
  void look(const ReceiverPoint& receiver, View& view) const;

  /// One sample of the hidden part of View::areas, lx per band, added to `hidden`.
  void sampleHidden(const ReceiverPoint& receiver, const View& view, RandomStream& random, Bands& hidden) const;

  bool hasAreas() const { return !this->Areas.empty(); }

private:
  struct Area
  {
    Vec3 corner[4];
    int count;       // corners, 3 or 4
    Vec3 normal;     // light leaves on this side
    Bands exitance;  // lm/m2
  };

  Bands pointIlluminance(const Luminaire& luminaire, const ReceiverPoint& receiver) const;

  const Scene& Lit;
  bool Shadows;
  std::vector<Area> Areas;
};
}  // namespace kalos

#endif
