// SPDX-License-Identifier: BSD-3-Clause
// Also known as: photon mapping (Jensen 1996), progressive photon mapping (Hachisuka 2008; with rounds that are
// independent of each other, Knaus and Zwicker 2011). What programs such as DIALux evo show.
//
// Method `photon-map`: trajectories leave photons where they meet surfaces; indirect illuminance is their flux over the
// area of the disc that they lie on (estimator/methods/PhotonTree.h), direct illuminance is exact. At a receiver in the
// air the photons count that cross a disc about it.
//
// Radius: R falls as N^(-1/6) with the trajectories N of a replicate, so that bias^2, which grows as R^4, and variance,
// which grows as 1/(N R^2), fall together as N^(-2/3); a disc of that radius sees about 100 photons of 10 000
// trajectories. With Settings::epsilon it is that, and with MethodOptions::photons as far as the nearest photons
// reach; the bias then stays, however many trajectories follow. With MethodOptions::finalGather cosine-weighted rays
// leave the receiver, and the map is read where they end.
//
// Bias: the disc's part that no light reaches, beyond an edge or under a box, counts as dark: -50 % at a right-angled
// edge, -75 % in a corner, whatever the radius; and the curvature of E over the disc, second order in R. The audit
// states both as measured; receivers with more than a tenth of the disc off the surface are not trusted.
#ifndef kalos_estimator_methods_PhotonMap_h
#define kalos_estimator_methods_PhotonMap_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/gathering/GatherContext.h"
#include "estimator/methods/Estimator.h"
#include "estimator/methods/PhotonTree.h"

namespace kalos
{
class PhotonMap : public Estimator
{
public:
  PhotonMap(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t receiver, long long trajectories) const override;
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  Pace pace() const override;
  void exchange(const Ranks& ranks) override;
  void persist(Archive& archive) override { archive.array(this->Checks); }
  std::vector<AuditLine> audit() const override;

private:
  // Luminous sums over the receivers of one replicate and tile, lx, and of what the map is off by.
  struct Check
  {
    double sum = 0, beyond = 0, curved = 0;
  };
  // Discs about the receivers in the air, for the rays that cross them.
  struct AirDiscs
  {
    std::vector<std::size_t> receivers;
    std::unique_ptr<RayScene> squares;  // two triangles each
  };

  // A replicate's photons of a round, and how gather rays read them.
  struct Reading
  {
    const PhotonTree& photons;
    PhotonLookup lookup;
    int trajectories;
  };

  double radiusAfter(long long trajectories) const;  // of a replicate, m
  bool readsMap(std::size_t r) const;                // at the receiver itself
  PhotonLookup lookup(double radius, bool firstOfMeshes) const;
  AirDiscs airDiscs(double radius, const Tally& tally) const;
  PhotonTree trace(int replicate, long long first, int count, double radius, const AirDiscs& discs, Tally& tally) const;
  void scoreCrossings(const Segment& segment, int replicate, double radius, const AirDiscs& discs, Tally& tally) const;
  void scoreMap(std::size_t r, int replicate, const PhotonTree& map, double radius, Check& check, Tally& tally) const;
  void gather(std::size_t r, int replicate, long long first, int count, const PhotonTree& map, double radius,
              Tally& tally) const;
  // pi times the luminance that a gather ray from a receiver meets, and the part that is exitance seen straight.
  struct Seen
  {
    Bands light{}, exitance{};
  };
  Seen lookAlong(const Sensor& from, Vec3 direction, bool seesEmission, const Reading& map, SampleStream& random) const;
  // Share of the disc of this radius about a receiver that lies on the surface in its sight.
  double coverage(const Sensor& sensor, double radius) const;

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  GatherContext Rays;
  int Replicates = 0;
  double FirstRadius;                       // m, after one trajectory
  std::vector<char> OnSurface;              // per receiver
  std::vector<float> Covered, HalfCovered;  // share of the disc, and of that of half the radius, per receiver
  std::vector<Check> Checks;                // per tile and replicate
};
}  // namespace kalos

#endif
