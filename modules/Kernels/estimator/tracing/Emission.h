// SPDX-License-Identifier: BSD-3-Clause
// Where trajectories start: luminaires and emitting triangles, chosen in proportion to their flux.
#ifndef kalos_estimator_tracing_Emission_h
#define kalos_estimator_tracing_Emission_h

#include <vector>

#include "sampling/SampleStream.h"
#include "scene/Scene.h"

namespace kalos
{
struct EmissionSample
{
  RayAnchor anchor;  ///< where the trajectory starts
  Vec3 direction;
  bool fromPoint = false;      ///< from a point luminaire
  bool onSurface = false;      ///< from a mesh (else from a luminaire, which has no body)
  std::size_t emitter = 0;     ///< the luminaire, when not onSurface
  std::uint32_t triangle = 0;  ///< of the mesh, when onSurface
  double density = 0;          ///< starts per m2 and trajectory about the position, on a mesh
  Bands weight;                ///< flux per band, lm, if this were the only trajectory
};

class Emission
{
public:
  explicit Emission(const Scene& scene);

  double totalFlux() const { return this->TotalFlux; }  ///< lm, photometric

  /// The share of the trajectories that start at an emitter: the luminaires, then the emitting triangles.
  double probability(std::size_t emitter) const;

  /// First hits of trajectories of a luminaire about a point p with normal n, per m2 and trajectory, if nothing hides
  /// the luminaire.
  double firstHitDensity(std::size_t luminaire, const Vec3& p, const Vec3& n) const;

  /// Draws an emitter, a point on it and a direction; every sample carries the whole photometric flux.
  EmissionSample sample(SampleStream& random) const;

private:
  struct Part
  {
    std::uint32_t triangle;
    std::array<Vec3, 3> corners;  // of it, or of what is not covered
  };
  // u: uniform in [0,1), left over from the choice of the emitter.
  EmissionSample fromLuminaire(std::size_t luminaire, double u, SampleStream& random) const;
  EmissionSample fromTriangle(const Part& part, double u, SampleStream& random) const;

  const Scene& Scene_;
  std::vector<Part> Parts;         // of the emitting triangles
  std::vector<double> Cumulative;  // flux up to and including luminaire or triangle i
  double TotalFlux = 0;
};
}  // namespace kalos

#endif
