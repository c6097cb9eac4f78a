// SPDX-License-Identifier: BSD-3-Clause
/** The nearest of many triangles. */
#ifndef KalosMeshingNearestTriangle_h
#define KalosMeshingNearestTriangle_h

#include <memory>

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
class NearestTriangle
{
public:
  /** Over these triangles of a mesh, at least one. */
  NearestTriangle(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles);
  ~NearestTriangle();

  /** Number of the triangle in the mesh. */
  std::uint32_t to(const Point& point) const;

private:
  struct Impl;
  std::unique_ptr<Impl> Tree;
};
}  // namespace kalos::meshing

#endif
