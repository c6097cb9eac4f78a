// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/VertexSet.h"

#include <cstring>

#include "sampling/Random.h"

namespace kalos
{
namespace
{
// Each array of a set, beside the same array of the others.
template <class Change, class... Set>
void changeArrays(const Change& change, VertexSet& v, const Set&... others)
{
  change(v.px, others.px...);
  change(v.py, others.py...);
  change(v.pz, others.pz...);
  change(v.nx, others.nx...);
  change(v.ny, others.ny...);
  change(v.nz, others.nz...);
  change(v.lift, others.lift...);
  change(v.slope, others.slope...);
  change(v.inverseDensity, others.inverseDensity...);
  change(v.firstHitDensity, others.firstHitDensity...);
  change(v.luminous, others.luminous...);
  for (std::size_t b = 0; b < v.flux.size(); ++b)
    change(v.flux[b], others.flux[b]...);
  change(v.brdf, others.brdf...);
  change(v.incident, others.incident...);
}
}  // namespace

RayAnchor VertexSet::stored(const RayAnchor& at)
{
  auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  auto each = [&](const Vec3& v) { return Vec3{single(v.x), single(v.y), single(v.z)}; };
  return {each(at.point), each(at.normal), single(at.base), single(at.slope)};
}

void VertexSet::add(const RayAnchor& at, const Bands& m, double inverse, double firstHits)
{
  const Vec3 &p = at.point, &n = at.normal;
  this->px.push_back(static_cast<float>(p.x));
  this->py.push_back(static_cast<float>(p.y));
  this->pz.push_back(static_cast<float>(p.z));
  this->nx.push_back(static_cast<float>(n.x));
  this->ny.push_back(static_cast<float>(n.y));
  this->nz.push_back(static_cast<float>(n.z));
  this->lift.push_back(static_cast<float>(at.base));
  this->slope.push_back(static_cast<float>(at.slope));
  this->inverseDensity.push_back(static_cast<float>(inverse));
  this->firstHitDensity.push_back(static_cast<float>(firstHits));
  const int bands = static_cast<int>(this->flux.size());
  this->luminous.push_back(static_cast<float>(photometric(m, bands)));
  for (int b = 0; b < bands; ++b)
    this->flux[b].push_back(static_cast<float>(m[b]));
}

void VertexSet::addGlossy(const Scene& scene, const SurfacePoint& point, const Vec3& towardsLight,
                          const Bands& incidentFlux, double inverse)
{
  this->add(scene.anchor(point), incidentFlux, inverse);
  this->brdf.push_back(&scene.brdf(point.triangle));
  this->incident.push_back(towardsLight);
}

long long VertexSet::key(std::size_t i) const
{
  const float coordinates[4] = {this->px[i], this->py[i], this->pz[i], 0};
  std::uint64_t bits[2];
  std::memcpy(bits, coordinates, sizeof bits);
  return static_cast<long long>(mixBits(mixBits(bits[0]) + bits[1]));
}

void VertexSet::append(const VertexSet& other)
{
  changeArrays([](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); }, *this, other);
}

void VertexSet::reorder(const std::vector<std::size_t>& order)
{
  auto reorderArray = [&](auto& values) {
    const auto before = values;
    for (std::size_t i = 0; i < values.size(); ++i)  // none of what only glossy vertices have
      values[i] = before[order[i]];
  };
  changeArrays(reorderArray, *this);
}
}  // namespace kalos
