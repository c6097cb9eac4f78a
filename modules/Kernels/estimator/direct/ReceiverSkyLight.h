// SPDX-License-Identifier: BSD-3-Clause
// The light of sky, ground and sun straight at the receivers.
#ifndef kalos_estimator_direct_ReceiverSkyLight_h
#define kalos_estimator_direct_ReceiverSkyLight_h

#include "estimator/direct/SkyLight.h"

namespace kalos
{
/// E = beta U + mean of w (V - beta), for sky with ground and for the sun apart. U is the unobstructed illuminance
/// (closed form for the sun and a uniform sky, else an integral), w the unobstructed score of a sampled direction, V
/// its visibility and beta the visible share that a pilot has found: so nothing fluctuates where nothing is hidden.
/// Below a share of one half beta is 0, for the sky's samples go through the openings then.
class ReceiverSkyLight
{
public:
  /// `closedForms` false: all is sampled.
  ReceiverSkyLight(const Scene& scene, const SkyOpenings* openings, const Walks& walks, bool closedForms);

  bool any() const { return this->Light.any(); }
  const SkyLight& light() const { return this->Light; }

  /// Call first, for all receivers.
  void start(const std::vector<Sensor>& sensors);

  /// Looks around from receiver r; returns beta U, lx. Receivers are independent.
  double prepare(std::size_t r, const Sensor& sensor);

  /// Whether the pilot has seen everything that U holds.
  bool isSteady(std::size_t r) const { return this->Views[r].steady; }

  /// beta U of receiver r, lx.
  double fixed(std::size_t r) const;

  /// w (V - beta) of one sample, lx.
  double sample(std::size_t r, const Sensor& sensor, SampleStream& random) const;

private:
  struct View
  {
    double sky = 0, sun = 0;                // U, lx
    double visibleSky = 0, visibleSun = 0;  // beta
    bool seesSun = false;                   // some of the disc is above the receiver's horizon and not all of it hidden
    bool steady = false;
    SkyLight::Mixture mixture;
  };
  double visibility(const Sensor& sensor, const Vec3& direction) const;  // 0 to 1, with what glass lets through
  double sampleSky(const View& view, const Sensor& sensor, SampleStream& random, double& w) const;
  double sampleSun(const Sensor& sensor, double u1, double u2, double& w) const;

  const Scene& Scene_;
  SkyLight Light;
  Walks Drawn;
  bool ClosedForms;
  std::vector<View> Views;
  std::vector<Vec3> Normals;         // of the receivers, without repetitions; empty when there are too many
  std::vector<double> Unobstructed;  // illuminance on each of these
};
}  // namespace kalos

#endif
