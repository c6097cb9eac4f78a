// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Pilot.h"

namespace kalos
{
namespace
{
constexpr int trajectories = 1024;
constexpr int enough = 16;  // vertices in a leaf at least, if there are so many: its density is good to a quarter
constexpr int directions = 6;

double along(const Vec3& p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// 0 .. 5: the axis that n is nearest to, and its sign. In single precision, as vertices hold their normals: who weighs
// a vertex and who weighs a ray to its place must agree, also where two axes are equally near.
int direction(const Vec3& normal)
{
  auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const Vec3 n{rounded(normal.x), rounded(normal.y), rounded(normal.z)};
  const int axis = mainAxis(n);
  return 2 * axis + (along(n, axis) > 0 ? 1 : 0);
}

Vec3 lower(const Vec3& a, const Vec3& b)
{
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3 upper(const Vec3& a, const Vec3& b)
{
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
}  // namespace

Pilot::Pilot(const Scene& scene, const Emission& emission, const Walks& walks)
    : Lit(scene), Flux(emission.totalFlux()), Nodes(directions)
{
  std::vector<Collision> points;
  if (this->Flux > 0)
  {
    const VertexPool pool = traceTrajectories(scene, emission, walks, pilotReplicate, 0, trajectories);
    for (const VertexSet* set : {&pool.reflected, &pool.glossy})
      for (std::size_t i = 0; i < set->size(); ++i)
        points.push_back({set->position(i), set->normal(i)});
    this->Starts = static_cast<double>(pool.emitted.size()) / trajectories;
  }
  this->Collisions = static_cast<double>(std::max<std::size_t>(1, points.size())) / trajectories;
  std::vector<Collision> facing[directions];
  for (const Collision& c : points)
    facing[direction(c.normal)].push_back(c);
  for (std::size_t d = 0; d < directions; ++d)
    this->split(d, facing[d].begin(), facing[d].end());

  std::vector<double> densities;
  densities.reserve(points.size() + 1);
  for (const Collision& c : points)
    densities.push_back(this->density(c.position, c.normal));
  if (densities.empty())
    densities.push_back(this->density({}, {0, 0, 1}));
  const auto middle = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
  std::nth_element(densities.begin(), middle, densities.end());
  this->Typical = *middle;
}

void Pilot::split(std::size_t node, Iterator begin, Iterator end)
{
  Node& here = this->Nodes[node];
  here.count = static_cast<int>(end - begin);
  if (begin == end)
    return;
  here.low = here.high = begin->position;
  for (Iterator c = begin; c != end; ++c)
  {
    here.low = lower(here.low, c->position);
    here.high = upper(here.high, c->position);
  }
  const int axis = mainAxis(here.high - here.low);
  const Iterator middle = begin + here.count / 2;
  if (here.count < 2 * enough || !(along(here.high - here.low, axis) > 0))
    return;
  std::nth_element(begin, middle, end, [axis](const Collision& a, const Collision& b) {
    return along(a.position, axis) < along(b.position, axis);
  });
  const std::size_t children = this->Nodes.size();
  here.axis = axis;
  here.split = along(middle->position, axis);
  here.children = static_cast<int>(children);
  this->Nodes.resize(children + 2);  // moves `here`
  this->split(children, begin, middle);
  this->split(children + 1, middle, end);
}

double Pilot::density(const Vec3& p, const Vec3& n) const
{
  const int facing = direction(n), across = facing / 2;
  const Node* node = &this->Nodes[static_cast<std::size_t>(facing)];
  while (node->axis >= 0)
    node = &this->Nodes[static_cast<std::size_t>(node->children + (along(p, node->axis) < node->split ? 0 : 1))];
  const double count = std::max(0.5, static_cast<double>(node->count));
  // n uniform points span (n - 1) / (n + 1) of each side of their rectangle.
  const double least = 1e-6 * this->Lit.size(), inflation = (count + 1) / std::max(1.0, count - 1);
  const bool isEmpty = node->count == 0;
  const Vec3 size = isEmpty ? Vec3{this->Lit.size(), this->Lit.size(), this->Lit.size()}
                            : inflation * (upper(node->high, p) - lower(node->low, p)) + Vec3{least, least, least};
  const double area = along(size, (across + 1) % 3) * along(size, (across + 2) % 3) / std::abs(along(n, across));
  return count / (area * trajectories);
}

double Pilot::startDensity(const Material& material) const
{
  return this->Flux > 0 ? photometric(material.exitance, this->Lit.bands()) / this->Flux : 0;
}

void Pilot::annotate(VertexPool& pool) const
{
  for (VertexSet* set : {&pool.reflected, &pool.glossy})
    for (std::size_t i = 0; i < set->size(); ++i)
      if (set->inverseDensity[i] < 0)
        set->inverseDensity[i] = static_cast<float>(1 / this->density(set->position(i), set->normal(i)));
}
}  // namespace kalos
