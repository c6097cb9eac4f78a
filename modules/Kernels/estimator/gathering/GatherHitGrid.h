// SPDX-License-Identifier: BSD-3-Clause
// The cells of surfaces that gather rays of one replicate and round have hit, each with one of its hits that stands for
// all of them.
//
// A cell is as wide as a share of the distance that it is seen from, rounded down to a power of two, and lies in the
// plane of its triangle. Its representative is drawn uniformly among its hits: what the cell's hits take from it is
// right in the mean over them, whatever the surface does inside the cell.
#ifndef kalos_estimator_gathering_GatherHitGrid_h
#define kalos_estimator_gathering_GatherHitGrid_h

#include <cstdint>
#include <vector>

#include "scene/Scene.h"

namespace kalos
{
/// A side of a triangle, as cells need it.
struct Face
{
  float normal[3];       ///< unit, of the front
  float plane;           ///< normal . p, m
  std::uint32_t across;  ///< axis (0, 1, 2) nearest to the normal
  std::uint32_t key;     ///< of the normal's direction, to a quarter
};
std::vector<Face> facesOf(const Scene& scene);

/// Where a gather ray has hit.
struct SurfaceHit
{
  float position[3];        ///< m
  std::uint32_t side;       ///< twice the triangle, plus 1 for its front
  std::uint64_t cell;       ///< key of its cell; the cell's index once GatherHitGrid::add() has seen it
  bool near = false;        ///< to what it is seen from: rays in single precision do not serve, see isFarFrom()
  std::uint8_t finder = 0;  ///< whose ray it was, of a group of receivers
};

/// Key of the cell about a hit that is seen from `distance` (m), `share` of it wide: equal only for hits on parallel
/// sides of one plane, of one cell.
std::uint64_t cellKey(const Face& face, const SurfaceHit& hit, float distance, float share);

class GatherHitGrid
{
public:
  struct Cell
  {
    SurfaceHit representative;
    int hits = 0;
  };

  /// Sorts a hit into its cell. Order decides which hit represents a cell, so it must not depend on threads. Random
  /// numbers are hashes of `seed` and of the order.
  void add(SurfaceHit& hit, std::uint64_t seed);

  const std::vector<Cell>& cells() const { return this->Cells; }
  std::size_t hits() const { return this->Added; }

private:
  struct Slot
  {
    std::uint64_t key = 0;
    std::int32_t cell = -1;  // or -1: free
  };
  void grow();

  std::vector<Cell> Cells;
  std::vector<Slot> Slots;  // open addressing, a power of two of them
  std::size_t Added = 0;
};
}  // namespace kalos

#endif
