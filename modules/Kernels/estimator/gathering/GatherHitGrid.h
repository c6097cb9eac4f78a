// SPDX-License-Identifier: BSD-3-Clause
// Also known as: spatial hash of gather hits; the cells of an irradiance cache.
//
// Sorts the hits of one replicate's gather rays in a round into cells. One hit represents each cell.
//
// A cell is as wide as a share of the distance that it is seen from, rounded down to a power of two, and lies in the
// plane of its triangle. Its representative is drawn uniformly among its hits: so the estimate at the representative is
// unbiased for the mean over the cell's hits.
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
  float position[3];             ///< m
  std::uint32_t side;            ///< twice the triangle, plus 1 for its front
  std::uint64_t cell;            ///< key of its cell; the cell's index once GatherHitGrid::add() has seen it
  bool near = false;             ///< to the ray's start: needs rays in double precision, see isFarFrom()
  std::uint8_t finder = 0;       ///< receiver of the group that sent the ray
  bool byLobe = false;           ///< seen in a glossy surface: lights only the finder, by the factor `weight`
  float weight = 1, cosine = 1;  ///< by a lobe: the factor, and the ray's cosine here
};

/// Key of the cell of a hit seen from `distance` (m); the cell is `share` times as wide. Equal keys: same cell, on
/// parallel sides of one plane.
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
