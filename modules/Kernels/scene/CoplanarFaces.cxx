// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CoplanarFaces.h"

#include <algorithm>
#include <tuple>

#include "scene/Scene.h"
#include "scene/TriangleTree.h"

namespace kalos
{
namespace
{
bool isLuminous(const Scene& scene, std::uint32_t t)
{
  return photometric(scene.material(t).exitance, scene.bands()) > 0;
}

// A convex polygon of few corners.
struct Patch
{
  Vec3 corner[8];
  int count = 0;

  // Keeps what lies on the positive side of a plane through p.
  void cut(const Vec3& p, const Vec3& inwards)
  {
    Patch kept;
    for (int i = 0; i < this->count; ++i)
    {
      const Vec3 &a = this->corner[i], &b = this->corner[(i + 1) % this->count];
      const double atA = dot(a - p, inwards), atB = dot(b - p, inwards);
      if (atA >= 0)
        kept.corner[kept.count++] = a;
      if ((atA < 0) != (atB < 0) && kept.count < 8)
        kept.corner[kept.count++] = a + (atA / (atA - atB)) * (b - a);
    }
    *this = kept;
  }

  double area() const
  {
    Vec3 sum{};
    for (int i = 2; i < this->count; ++i)
      sum += cross(this->corner[i - 1] - this->corner[0], this->corner[i] - this->corner[0]);
    return 0.5 * length(sum);
  }

  double perimeter() const
  {
    double sum = 0;
    for (int i = 0; i < this->count; ++i)
      sum += length(this->corner[(i + 1) % this->count] - this->corner[i]);
    return sum;
  }

  // What lies outside of a triangle of the same plane, in convex pieces.
  void subtract(const Scene& scene, std::uint32_t o, std::vector<Patch>& pieces) const
  {
    Patch rest = *this;
    for (int i = 0; i < 3; ++i)
    {
      const Vec3 a = scene.corner(o, i), inwards = cross(scene.normal(o), scene.corner(o, (i + 1) % 3) - a);
      Patch outside = rest;
      outside.cut(a, -inwards);
      rest.cut(a, inwards);
      if (outside.count > 2)
        pieces.push_back(outside);
    }
  }

  Vec3 middle() const
  {
    Vec3 sum{};
    for (int i = 0; i < this->count; ++i)
      sum += (1.0 / this->count) * this->corner[i];
    return sum;
  }
};

// What of triangle t lies in one place with triangle o; empty where that is less wide than the two can be told apart.
Patch common(const Scene& scene, std::uint32_t t, std::uint32_t o)
{
  const Vec3& n = scene.normal(o);
  Patch patch;
  if (std::abs(dot(n, scene.normal(t))) < 0.998)
    return patch;
  for (int i = 0; i < 3; ++i)
    patch.corner[patch.count++] = scene.corner(t, i);
  for (int i = 0; i < 3; ++i)
    patch.cut(scene.corner(o, i), normalized(cross(n, scene.corner(o, (i + 1) % 3) - scene.corner(o, i))));
  double reach = 0;
  for (int i = 0; i < patch.count; ++i)
  {
    const Vec3& p = patch.corner[i];
    const double here = std::max(scene.reach(t, p), scene.reach(o, p));
    if (std::abs(dot(p - scene.corner(o, 0), n)) > here)
      return {};
    reach = std::max(reach, here);
  }
  return patch.area() > 0.5 * reach * patch.perimeter() ? patch : Patch();
}

// What of a luminous triangle is left by those that lie on it.
std::vector<std::array<Vec3, 3>> uncovered(const Scene& scene, std::uint32_t t, const std::vector<std::uint32_t>& over)
{
  Patch whole;
  for (int i = 0; i < 3; ++i)
    whole.corner[whole.count++] = scene.corner(t, i);
  std::vector<Patch> pieces{whole}, next;
  for (const std::uint32_t o : over)
  {
    next.clear();
    for (const Patch& piece : pieces)
      piece.subtract(scene, o, next);
    pieces.swap(next);
  }
  std::vector<std::array<Vec3, 3>> left;
  for (const Patch& piece : pieces)
    for (int i = 2; i < piece.count; ++i)
    {
      const std::array<Vec3, 3> part{piece.corner[0], piece.corner[i - 1], piece.corner[i]};
      if (length(cross(part[1] - part[0], part[2] - part[0])) > 1e-9 * scene.area(t))
        left.push_back(part);
    }
  return left;
}

// Sums of pairs of triangles by the surfaces and materials that they are of.
class OverlapSums
{
public:
  explicit OverlapSums(const Scene& scene) : Scene_(scene) {}

  void add(std::uint32_t t, std::uint32_t o, bool backToBack, const Patch& patch)
  {
    const bool first = backToBack ? t > o : liesOver(this->Scene_, t, o, -this->Scene_.normal(t));
    const std::uint32_t top = first ? t : o, under = first ? o : t;
    const auto& material = this->Scene_.data().triangleMaterial;
    One& one =
        this->All[{this->Scene_.surface(top), material[top], this->Scene_.surface(under), material[under], backToBack}];
    const double area = patch.area(), sum = one.sum.area + area;
    if (area > one.largest)
      one = {{top, under, backToBack, 0, patch.middle()}, area};
    one.sum.area = sum;
  }

  std::vector<Overlap> sorted() const
  {
    std::vector<Overlap> all;
    for (const auto& [key, one] : this->All)
      all.push_back(one.sum);
    std::stable_sort(all.begin(), all.end(), [](const Overlap& a, const Overlap& b) { return a.area > b.area; });
    return all;
  }

private:
  struct One
  {
    Overlap sum;
    double largest = 0;  // m2, of a pair
  };
  const Scene& Scene_;
  std::map<std::tuple<std::size_t, std::uint32_t, std::size_t, std::uint32_t, bool>, One> All;
};
}  // namespace

bool liesOver(const Scene& scene, std::uint32_t a, std::uint32_t b, const Vec3& direction)
{
  const bool frontOfA = dot(scene.normal(a), direction) < 0, frontOfB = dot(scene.normal(b), direction) < 0;
  if (frontOfA != frontOfB)
    return frontOfA;
  const bool luminousA = isLuminous(scene, a), luminousB = isLuminous(scene, b);
  return luminousA != luminousB ? luminousA : a > b;
}

CoplanarFaces findCoplanarFaces(const Scene& scene)
{
  CoplanarFaces found;
  const auto& material = scene.data().triangleMaterial;
  const bool many = std::adjacent_find(material.begin(), material.end(), std::not_equal_to<>()) != material.end();
  if (material.empty() || (!many && !isLuminous(scene, 0)))
    return found;
  OverlapSums sums(scene);
  std::map<std::uint32_t, std::vector<std::uint32_t>> over;  // luminous triangles on luminous ones
  const TriangleTree tree(scene, [&](std::uint32_t t) { return !isLuminous(scene, t); });
  for (std::uint32_t t = 0; t < material.size(); ++t)
    tree.forEachLarger(t, [&](std::uint32_t o) {
      const bool alike = material[t] == material[o], luminous = isLuminous(scene, t) && isLuminous(scene, o);
      if (alike && !luminous)
        return;
      const Patch patch = common(scene, t, o);
      if (patch.count == 0)
        return;
      found.marks.resize(material.size());
      found.marks[t] = found.marks[o] = 1;
      const bool backToBack = dot(scene.normal(t), scene.normal(o)) < 0;
      if (!alike || !backToBack)
        sums.add(t, o, backToBack, patch);
      if (luminous && !backToBack)
        over[std::min(t, o)].push_back(std::max(t, o));
    });
  for (const auto& [t, covers] : over)
    found.luminousParts[t] = uncovered(scene, t, covers);
  found.overlaps = sums.sorted();
  return found;
}
}  // namespace kalos
