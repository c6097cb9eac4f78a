// SPDX-License-Identifier: BSD-3-Clause
// Light of paths that waits for its shadow rays, which are traced together.
#ifndef kalos_estimator_gathering_PendingLight_h
#define kalos_estimator_gathering_PendingLight_h

#include <vector>

#include "photometry/Bands.h"
#include "scene/RayBatch.h"

namespace kalos
{
class PendingLight
{
public:
  explicit PendingLight(std::size_t bands) : Count(bands) {}

  /// Light of a path, throughput times `light`, if its shadow ray meets nothing. `picked`: handed back by settle().
  void add(std::size_t path, const ShadowRay& ray, const Bands& throughput, const Bands& light, bool picked)
  {
    this->Rays.push_back(ray);
    this->Owners.push_back({path, picked});
    for (std::size_t b = 0; b < this->Count; ++b)
      this->Light.push_back(throughput[b] * light[b]);
  }

  /// Traces the rays and calls seen(path, light, picked) for what is not hidden; nothing waits then.
  template <class Seen>
  void settle(const RayScene& scene, const Seen& seen)
  {
    shadowTogether(scene, this->Rays);
    for (std::size_t k = 0; k < this->Rays.size(); ++k)
      if (!this->Rays[k].hidden)
        seen(this->Owners[k].path, &this->Light[k * this->Count], this->Owners[k].picked);
    this->Rays.clear();
    this->Owners.clear();
    this->Light.clear();
  }

private:
  struct Owner
  {
    std::size_t path;
    bool picked;
  };

  std::size_t Count;  // of bands
  std::vector<ShadowRay> Rays;
  std::vector<Owner> Owners;  // by ray
  std::vector<double> Light;  // by ray and band
};
}  // namespace kalos

#endif
