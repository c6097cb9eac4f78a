// SPDX-License-Identifier: BSD-3-Clause
/** Polygons with materials, as they come out of a scene or mesh file. */
#ifndef KalosMesh_h
#define KalosMesh_h

#include <cstdint>
#include <string>
#include <vector>

#include "../base/Vectors.h"
#include "../material/Material.h"

namespace kalos::scene
{
struct Mesh
{
  std::vector<Vector3> Points;           ///< m
  std::vector<std::int64_t> Corners;     ///< of all polygons, one after the other
  std::vector<std::int64_t> Ends;        ///< of each polygon in Corners
  std::vector<std::int32_t> MaterialOf;  ///< of each polygon in Palette; -1 while it has none
  std::vector<Material> Palette;

  std::size_t NumberOfPolygons() const { return this->Ends.size(); }
  std::int64_t Begin(std::size_t polygon) const { return polygon == 0 ? 0 : this->Ends[polygon - 1]; }
  void AddPolygon(const std::vector<std::int64_t>& corners, std::int32_t material);
  /** Whether the polygon has an area beyond rounding, relative to its perimeter. */
  bool HasArea(std::size_t polygon) const;
  /** MaterialOf counts `all`: make a palette of those that are used, and count that. */
  void TakeMaterials(const std::vector<Material>& all);
  /** Leave out polygons without area; returns how many. */
  std::size_t DropDegenerate();
  /** Vector area: the normal times the area, m². */
  Vector3 Area(std::size_t polygon) const;
  /**
   * Throw unless every point is finite and every polygon has three or more corners that exist and an area.
   * `file` and `face` open the message: "room.obj: face 12: ..."; faces are counted from 1.
   */
  void Check(const std::string& file, const char* face) const;
};

/** Parallelogram origin, u, v; the normal is u x v. */
Mesh MakeQuad(const Vector3& origin, const Vector3& u, const Vector3& v);

/** Box with outward normals, turned about z through its centre, counter-clockwise from above. */
Mesh MakeBox(const Vector3& center, const Vector3& size, double rotationZDegrees);
}  // namespace kalos::scene

#endif
