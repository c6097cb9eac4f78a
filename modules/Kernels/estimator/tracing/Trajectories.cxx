// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/Trajectories.h"

#include "estimator/tracing/VisibilityCheck.h"

namespace kalos
{
void LightVertices::append(const LightVertices& other)
{
  this->reflected.append(other.reflected);
  this->glossy.append(other.glossy);
  this->emitted.append(other.emitted);
  this->energy.add(other.energy);
}

namespace
{
// Counts the first hits of light from an emitting mesh.
void noteStart(const Scene& scene, std::size_t surface, const SurfacePoint& met, EnergySums& energy)
{
  energy.starts(surface) += 1;
  if (!met.valid)
    energy.lost(surface) += 1;
  else if (scene.surface(met.triangle) == surface)
    energy.trapped(surface) += 1;
}

// A trajectory from a start, or a child of it that is sent through a portal.
struct Branch
{
  RayAnchor from;
  std::size_t surface;  // where it starts; from a luminaire: none
  Vec3 direction;
  Bands weight;
  std::uint8_t stratum;
  bool fromPoint, straight;  // from a point luminaire; first from the emitter
  bool fromLuminaire;
};

// Sends children of one trajectory through portals (Portals.h).
class Children
{
public:
  Children(const Scene& scene, const Portals& portals, const Walks& walks, int replicate, long long walk)
      : Scene_(scene), Through(portals), Drawn(walks), Replicate(replicate), Index(walk << 20)
  {
  }

  // The MIS weight of the trajectory's own direction, which it draws with this density per sr.
  double share(Portals::Mask mask, const Vec3& from, const Vec3& direction, double own) const
  {
    return mask ? own / (own + this->Through.density(mask, from, direction)) : 1;
  }

  // Perhaps adds a child of the branch `parent`. scatter(direction, own) returns per band the share of its weight that
  // goes on, per sr, and sets the density of its own direction.
  template <class Scatter>
  void add(Portals::Mask mask, const Branch& parent, const Scatter& scatter)
  {
    if (!mask)
      return;
    SampleStream random = this->stream();
    const double u0 = random.next(), u1 = random.next(), u2 = random.next();
    const Portals::Aim aim = this->Through.aim(mask, parent.from.point, u0, u1, u2);
    Branch child = parent;
    child.direction = aim.direction;
    child.stratum = Emission::beyondPortals;
    double own = 0;
    const Bands reflected = scatter(aim.direction, own);
    const double density = own + this->Through.density(mask, parent.from.point, aim.direction);
    for (int b = 0; b < this->Scene_.bands(); ++b)
      child.weight[b] *= reflected[b] / density;
    const double luminous = photometric(child.weight, this->Scene_.bands());
    const double kept = this->Through.all()[static_cast<std::size_t>(aim.portal)].flux;
    if (!(luminous > random.next() * kept))
      return;
    for (int b = 0; b < this->Scene_.bands() && luminous < kept; ++b)
      child.weight[b] *= kept / luminous;
    this->Waiting.push_back(child);
  }

  bool next(Branch& child)
  {
    if (this->Waiting.empty())
      return false;
    child = this->Waiting.back();
    this->Waiting.pop_back();
    return true;
  }

  // Random numbers that no other child, and no trajectory, uses.
  SampleStream stream()
  {
    return Walks{this->Drawn.seed, Sampling::Independent}.stream(this->Replicate, Purpose::Portal, this->Index++);
  }

private:
  const Scene& Scene_;
  const Portals& Through;
  Walks Drawn;
  int Replicate;
  long long Index;
  std::vector<Branch> Waiting;
};

// Follows one branch of a trajectory; see walk().
template <class OnSegment, class OnCollision>
void follow(const Scene& scene, const Portals& portals, Branch branch, SurfacePoint point, SampleStream& random,
            Children& children, EnergySums& energy, OnSegment& onSegment, OnCollision& onCollision)
{
  for (bool first = branch.straight;; first = false)
  {
    onSegment(branch, point, first);
    const double luminous = photometric(branch.weight, scene.bands());
    if (!point.valid)
    {
      energy.escaped() += luminous;
      if (branch.surface < scene.surfaces())
        energy.lastSeen(branch.surface) += 1;
      return;
    }
    const Vec3 out = -branch.direction;
    onCollision(point, branch, branch.fromPoint && !first, first && branch.fromLuminaire);

    // Russian roulette: absorbed with the probability of the luminous absorptance, else reflected.
    const Brdf& brdf = scene.brdf(point.triangle);
    energy.absorbed() += luminous * (1 - brdf.material().mirror - brdf.albedo(dot(point.normal, out), branch.weight));
    branch.surface = scene.surface(point.triangle);
    branch.from = scene.anchor(point);
    const Portals::Mask mask = portals.forTrajectories(point.position, point.normal);
    if (mask)
    {
      Branch parent = branch;
      parent.fromPoint = parent.straight = false;
      children.add(mask, parent, [&](const Vec3& direction, double& own) {
        own = brdf.density(point.normal, out, direction, branch.weight);
        Bands reflected = brdf.timesPi(point.normal, direction, out);
        for (int b = 0; b < scene.bands(); ++b)
          reflected[b] *= std::max(0.0, dot(point.normal, direction)) / pi;
        return reflected;
      });
    }
    const double u0 = random.next(), u1 = random.next(), u2 = random.next();
    const BrdfSample next = brdf.sample(point.normal, out, branch.weight, u0, u1, u2);
    if (!next.alive)
      return;
    const double share = next.mirror ? 1 : children.share(mask, point.position, next.direction, next.density);
    if (share < 1)
      branch.stratum = Emission::beyondPortals;
    branch.fromPoint = branch.fromPoint && next.mirror;
    for (int b = 0; b < scene.bands(); ++b)
      branch.weight[b] *= share * next.weight[b];
    branch.direction = next.direction;
    point = scene.trace(branch.from, branch.direction);
  }
}

// Walks one trajectory. `onStart(sample)`, `onSegment(branch, point, first)` and `onCollision(point, branch,
// caustic)` are called at each event. Adds the energy balance to `energy`.
template <class OnStart, class OnSegment, class OnCollision>
void walk(const Scene& scene, const Emission& emission, const Walks& walks, int replicate, long long index,
          EnergySums& energy, OnStart onStart, OnSegment onSegment, OnCollision onCollision)
{
  SampleStream random = walks.stream(replicate, Purpose::Trajectory, index);
  const EmissionSample start = emission.sample(random);
  onStart(start);
  energy.emitted() += photometric(start.weight, scene.bands());
  energy.trajectories() += 1;
  const std::size_t surface = start.onSurface ? scene.surface(start.triangle) : scene.surfaces();
  Branch branch{start.anchor,
                surface,
                start.direction,
                start.weight,
                start.stratum,
                start.fromPoint,
                true,
                !start.onSurface && !start.fromSky};
  Children children(scene, emission.portals(), walks, replicate, index);
  const Portals::Mask mask = emission.portalsFor(start);
  if (mask)
  {
    children.add(mask, branch, [&](const Vec3& direction, double& own) {
      return uniformBands(own = emission.directionDensity(start, direction));
    });
    const double share =
        children.share(mask, branch.from.point, branch.direction, emission.directionDensity(start, branch.direction));
    if (share < 1)
      branch.stratum = Emission::beyondPortals;
    for (int b = 0; b < scene.bands(); ++b)
      branch.weight[b] *= share;
  }
  SurfacePoint point = scene.trace(branch.from, branch.direction);
  if (start.onSurface)
    noteStart(scene, surface, point, energy);
  follow(scene, emission.portals(), branch, point, random, children, energy, onSegment, onCollision);
  while (children.next(branch))
  {
    SampleStream own = children.stream();
    follow(scene, emission.portals(), branch, scene.trace(branch.from, branch.direction), own, children, energy,
           onSegment, onCollision);
  }
}
}  // namespace

LightVertices traceTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                                long long first, int count)
{
  LightVertices pool(scene.bands(), scene.surfaces());
  std::size_t emitter = 0;  // of the trajectory
  auto note = [&](VertexSet& set, std::uint8_t stratum) {
    if (emission.hasStrata())
      set.stratum.push_back(stratum);
  };
  auto keep = [&](const SurfacePoint& point, const Branch& branch, bool caustic, bool straight) {
    const Material& material = scene.material(point.triangle);
    const double inverse = caustic ? 0 : -1;
    if (material.specular > 0)
    {
      pool.glossy.addGlossy(scene, point, -branch.direction, branch.weight, straight, inverse);
      return note(pool.glossy, branch.stratum);
    }
    Bands reflected{};
    for (int b = 0; b < scene.bands(); ++b)
      reflected[b] = material.reflectance[b] * branch.weight[b];
    if (!(photometric(reflected, scene.bands()) > 0))
      return;  // a mirror's vertex scores nothing
    pool.reflected.add(scene.anchor(point), reflected, inverse,
                       straight ? emission.firstHitDensity(emitter, point.position, point.normal) : 0);
    note(pool.reflected, branch.stratum);
  };
  VisibilityCheck check(scene, pool.energy);
  for (long long i = first; i < first + count; ++i)
    walk(
        scene, emission, walks, replicate, i, pool.energy,
        [&](const EmissionSample& start) {
          emitter = start.emitter;
          if (!start.onSurface)
            return;
          pool.emitted.add(start.anchor, start.weight, 1 / start.density);
          note(pool.emitted, start.stratum);
        },
        [&](const Branch& branch, const SurfacePoint& point, bool) {
          if (point.valid && branch.surface < scene.surfaces() && i % VisibilityCheck::every == 0)
            check.add(branch.from, branch.surface, point);
        },
        keep);
  check.finish();
  return pool;
}

EnergySums walkTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                            long long first, int count, const std::function<void(const Segment&)>& visit)
{
  EnergySums energy(scene.surfaces());
  bool fromMesh = false;
  for (long long i = first; i < first + count; ++i)
    walk(
        scene, emission, walks, replicate, i, energy, [&](const EmissionSample& start) { fromMesh = start.onSurface; },
        [&](const Branch& branch, const SurfacePoint& point, bool firstSegment) {
          const Vec3 from = branch.from.lifted();
          Vec3 to = from + (4 * (scene.size() + length(from))) * branch.direction;
          if (point.valid)
          {
            const double depth = scene.anchor(point).lift();
            to = point.position + (depth / std::max(0.01, -dot(branch.direction, point.normal))) * branch.direction;
          }
          visit({from, to, branch.direction, branch.weight, firstSegment, fromMesh, branch.fromPoint && !firstSegment,
                 point});
        },
        [](auto&&...) {});
  return energy;
}
}  // namespace kalos
