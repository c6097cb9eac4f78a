// SPDX-License-Identifier: BSD-3-Clause
// Also known as: photon map (Jensen 1996); kernel density estimation of incident flux.
//
// The photons of one replicate's round, which lie where trajectories met surfaces, and the illuminance that they stand
// for at a point: E = sum of k(d_i) w_i over the photons within a radius R on surfaces that face the same way.
// Constant filter k = 1/(pi R2), cone filter k = 3 (1 - d/R)/(pi R2). The kd-tree is nanoflann's.
#ifndef kalos_estimator_methods_PhotonTree_h
#define kalos_estimator_methods_PhotonTree_h

#include <memory>

#include "estimator/kernel/Sensor.h"

namespace kalos
{
/// How photons are looked up.
struct PhotonLookup
{
  double radius = 0;           ///< m; with `nearest` the largest one
  int nearest = 0;             ///< so many photons at most: R is the distance of the last, which itself is left out
  bool cone = false;           ///< the cone filter
  bool firstOfMeshes = false;  ///< count photons straight from emitting meshes
};

/// What a look-up found: lx per band if each trajectory were the only one.
struct PhotonEstimate
{
  Bands light{};
  Bands direct{};         ///< of that, straight from emitting meshes
  double halfRadius = 0;  ///< photometric, from the photons within R/2 alone
  double largest = 0;     ///< photometric score of one photon
};

class PhotonTree
{
public:
  explicit PhotonTree(int bands);
  ~PhotonTree();
  PhotonTree(PhotonTree&&) noexcept;
  PhotonTree& operator=(PhotonTree&&) noexcept;

  /// Adds flux that arrives at a surface point; `firstOfMesh`: straight from an emitting mesh.
  void add(const SurfacePoint& point, const Vec3& towardsLight, const Bands& weight, bool firstOfMesh);

  /// Builds the tree. Call once, after the last photon.
  void build();

  /// The light at a sensor on a surface, weighted by its response.
  PhotonEstimate estimate(const Sensor& sensor, const PhotonLookup& lookup) const;

private:
  struct Photons;
  std::unique_ptr<Photons> Impl;
};
}  // namespace kalos

#endif
