// SPDX-License-Identifier: BSD-3-Clause
// Traces the gather rays of receivers and finds the cells where they end.
//
// Stratified cosine-weighted rays leave the receivers, in packets. What a glossy surface reflects diffusely is shared
// like that of others (Sensor::diffuseOf): only its lobe depends on the viewer. A ray drawn from the lobe ends on a hit
// that is lit by its cell like any other, and lights the receiver alone; more rays are drawn than the lobe's albedo
// says, so that its noise shrinks with its energy. Where the lobe must find luminous meshes, other lobes, curved
// surfaces' highlights or mirrors, and for every ray of a receiver that cannot share hits, the unbiased gather ray of
// `compensated` does it.
#ifndef kalos_estimator_gathering_GatherHitTracer_h
#define kalos_estimator_gathering_GatherHitTracer_h

#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/gathering/GatherHitGrid.h"
#include "estimator/gathering/GatherPlan.h"
#include "estimator/gathering/ReceiverRays.h"

namespace kalos
{
/// The hits of one tile's gather rays, in one replicate and round.
struct GatherHits
{
  std::vector<SurfaceHit> hits;
  std::vector<std::size_t> ends;  ///< of each group's hits
};

class GatherHitTracer
{
public:
  /// All must outlive the tracer.
  GatherHitTracer(const GatherContext& gathering, const ReceiverDirectLight& direct, const GatherPlan& plan,
                  const Settings& settings);

  /// Traces the rays of a tile. Hits whose light can be shared go to `gathered`, with the keys of their cells; the
  /// light of other rays goes to the tally.
  void trace(std::size_t tile, const GatherRound& round, GatherHits& gathered, Tally& tally) const;

private:
  // Collects rays of a group for one packet, with the receiver (`finder`) and the index of each.
  struct RayPacketBuffer
  {
    SegmentPacket packet;
    int finder[SegmentPacket::width], ray[SegmentPacket::width];
    int count = 0;

    void add(const SegmentPacket& from, int i, int receiver, int index);
  };
  void traceLoners(std::size_t tile, const GatherRound& round, int count, ReceiverRays& unshared,
                   const Tally& tally) const;
  // Traces the buffered packet, stores its hits and empties the buffer.
  void tracePacket(RayPacketBuffer& buffer, const ReceiverGroup& group, int each, const GatherRound& round,
                   GatherHits& gathered, ReceiverRays& unshared) const;
  // A gather ray that has ended on a glossy surface or a mirror.
  struct GlossyEnd
  {
    std::size_t receiver;
    int each;  // rays of the receiver
    Vec3 direction;
    SurfaceHit hit;
    float distance;
  };
  // Stores the hit for the diffuse part, and finds the light of the lobe.
  void addGlossy(GlossyEnd& end, const GatherRound& round, SampleStream random, GatherHits& gathered,
                 ReceiverRays& unshared) const;
  void followLobe(const GlossyEnd& end, const SurfacePoint& y, const GatherRound& round, SampleStream random,
                  GatherHits& gathered, ReceiverRays& unshared) const;
  bool isShared(const Material& material) const;  // whether it reflects diffusely, or emits
  // Finds the hit of ray i of a packet and its distance; false when the ray leaves the scene.
  bool locateHit(const Sensor& sensor, const SegmentPacket& packet, const HitPacket& found, int i, SurfaceHit& hit,
                 float& distance) const;

  const GatherContext& Rays;
  const ReceiverDirectLight& Direct;
  const GatherPlan& Plan;
  Settings Settings_;
  std::vector<Face> Faces;
  bool HasLuminousMeshes;
};
}  // namespace kalos

#endif
