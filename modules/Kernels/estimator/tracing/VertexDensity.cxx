// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/VertexDensity.h"

namespace kalos
{
namespace
{
constexpr int trajectories = 1024;
constexpr std::size_t enough = 16;  // vertices for a density good to a quarter
constexpr int deepest = 16;

int octant(const Vec3& p, const Vec3& centre)
{
  return (p.x > centre.x ? 1 : 0) + (p.y > centre.y ? 2 : 0) + (p.z > centre.z ? 4 : 0);
}

Vec3 childCentre(const Vec3& centre, double half, int i)
{
  const double step = half / 2;
  return centre + Vec3{i & 1 ? step : -step, i & 2 ? step : -step, i & 4 ? step : -step};
}
}  // namespace

VertexDensity::VertexDensity(const Scene& scene, const Emission& emission, const Walks& walks)
    : Scene_(scene), Flux(emission.totalFlux()), Nodes(1)
{
  std::vector<Collision> points;
  if (this->Flux > 0)
  {
    const LightVertices pool = traceTrajectories(scene, emission, walks, pilotReplicate, 0, trajectories);
    for (const VertexSet* set : {&pool.reflected, &pool.glossy})
      for (std::size_t i = 0; i < set->size(); ++i)
        points.push_back({set->position(i), set->normal(i)});
    this->Starts = static_cast<double>(pool.emitted.size()) / trajectories;
  }
  this->Collisions = static_cast<double>(std::max<std::size_t>(1, points.size())) / trajectories;
  const double half = 0.5 * scene.size() + 1e-9;
  this->Nodes[0].density = densityIn(2 * half, points);
  this->split(0, {}, half, points, 0);

  std::vector<double> densities;
  densities.reserve(points.size() + 1);
  for (const Collision& c : points)
    densities.push_back(this->density(c.position));
  if (densities.empty())
    densities.push_back(this->density({}));
  const auto middle = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
  std::nth_element(densities.begin(), middle, densities.end());
  this->Typical = *middle;
}

double VertexDensity::densityIn(double cube, const std::vector<Collision>& inside)
{
  // Correct for the extent of the points: n uniform points span (n - 1) / (n + 1) of a cube.
  Vec3 low = inside.empty() ? Vec3{} : inside.front().position, high = low;
  for (const Collision& c : inside)
  {
    low = {std::min(low.x, c.position.x), std::min(low.y, c.position.y), std::min(low.z, c.position.z)};
    high = {std::max(high.x, c.position.x), std::max(high.y, c.position.y), std::max(high.z, c.position.z)};
  }
  const double count = static_cast<double>(inside.size());
  const double span = maxAbs(high - low) * (count + 1) / std::max(1.0, count - 1);
  const double side = inside.size() < enough ? cube : std::clamp(span, 1e-6 * cube, cube);
  // Surfaces of different orientation, by the main direction of their normals; each has about the area of a face.
  std::size_t facing[6] = {};
  for (const Collision& c : inside)
  {
    const Vec3& n = c.normal;
    const int axis = std::abs(n.x) > std::abs(n.y) ? (std::abs(n.x) > std::abs(n.z) ? 0 : 2)
                                                   : (std::abs(n.y) > std::abs(n.z) ? 1 : 2);
    const double along = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    ++facing[2 * axis + (along > 0)];
  }
  const auto surfaces = std::count_if(facing, facing + 6, [&](std::size_t f) { return 10 * f > inside.size(); });
  return std::max(0.5, static_cast<double>(inside.size())) /
         (std::max(1.0, static_cast<double>(surfaces)) * side * side) / trajectories;
}

void VertexDensity::split(int node, const Vec3& centre, double half, const std::vector<Collision>& inside, int depth)
{
  if (inside.size() < 2 * enough || depth == deepest)
    return;
  const int first = static_cast<int>(this->Nodes.size());
  this->Nodes[node].children = first;
  this->Nodes.resize(this->Nodes.size() + 8);
  std::vector<Collision> parts[8];
  for (const Collision& c : inside)
    parts[octant(c.position, centre)].push_back(c);
  for (int i = 0; i < 8; ++i)
  {
    this->Nodes[first + i].density = parts[i].size() >= enough ? densityIn(half, parts[i]) : this->Nodes[node].density;
    this->split(first + i, childCentre(centre, half, i), half / 2, parts[i], depth + 1);
  }
}

double VertexDensity::density(const Vec3& p) const
{
  Vec3 centre;
  double half = 0.5 * this->Scene_.size() + 1e-9;
  int node = 0;
  while (this->Nodes[node].children >= 0)
  {
    const int i = octant(p, centre);
    node = this->Nodes[node].children + i;
    centre = childCentre(centre, half, i);
    half /= 2;
  }
  return this->Nodes[node].density;
}

double VertexDensity::startDensity(const Material& material) const
{
  return this->Flux > 0 ? photometric(material.exitance, this->Scene_.bands()) / this->Flux : 0;
}

void VertexDensity::annotate(LightVertices& pool) const
{
  for (VertexSet* set : {&pool.reflected, &pool.glossy})
    for (std::size_t i = 0; i < set->size(); ++i)
      if (set->inverseDensity[i] < 0)
      {
        const double density = this->density(set->position(i));
        set->inverseDensity[i] =
            static_cast<float>(1 / std::max(density, static_cast<double>(set->firstHitDensity[i])));
      }
}
}  // namespace kalos
