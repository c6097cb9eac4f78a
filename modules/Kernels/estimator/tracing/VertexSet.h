// SPDX-License-Identifier: BSD-3-Clause
// Light vertices (virtual point lights): the collisions and starts of trajectories.
#ifndef kalos_estimator_tracing_VertexSet_h
#define kalos_estimator_tracing_VertexSet_h

#include <vector>

#include "scene/Scene.h"

namespace kalos
{
/// Vertices in structure-of-arrays form, single precision, about the scene's origin; fluxes as if the vertex's
/// trajectory were the only one. A Lambertian vertex sends its flux from p into the hemisphere about n. A glossy one
/// has its incident flux and the direction it comes from instead, and reflects by its material.
struct VertexSet
{
  std::vector<float> px, py, pz, nx, ny, nz;
  std::vector<float> lift, slope;      ///< of the anchor where shadow rays end
  std::vector<float> inverseDensity;   ///< m2 and trajectories per vertex about here; < 0: to be noted, 0: scored whole
  std::vector<float> firstHitDensity;  ///< Emission::firstHitDensity() of its luminaire; 0: not a first hit of one
  std::vector<float> luminous;         ///< lm, photometric total of the bands
  std::vector<std::vector<float>> flux;  ///< lm, one array per band
  std::vector<const Brdf*> brdf;         ///< of glossy vertices; empty in a Lambertian set
  std::vector<Vec3> incident;            ///< unit, towards where the light comes from; with brdf

  explicit VertexSet(int bands = 1) : flux(bands) {}
  std::size_t size() const { return this->px.size(); }
  bool isGlossy() const { return !this->brdf.empty(); }
  Vec3 position(std::size_t i) const { return {this->px[i], this->py[i], this->pz[i]}; }
  Vec3 normal(std::size_t i) const { return {this->nx[i], this->ny[i], this->nz[i]}; }
  RayAnchor anchor(std::size_t i) const  ///< where shadow rays to the vertex end
  {
    return {this->position(i), this->normal(i), this->lift[i], this->slope[i]};
  }

  /// An anchor rounded to single precision.
  static RayAnchor stored(const RayAnchor& at);

  /// A key for random streams, from the bits of the position.
  long long key(std::size_t i) const;

  void add(const RayAnchor& at, const Bands& fluxPerBand, double inverse = -1, double firstHits = 0);
  void addGlossy(const Scene& scene, const SurfacePoint& point, const Vec3& towardsLight, const Bands& incidentFlux,
                 double inverse = -1);
  void append(const VertexSet& other);
  void reorder(const std::vector<std::size_t>& order);  ///< vertex i becomes the one that was at order[i]
};
}  // namespace kalos

#endif
