// SPDX-License-Identifier: BSD-3-Clause
// Points on the surfaces, at most one per cell of a grid and direction of the normal, that stand for their
// surroundings.
#ifndef kalos_estimator_SurfaceCache_h
#define kalos_estimator_SurfaceCache_h

#include <cstdint>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
class SurfaceCache
{
public:
  struct Record
  {
    Vec3 position, normal;  ///< a point of the surface, and its side
  };

  SurfaceCache() = default;
  /// Chooses records among points of surfaces, seen from their sides `normal`: in every cell of side `cell` (m) that
  /// holds two points or more the one that is nearest to the cell's centre. Depends on their order only between equals.
  SurfaceCache(double cell, const std::vector<Record>& seen);

  double cell() const { return this->Cell; }
  const std::vector<Record>& records() const { return this->Records; }

  /// The record that stands for point p of a surface with unit normal n, or -1: one in the cell about p whose normal
  /// is within 18 degrees and whose plane is within a twentieth of a cell. Shifting p by a random part of a cell, u and
  /// v in [0,1) along the surface, interpolates between neighbours on average.
  int find(const Vec3& p, const Vec3& n, double u, double v) const;

private:
  struct Slot
  {
    std::uint64_t key;
    int record;  // or -1: free
  };
  std::uint64_t keyAt(const Vec3& p, const Vec3& n) const;
  Slot& slot(std::uint64_t key);
  int match(const Vec3& at, const Vec3& p, const Vec3& n) const;

  double Cell = 1;
  std::vector<Record> Records;
  std::vector<Slot> Slots;  // open addressing, a power of two of them
};
}  // namespace kalos

#endif
