// SPDX-License-Identifier: BSD-3-Clause
// Also known as: final gathering over a cache of unbiased estimates (an irradiance cache of gather hits).
//
// Method `gathered`: fast and consistent, with a bias that it measures and reports.
//
// Stratified cosine-weighted rays leave the receivers, in packets. Where one ends, the surface is lit by
// (M0 + rho E)/pi, and lights the receiver and its neighbours (estimator/gathering/ReceiverGroup.h). Luminaires are
// evaluated at each hit. Indirect light is shared by neighbouring hits: they are sorted into cells
// (estimator/gathering/GatherHitGrid.h), which are wider when there are fewer rays. One hit of each cell, drawn
// uniformly, gets an unbiased estimate: by a block of vertices, and a gather ray for the part that vertices leave
// (WavefrontGather::indirectLight). Cells shrink with the viewing distance, so they are small near an edge; a cell with
// one hit shares nothing. A ray that ends on a glossy surface or a mirror is replaced by the unbiased gather ray of
// `compensated`.
//
// Bias: almost none in the mean over the receivers that share a cell, but light is blurred over the cell. It is second
// order in the cell's width over its distance. One shared hit in `checkEvery` is also estimated at its own position;
// audit() reports the mean difference with its standard error. Each replicate has its own cells, so that standard
// errors include this error. Source: radiosity with final gathering (Lischinski, Tampieri and Greenberg 1993), its
// radiosity estimated on demand and without bias.
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
  // The hits of one tile's gather rays, in one replicate and round.
  struct GatherHits
  {
    std::vector<SurfaceHit> hits;
    std::vector<std::size_t> ends;  // of each group's hits
  };
  // Collects rays of a group for one packet, with the receiver (`finder`) and the index of each.
  struct RayPacketBuffer
  {
    SegmentPacket packet;
    int finder[SegmentPacket::width], ray[SegmentPacket::width];
    int count = 0;

    void add(const SegmentPacket& from, int i, int receiver, int index)
    {
      this->packet.set(this->count, {from.ox[i], from.oy[i], from.oz[i]}, {from.dx[i], from.dy[i], from.dz[i]});
      this->finder[this->count] = receiver;
      this->ray[this->count++] = index;
    }
  };
  // One replicate's round.
  struct Replicate
  {
    GatherPool pool;
    float cellShare = 0;  // width of a cell over its viewing distance
    GatherHitGrid grid;
    std::vector<double> indirect;  // lx, bands() values per cell
  };
  // Luminous sums over the rays of one replicate and tile.
  struct Check
  {
    double excess = 0;  // of cells over estimates at the hits' own positions, lx
    double sum = 0;     // of all rays, lx
    double rays = 0, shared = 0;
    double cells = 0;  // of the whole replicate, with its first tile
  };
  // Whether receivers share the hits of their neighbours' rays, and the size of a group that does. They do not where
  // luminous surfaces are all around (in a white furnace unshared rays took a thirtieth of the time to the same error),
  // nor where most surfaces are glossy.
  bool sharesRays() const;
  int groupSize() const;
  AuditLine auditNeighbours() const;
  // Gather rays of each receiver of a group, given those of a receiver in a full group: a smaller group sends as many
  // in total.
  int raysOfEach(const ReceiverGroup& group, int rays) const;
  // Trajectories of a replicate for each gather ray of a receiver in that replicate, in a whole group. With few
  // receivers it pays to trace more trajectories, with many to trace more rays: the best ratio is proportional to the
  // root of their number. For 64 x 64 points on a floor and on walls 128 and 512 took as long to the same error, for 48
  // along an edge 16 and 64.
  int trajectoriesPerRay() const;
  bool addReplicates(Workers::Replicates some, std::vector<Replicate>& round, long long first, int rays,
                     const std::function<void()>& nextPhase, Workers& workers, Tally& tally);
  void traceGatherRays(std::size_t tile, int replicate, const Replicate& round, int rays, GatherHits& gathered,
                       Tally& tally) const;
  // Traces the buffered packet, stores its hits and empties the buffer.
  void tracePacket(RayPacketBuffer& buffer, const ReceiverGroup& group, int replicate, int each, const Replicate& round,
                   GatherHits& gathered, ReceiverRays& unshared) const;
  // Finds the hit of ray i of a packet and its distance; false when the ray leaves the scene.
  bool locateHit(const Sensor& sensor, const SegmentPacket& packet, const HitPacket& found, int i, SurfaceHit& hit,
                 float& distance) const;
  std::uint64_t seedOfCells(int replicate) const;
  // The receivers of a tile that have not converged, in groups.
  std::vector<ReceiverGroup> groups(std::size_t tile, const Tally& tally) const;
  Sensor at(const SurfaceHit& hit) const;
  void estimate(const SurfaceHit& hit, int replicate, WavefrontGather& wave) const;
  void lightByLamps(const SurfaceHit* hits, const Sensor* at, int count, SampleStream& random, Bands* light) const;
  void collect(std::size_t tile, int replicate, const Replicate& round, int rays, const GatherHits& gathered,
               Tally& tally, Check& check) const;
  // A shared hit, and the sum of all receivers' MIS weights for it.
  struct Probe
  {
    const SurfaceHit* hit;
    double taken;
  };
  // Sum over these hits of the cell's estimate minus the estimate at the hit's own position, lx.
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
