// SPDX-License-Identifier: BSD-3-Clause
// Method `gathered`: the fast one; consistent, with a bias that it measures and reports.
//
// Stratified cosine-weighted rays leave the receivers, in packets. Where one ends, the surface is lit by
// (M0 + rho E)/pi, and lights the receiver and its neighbours (estimator/gathering/ReceiverGroup.h). The light of
// luminaires in E is that at the hit itself; the rest is shared by hits that lie together, as seen from the receivers:
// they are sorted into cells (estimator/gathering/GatherHitGrid.h), the wider the fewer rays there are, and it is
// estimated at one hit of each, drawn uniformly, without bias: by a block of the trajectories' vertices, and a gather
// ray for what these leave (WavefrontGather::indirectLight). Near an edge cells are as small as the distance asks;
// where a cell has one hit, nothing is shared. Where a ray ends on gloss or a mirror, the unbiased gather ray of
// `compensated` takes its place.
//
// Bias: next to none in the mean over the receivers that share a cell; between them, light is spread over the cell. It
// is second order in the cell's width over its distance. One shared hit in `checkEvery` is estimated at its own place
// too; audit() states the mean of the difference with its standard error. Each replicate has cells of its own, so that
// standard errors include everything. Source: radiosity with final gathering (Lischinski, Tampieri and Greenberg 1993),
// its radiosity estimated on demand and without bias.
#ifndef kalos_estimator_methods_FinalGathering_h
#define kalos_estimator_methods_FinalGathering_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/gathering/GatherHitGrid.h"
#include "estimator/gathering/ReceiverGroup.h"
#include "estimator/gathering/ReceiverRays.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tally/HotSpots.h"

namespace kalos
{
class GatherPattern;

class FinalGathering : public Estimator
{
public:
  FinalGathering(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t receiver, long long trajectories) const override;
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  Pace pace() const override;
  void exchange(const Ranks& ranks) override;
  void persist(Archive& archive) override;
  std::vector<AuditLine> audit() const override;

private:
  // What the rays of one tile and replicate have found in a round.
  struct Looks
  {
    std::vector<SurfaceHit> hits;
    std::vector<std::size_t> ends;  // of each group's hits
  };
  // Rays of a group that go in one packet, and which of whose they are.
  struct Sight
  {
    SegmentPacket packet;
    int finder[SegmentPacket::width], ray[SegmentPacket::width];
    int count = 0;

    void add(const SegmentPacket& from, int i, int whose, int which)
    {
      this->packet.set(this->count, {from.ox[i], from.oy[i], from.oz[i]}, {from.dx[i], from.dy[i], from.dz[i]});
      this->finder[this->count] = whose;
      this->ray[this->count++] = which;
    }
  };
  // One replicate's round.
  struct Replicate
  {
    GatherPool pool;
    float cellShare = 0;  // of the distance that a cell is seen from, its width
    GatherHitGrid cache;
    std::vector<double> indirect;  // lx, bands() values per cell
  };
  // Luminous sums over the rays of one replicate and tile.
  struct Check
  {
    double excess = 0;  // of cells over the hits' own places, lx
    double sum = 0;     // of all rays, lx
    double rays = 0, shared = 0;
    double cells = 0;  // of the whole replicate, with its first tile
  };
  // Whether receivers take part in what their neighbours' rays find: not where luminous surfaces are all around (in a
  // white furnace own rays took a thirtieth of the time to the same error), nor among gloss. And how many do together.
  bool sharesRays() const;
  int groupSize() const;
  AuditLine auditNeighbours() const;
  // Gather rays of each receiver of a group, when those of a whole group have so many: where fewer are active, they
  // have its rays.
  int raysOfEach(const ReceiverGroup& group, int rays) const;
  // Trajectories of a replicate for each gather ray of a receiver in that replicate, in a whole group. Time goes to
  // trajectories where receivers are few, to rays where they are many: the best ratio goes with the root of their
  // number. For 64 x 64 points on a floor and on walls 128 and 512 took as long to the same error, for 48 along an edge
  // 16 and 64.
  int trajectoriesPerRay() const;
  bool addReplicates(Workers::Replicates some, std::vector<Replicate>& round, long long first, int rays,
                     const std::function<void()>& nextPhase, Workers& workers, Tally& tally);
  void look(std::size_t tile, int replicate, const Replicate& round, int rays, Looks& looks, Tally& tally) const;
  void see(Sight& sight, const ReceiverGroup& group, int replicate, int each, const Replicate& round, Looks& looks,
           ReceiverRays& unshared) const;
  // Where ray i of a packet has ended, and how far that is; false: nowhere.
  bool meet(const Sensor& sensor, const SegmentPacket& packet, const HitPacket& found, int i, SurfaceHit& hit,
            float& distance) const;
  std::uint64_t seedOfCells(int replicate) const;
  // The receivers of a tile in groups, those that do not rest.
  std::vector<ReceiverGroup> groups(std::size_t tile, const Tally& tally) const;
  Sensor at(const SurfaceHit& hit) const;
  void estimate(const SurfaceHit& hit, int replicate, WavefrontGather& wave) const;
  void lightByLamps(const SurfaceHit* hits, const Sensor* at, int count, SampleStream& random, Bands* light) const;
  void collect(std::size_t tile, int replicate, const Replicate& round, int rays, const Looks& looks, Tally& tally,
               Check& check) const;
  // A shared hit, and how much of it all receivers take.
  struct Probe
  {
    const SurfaceHit* hit;
    double taken;
  };
  // How much cells exceed what is estimated at these hits' own places, lx, summed up.
  double excess(const std::vector<Probe>& probes, int replicate, const Replicate& round) const;

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  GatherContext Rays;
  HotSpots Spots;
  std::vector<Face> Faces;
  std::vector<std::size_t> Order;  // receivers, so that those beside each other follow each other
  bool MostlyDiffuse;
  long long RaysDone = 0;     // of each receiver of a whole group in each replicate
  std::vector<Check> Checks;  // per tile and replicate
  int Replicates = 0;
};
}  // namespace kalos

#endif
