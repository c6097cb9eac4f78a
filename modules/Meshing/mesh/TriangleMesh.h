// SPDX-License-Identifier: BSD-3-Clause
/** The triangle mesh that all parts of the meshing library use. */
#ifndef KalosMeshingTriangleMesh_h
#define KalosMeshingTriangleMesh_h

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "Vector.h"

namespace kalos::meshing
{
using Triangle = std::array<std::uint32_t, 3>;

/**
 * Triangles over shared points, m. The front of a triangle is where its corners run counter-clockwise.
 *
 * `origin` names the input cell of each triangle, so that cell arrays survive; `material` numbers what may not be
 * mixed: triangles of different materials are never merged and the border between them is kept. Both have one entry a
 * triangle.
 */
struct TriangleMesh
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> origin;
  std::vector<std::uint32_t> material;
};

/** Called with the share done, 0 to 1; returns false to stop. */
using Progress = std::function<bool(double)>;

/** Thrown out of a function whose Progress returned false. */
struct Stopped : std::runtime_error
{
  Stopped() : std::runtime_error("stopped before the end") {}
};

/** Throws Stopped when told to stop; an empty Progress never is. */
void report(const Progress& progress, double share);

/** Throws std::invalid_argument, naming the first bad one, unless there are triangles, of finite points that exist. */
void check(const TriangleMesh& mesh);

/** Normal times twice the area, m². */
Point doubledArea(const TriangleMesh& mesh, const Triangle& triangle);

/** Sum of the areas, m². */
double area(const TriangleMesh& mesh);

/** The smallest and largest coordinates of the triangles' corners. */
struct Bounds
{
  Point low{0, 0, 0}, high{0, 0, 0};
  double diagonal() const { return norm(high - low); }
};
Bounds bounds(const TriangleMesh& mesh);

class Tolerances;

struct Merged
{
  std::size_t points = 0;  ///< that were replaced by another
  std::size_t moved = 0;   ///< of these, those that were not at the very same place
};

/** Gives points nearer to each other than the tolerances of both the same index. Unused points stay. */
Merged mergePoints(TriangleMesh& mesh, const Tolerances& tolerances);

/** Drops points that no triangle uses and renumbers the others in their order. Returns how many were dropped. */
std::size_t dropUnusedPoints(TriangleMesh& mesh);

/** Drops triangles with a repeated corner or a height of at most their tolerance. Returns how many. */
std::size_t dropDegenerate(TriangleMesh& mesh, const Tolerances& tolerances);

struct Duplicates
{
  std::size_t dropped = 0;  ///< same corners and material as an earlier triangle
  std::size_t kept = 0;     ///< same corners but another material: both are kept
};

/**
 * Drops all but the first of triangles with the same corners and material, whichever way they face; but where
 * `sided[origin]` is not zero, one of each way stays.
 */
Duplicates dropDuplicates(TriangleMesh& mesh, const std::vector<std::uint8_t>& sided = {});

/** Keeps the triangles with a non-zero mark, in their order. */
void keepMarked(TriangleMesh& mesh, const std::vector<std::uint8_t>& marks);
}  // namespace kalos::meshing

#endif
