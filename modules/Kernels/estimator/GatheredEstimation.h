// SPDX-License-Identifier: BSD-3-Clause
// Method `gathered`: the fast one; consistent, with a bias that it measures and reports.
//
// Stratified cosine-weighted rays leave each receiver, in packets. Where one ends, the receiver is lit by (M0 + rho
// E)/pi. The light of luminaires in E is that at the hit itself; the rest is shared by hits that lie together, as seen
// from the receivers: they are sorted into cells (estimator/SurfaceCache.h), the wider the fewer rays there are, and it
// is estimated at one hit of each, drawn uniformly, without bias: by a block of the trajectories' vertices, and a
// gather ray for what these leave (GatherWave::indirectLight). Near an edge cells are as small as the distance asks;
// where a cell has one hit, nothing is shared. Where a ray ends on gloss or a mirror, the unbiased gather ray of
// `compensated` takes its place.
//
// Bias: none in the mean over the receivers that share a cell; between them, light is spread over the cell. It is
// second order in the cell's width over its distance. One shared hit in `checkEvery` is estimated at its own place too;
// audit() states the mean of the difference with its standard error. Each replicate has cells of its own, so that
// standard errors include everything. Source: radiosity with final gathering (Lischinski, Tampieri and Greenberg 1993),
// its radiosity estimated on demand and without bias.
#ifndef kalos_estimator_GatheredEstimation_h
#define kalos_estimator_GatheredEstimation_h

#include "estimator/DirectPart.h"
#include "estimator/Estimator.h"
#include "estimator/ReceiverRays.h"
#include "estimator/SurfaceCache.h"

namespace kalos
{
class GatherPattern;

class GatheredEstimation : public Estimator
{
public:
  GatheredEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool letsRest() const override { return true; }
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
    std::vector<std::size_t> ends;  // of each receiver's hits
  };
  // Rays of receivers that go in one packet, and which of whose they are.
  struct Sight
  {
    SegmentPacket packet;
    std::size_t receiver[SegmentPacket::width];
    long long ray[SegmentPacket::width];
    int count = 0;

    void add(const SegmentPacket& from, int i, std::size_t r, long long k)
    {
      this->packet.set(this->count, {from.ox[i], from.oy[i], from.oz[i]}, {from.dx[i], from.dy[i], from.dz[i]});
      this->receiver[this->count] = r;
      this->ray[this->count++] = k;
    }
  };
  // One replicate's round.
  struct Replicate
  {
    GatherPool pool;
    float cellShare = 0;  // of the distance that a cell is seen from, its width
    SurfaceCache cache;
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
  bool addReplicates(Workers::Replicates some, std::vector<Replicate>& round, long long first, int rays,
                     const std::function<void()>& nextPhase, Workers& workers, Tally& tally);
  void look(std::size_t tile, int replicate, const Replicate& round, int rays, Looks& looks, Tally& tally) const;
  void see(Sight& sight, int replicate, int rays, const Replicate& round, Looks& looks, ReceiverRays& unshared) const;
  std::uint64_t seedOfCells(int replicate) const;
  Sensor at(const SurfaceHit& hit) const;
  void estimate(const SurfaceHit& hit, int replicate, GatherWave& wave) const;
  void lightByLamps(const SurfaceHit* hits, int count, SampleStream& random, Bands* light) const;
  void collect(std::size_t tile, int replicate, const Replicate& round, int rays, const Looks& looks, Tally& tally,
               Check& check) const;
  // How much cells exceed what is estimated at these hits' own places, lx, summed up.
  double excess(const std::vector<const SurfaceHit*>& hits, int replicate, const Replicate& round) const;

  const Scene& Lit;
  Settings Wanted;
  Emission Source;
  DirectPart Direct;
  Gathering Rays;
  std::vector<Face> Faces;
  long long RaysDone = 0;     // of each receiver in each replicate
  std::vector<Check> Checks;  // per tile and replicate
  int Replicates = 0;
};
}  // namespace kalos

#endif
