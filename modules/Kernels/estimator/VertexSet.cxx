// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/VertexSet.h"

#include <cstring>

#include "sampling/Random.h"

namespace kalos
{
void VertexSet::add(const Scene& scene, const Vec3& p, const Vec3& n, const Bands& m, double inverse)
{
  this->px.push_back(static_cast<float>(p.x));
  this->py.push_back(static_cast<float>(p.y));
  this->pz.push_back(static_cast<float>(p.z));
  this->nx.push_back(static_cast<float>(n.x));
  this->ny.push_back(static_cast<float>(n.y));
  this->nz.push_back(static_cast<float>(n.z));
  this->offset.push_back(static_cast<float>(length(scene.offset(p, n) - p)));
  this->inverseDensity.push_back(static_cast<float>(inverse));
  const int bands = static_cast<int>(this->flux.size());
  this->luminous.push_back(static_cast<float>(photometric(m, bands)));
  for (int b = 0; b < bands; ++b)
    this->flux[b].push_back(static_cast<float>(m[b]));
}

void VertexSet::addGlossy(const Scene& scene, const SurfacePoint& point, const Vec3& towardsLight,
                          const Bands& incidentFlux, double inverse)
{
  this->add(scene, point.position, point.normal, incidentFlux, inverse);
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
  auto join = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  join(this->px, other.px);
  join(this->py, other.py);
  join(this->pz, other.pz);
  join(this->nx, other.nx);
  join(this->ny, other.ny);
  join(this->nz, other.nz);
  join(this->offset, other.offset);
  join(this->inverseDensity, other.inverseDensity);
  join(this->luminous, other.luminous);
  for (std::size_t b = 0; b < this->flux.size(); ++b)
    join(this->flux[b], other.flux[b]);
  join(this->brdf, other.brdf);
  join(this->incident, other.incident);
}
}  // namespace kalos
