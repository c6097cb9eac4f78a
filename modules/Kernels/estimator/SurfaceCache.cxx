// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/SurfaceCache.h"

#include "geometry/Vector.h"
#include "sampling/Random.h"

namespace kalos
{
namespace
{
constexpr double sameNormal = 0.95;  // cosine
constexpr double samePlane = 0.05;   // of a cell

std::size_t slotsFor(std::size_t records)
{
  std::size_t slots = 16;
  while (slots < 4 * records)
    slots *= 2;
  return slots;
}
}  // namespace

std::uint64_t SurfaceCache::keyAt(const Vec3& p, const Vec3& n) const
{
  // Half a cell off the origin, so that walls through the scene's centre lie inside their cells; and off the surface by
  // more than rounding, so that a whole wall between two layers of cells falls into one.
  const Vec3 q = (1 / this->Cell) * p + 0.25 * n;
  auto index = [](double x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x + 0.5))) & 0x7ffff;
  };
  const double largest = maxAbs(n);
  const std::uint64_t axis = std::abs(n.x) == largest ? 0 : std::abs(n.y) == largest ? 1 : 2;
  const double along = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
  return (((index(q.x) << 19 | index(q.y)) << 19 | index(q.z)) << 3) | axis << 1 | (along > 0 ? 1 : 0);
}

SurfaceCache::SurfaceCache(double cell, const std::vector<Record>& seen) : Cell(cell), Slots(slotsFor(seen.size()))
{
  for (Slot& s : this->Slots)
    s = {0, -1};
  struct Found
  {
    Record best;
    double distance;
    int count;
  };
  std::vector<Found> found;
  for (const Record& point : seen)
  {
    const Vec3 q = (1 / cell) * point.position;
    const Vec3 inCell{q.x - std::floor(q.x + 0.5), q.y - std::floor(q.y + 0.5), q.z - std::floor(q.z + 0.5)};
    const Vec3 off = inCell - dot(inCell, point.normal) * point.normal;
    const std::uint64_t key = this->keyAt(point.position, point.normal);
    Slot& s = this->slot(key);
    if (s.record < 0)
    {
      s = {key, static_cast<int>(found.size())};
      found.push_back({point, dot(off, off), 1});
      continue;
    }
    Found& f = found[s.record];
    ++f.count;
    if (dot(off, off) < f.distance)
    {
      f.best = point;
      f.distance = dot(off, off);
    }
  }
  // A cell that is seen once is seldom asked for: not worth a record.
  for (Slot& s : this->Slots)
    if (s.record >= 0)
    {
      const Found& f = found[s.record];
      s.record = -2;
      if (f.count < 2)
        continue;
      s.record = static_cast<int>(this->Records.size());
      this->Records.push_back(f.best);
    }
}

SurfaceCache::Slot& SurfaceCache::slot(std::uint64_t key)
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t i = mixBits(key) & mask;
  while (this->Slots[i].record != -1 && this->Slots[i].key != key)
    i = (i + 1) & mask;
  return this->Slots[i];
}

int SurfaceCache::match(const Vec3& at, const Vec3& p, const Vec3& n) const
{
  if (this->Slots.empty())
    return -1;
  const std::uint64_t key = this->keyAt(at, n);
  const std::size_t mask = this->Slots.size() - 1;
  for (std::size_t i = mixBits(key) & mask; this->Slots[i].record != -1; i = (i + 1) & mask)
    if (this->Slots[i].key == key)
    {
      const int found = this->Slots[i].record;
      if (found < 0)
        return -1;
      const Record& r = this->Records[found];
      return dot(r.normal, n) > sameNormal && std::abs(dot(r.position - p, n)) < samePlane * this->Cell ? found : -1;
    }
  return -1;
}

int SurfaceCache::find(const Vec3& p, const Vec3& n, double u, double v) const
{
  const Frame frame(n);
  const int shifted = this->match(p + this->Cell * frame.toWorld({u - 0.5, v - 0.5, 0}), p, n);
  return shifted >= 0 ? shifted : this->match(p, p, n);
}
}  // namespace kalos
