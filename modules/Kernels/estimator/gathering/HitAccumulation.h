// SPDX-License-Identifier: BSD-3-Clause
// Lights receivers by the hits of their gather rays.
//
// Where a ray has hit, the surface is lit by (M0 + rho E)/pi; E is the light of luminaires, evaluated at each hit, and
// the indirect light of the cell. It lights the receiver that sent the ray and its neighbours
// (estimator/gathering/ReceiverGroup.h).
#ifndef kalos_estimator_gathering_HitAccumulation_h
#define kalos_estimator_gathering_HitAccumulation_h

#include "estimator/gathering/BrightSpots.h"
#include "estimator/gathering/GatherHitTracer.h"
#include "estimator/gathering/InterpolationCheck.h"

namespace kalos
{
class HitAccumulation
{
public:
  /// All must outlive this.
  HitAccumulation(const GatherContext& gathering, const ReceiverDirectLight& direct, const GatherPlan& plan,
                  const BrightSpots& spots)
      : Rays(gathering), Direct(direct), Plan(plan), Spots(spots)
  {
  }

  /// Adds the light of a tile's hits to the tally, and what they say about the cells to `sums`.
  void add(std::size_t tile, const GatherHits& gathered, const CellShading& cells, Tally& tally,
           InterpolationCheck::Sums& sums) const;

private:
  // What the receivers of a group have found.
  struct GroupLight
  {
    double rays;  // of the group per trajectory, as they count for G*
    Bands sum[ReceiverGroup::capacity] = {}, emission[ReceiverGroup::capacity] = {};
    double largest[ReceiverGroup::capacity] = {};  // luminous
    PickCount picks[ReceiverGroup::capacity];
    double all = 0;  // luminous, of all receivers
  };
  // The light that leaves a hit, lx per band: reflected, emitted and, where it is split in another way than what is
  // reflected of other light, that of luminaires.
  struct HitLight
  {
    static constexpr int mostParts = 3;
    int parts = 2;
    bool isSplit = false;  // between gather rays and vertices
    Bands part[mostParts] = {};
    BrightSpots::Split split[mostParts];
    double luminous[mostParts];
    PickCount picks;  // for the cell
  };
  HitLight lightOf(const SurfaceHit& hit, const Sensor& at, const DirectLight::Sample& luminaires,
                   const CellShading& cells) const;
  double addHit(const SurfaceHit& hit, const Sensor& at, const HitLight& light, const ReceiverGroup& group,
                GroupLight& found) const;
  void store(const ReceiverGroup& group, const GroupLight& found, const GatherRound& round, Tally& tally) const;

  const GatherContext& Rays;
  const ReceiverDirectLight& Direct;
  const GatherPlan& Plan;
  const BrightSpots& Spots;
};
}  // namespace kalos

#endif
