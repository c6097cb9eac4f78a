// SPDX-License-Identifier: BSD-3-Clause
/** Polygons with materials, as they come out of a scene or mesh file. */
#ifndef KalosMesh_h
#define KalosMesh_h

#include <cstdint>
#include <string>
#include <vector>

#include "../base/Notes.h"
#include "../base/Vectors.h"
#include "../material/Material.h"

namespace kalos::scene
{
struct Mesh
{
  std::vector<Vector3> points;           ///< m
  std::vector<std::int64_t> corners;     ///< of all polygons, one after the other
  std::vector<std::int64_t> ends;        ///< of each polygon in Corners
  std::vector<std::int32_t> materialOf;  ///< of each polygon in Palette; -1 while it has none
  std::vector<Material> palette;

  std::size_t numberOfPolygons() const { return this->ends.size(); }
  std::int64_t begin(std::size_t polygon) const { return polygon == 0 ? 0 : this->ends[polygon - 1]; }
  void addPolygon(const std::vector<std::int64_t>& numbers, std::int32_t material);
  /** Whether the polygon has an area beyond rounding, relative to its perimeter. */
  bool hasArea(std::size_t polygon) const;
  /** MaterialOf counts `all`: make a palette of those that are used, and count that. */
  void takeMaterials(const std::vector<Material>& all);
  /** Leave out polygons without area; returns how many. */
  std::size_t dropDegenerate();
  /** Vector area: the normal times the area, m². */
  Vector3 area(std::size_t polygon) const;
  /**
   * Throw unless every corner of a polygon is a point that exists and is finite.
   * `file` and `face` open the message: "room.obj: face 12: ..."; faces are counted from 1.
   */
  void check(const std::string& file, const char* face) const;
};

/** Tell how many polygons without area were left out, if any. */
void noteDegenerate(std::size_t count, Notes& notes);

/** Parallelogram origin, u, v; the normal is u x v. */
Mesh makeQuad(const Vector3& origin, const Vector3& u, const Vector3& v);

/** Box with outward normals, turned about z through its centre, counter-clockwise from above. */
Mesh makeBox(const Vector3& center, const Vector3& size, double rotationZDegrees);
}  // namespace kalos::scene

#endif
