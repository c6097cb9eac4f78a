// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of the light of sky, ground and sun, which enter through the openings.
#ifndef kalos_estimator_tracing_SkyEmission_h
#define kalos_estimator_tracing_SkyEmission_h

#include <memory>

#include "scene/SkyOpenings.h"

namespace kalos
{
/// Draws straight lines, not only directions: a point of an opening and a direction about in proportion to what shines
/// through its face; or, for one line in ten, a direction of the sky and a point of the disc across it that has the
/// scene in its shadow. The weight is the luminance over the density of all these ways to draw the line, so that it
/// does not depend on which one drew it. Each line is followed from outside of the scene on.
class SkyEmission
{
public:
  SkyEmission(const Scene& scene, const SkyOpenings* openings);

  /// lm, about what enters; the share of the trajectories that start from the sky is chosen by it.
  double flux() const { return this->Flux; }

  struct Line
  {
    Vec3 start, direction;  ///< of the light
    double weight = 0;      ///< lm
  };
  /// u0 chooses among the ways to draw the line.
  Line sample(double u0, double u1, double u2, double u3, double u4) const;

private:
  // Of the directions towards the sky that leave through a face of the box, or of all.
  struct Source
  {
    const DirectionTable* sky = nullptr;
    double sun = 0;  // probability of the sun
  };
  bool draw(const Source& source, double u1, double u2, Vec3& direction) const;
  double density(const Source& source, const Vec3& direction) const;
  double density(const Vec3& p, const Vec3& direction) const;  // of a line, per m2 across it and sr

  const Scene& Scene_;
  const SkyOpenings* Openings;
  double Radius = 0, Flux = 0, OfOpenings = 0;  // m, lm, probability
  Source All, Faces[6];
  std::vector<std::unique_ptr<DirectionTable>> Tables;  // of the faces
  std::vector<double> Cumulative;                       // flux up to and including opening i, lm
};
}  // namespace kalos

#endif
