// SPDX-License-Identifier: BSD-3-Clause
// Where trajectories start: luminaires, emitting triangles and the sky, chosen in proportion to their flux, or to their
// flux times a factor that a pilot has found (EmissionPilot.h).
#ifndef kalos_estimator_tracing_Emission_h
#define kalos_estimator_tracing_Emission_h

#include <vector>

#include "estimator/tracing/Portals.h"
#include "estimator/tracing/SkyEmission.h"
#include "sampling/SampleStream.h"
#include "scene/Scene.h"

namespace kalos
{
struct EmissionSample
{
  RayAnchor anchor;  ///< where the trajectory starts
  Vec3 direction;
  bool fromPoint = false;  ///< from a point luminaire
  bool fromSky = false;
  bool onSurface = false;      ///< from a mesh (else from a luminaire, which has no body)
  std::size_t emitter = 0;     ///< the luminaire, when not onSurface
  std::uint8_t stratum = 0;    ///< of the emitter
  std::uint32_t triangle = 0;  ///< of the mesh, when onSurface
  double density = 0;          ///< starts per m2 and trajectory about the position, on a mesh
  Bands weight;                ///< flux per band, lm, if this were the only trajectory
};

class Emission
{
public:
  /// `openings`, where the sky shines in, may be null: more of its light misses the scene then.
  explicit Emission(const Scene& scene, const SkyOpenings* openings = nullptr);

  /// What a pilot may change: emitters are drawn in proportion to flux times factor, and the vertices of each stratum
  /// are kept apart (VertexOrder.h), so that picks among the vertices of one do not miss those of another.
  struct Preference
  {
    std::vector<double> factors;       ///< > 0, one per emitter: the luminaires, parts of emitting triangles, the sky
    std::vector<std::uint8_t> strata;  ///< one per emitter
    std::string choice, reason;        ///< for the audit
  };
  void prefer(Preference preference);
  const Preference& preference() const { return this->Preferred; }
  /// Of trajectories that have passed a portal. Vertices have strata where there is more than one.
  static constexpr std::uint8_t beyondPortals = 255;
  bool hasStrata() const { return this->isGuided() || this->Through.any(); }
  bool isGuided() const { return !this->Preferred.factors.empty(); }

  std::size_t emitters() const { return this->Cumulative.size(); }
  double flux(std::size_t emitter) const;               ///< lm, photometric
  double totalFlux() const { return this->TotalFlux; }  ///< lm, photometric
  std::uint32_t triangle(std::size_t emitter) const { return this->Parts[emitter - this->luminaires()].triangle; }
  bool hasSky() const { return this->FromSky.flux() > 0; }
  std::size_t luminaires() const { return this->Scene_.data().luminaires.size(); }

  /// The share of the trajectories that start at an emitter.
  double probability(std::size_t emitter) const;

  /// First hits of trajectories of a luminaire about a point p with normal n, per m2 and trajectory, if nothing hides
  /// the luminaire; 0 for the sky.
  double firstHitDensity(std::size_t luminaire, const Vec3& p, const Vec3& n) const;

  /// Starts on an emitting triangle per m2 and trajectory.
  double startDensity(std::uint32_t triangle) const;

  /// Small openings that trajectories are sent through (PortalPilot.h).
  void send(Portals through) { this->Through = std::move(through); }
  const Portals& portals() const { return this->Through; }
  Portals::Mask portalsFor(const EmissionSample& start) const;
  /// The density per sr with which sample() draws a direction, at that start.
  double directionDensity(const EmissionSample& start, const Vec3& direction) const;

  /// Draws an emitter, a point on it and a direction. Where nothing is preferred, every sample carries the whole
  /// photometric flux, but those of the sky about that.
  EmissionSample sample(SampleStream& random) const;

private:
  struct Part
  {
    std::uint32_t triangle;
    std::array<Vec3, 3> corners;  // of it, or of what is not covered
  };
  // u: uniform in [0,1), left over from the choice of the emitter.
  EmissionSample fromLuminaire(std::size_t luminaire, double u, SampleStream& random) const;
  EmissionSample fromSky(double u, SampleStream& random) const;
  EmissionSample fromTriangle(std::size_t emitter, double u, SampleStream& random) const;
  double factor(std::size_t emitter) const { return this->isGuided() ? this->Preferred.factors[emitter] : 1; }
  void sum();

  const Scene& Scene_;
  SkyEmission FromSky;
  Preference Preferred;
  Portals Through;
  std::vector<Part> Parts;         // of the emitting triangles, in their order
  std::vector<double> Cumulative;  // flux times factor up to and including emitter i
  double TotalFlux = 0, TotalWeight = 0;
};
}  // namespace kalos

#endif
