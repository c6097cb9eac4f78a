// SPDX-License-Identifier: BSD-3-Clause
// Also known as: final gathering over a cache of unbiased estimates (an irradiance cache of gather hits).
//
// Method `gathered`: fast and consistent, with a bias that it measures and reports.
//
// A round has four phases: gather rays leave the receivers (estimator/gathering/GatherHitTracer.h); their hits are
// sorted into cells, and each cell gets one unbiased estimate of its indirect light (CellShading.h); the hits light the
// receiver that found them and its neighbours (HitAccumulation.h). Luminaires are evaluated at each hit. Light vertices
// take the share of what rays would find only by luck, beside lamps (BrightSpots.h). Cells are wider when there are
// fewer rays, and shrink with the viewing distance, so they are small near an edge; a cell with one hit shares nothing.
//
// Bias: almost none in the mean over the receivers that share a cell, but light is blurred over the cell. It is second
// order in the cell's width over its distance. It is measured (InterpolationCheck.h), and audit() reports it. Each
// replicate has its own cells, so that standard errors include this error. Source: radiosity with final gathering
// (Lischinski, Tampieri and Greenberg 1993), its radiosity estimated on demand and without bias.
#ifndef kalos_estimator_methods_FinalGathering_h
#define kalos_estimator_methods_FinalGathering_h

#include "estimator/gathering/HitAccumulation.h"
#include "estimator/methods/Estimator.h"

namespace kalos
{
class FinalGathering : public Estimator
{
public:
  FinalGathering(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t /*receiver*/, long long /*trajectories*/) const override
  {
    return this->Direct.hasAllImages();
  }
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  Pace pace() const override;
  void exchange(const Ranks& ranks) override { this->Check.exchange(ranks); }
  void persist(Archive& archive) override;
  std::vector<AuditLine> audit() const override;

private:
  bool addReplicates(Workers::Replicates some, std::vector<CellShading>& round, long long first,
                     const std::function<void()>& nextPhase, Workers& workers, Tally& tally);

  void scoreSpots(std::size_t tile, const LightVertices& spots, long long first, const GatherRound& round,
                  Tally& tally) const;

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  GatherContext Rays;
  GatherPlan Plan;
  GatherHitTracer Tracer;
  BrightSpots Spots;
  HitAccumulation Accumulation;
  InterpolationCheck Check;
  long long RaysDone = 0;  // of each receiver of a whole group in each replicate
  int Replicates = 0;
};
}  // namespace kalos

#endif
