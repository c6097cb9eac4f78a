// SPDX-License-Identifier: BSD-3-Clause
/** A mesh in CGAL's form while it is remeshed, with what is to be kept. */
#ifndef KalosMeshingRemesher_h
#define KalosMeshingRemesher_h

#include <memory>

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
class Remesher
{
public:
  /**
   * `input` is oriented and outlives this; `turned` marks its triangles that face the other way in the result. Throws
   * std::invalid_argument for a triangle that half-edges cannot hold beside its neighbours.
   */
  Remesher(const TriangleMesh& input, std::vector<std::uint8_t> turned, const Progress& progress);
  ~Remesher();

  /** Sets the progress, which is also reported regularly from within CGAL. */
  void setShare(double share);

  /** Marks what must stay, borders and creases sharper than `feature` radians, and numbers the patches in between. */
  std::size_t findPatches(double feature);

  /** One round of splitting, collapsing, flipping and smoothing. */
  void iterate(double length);

  /** The same where the wanted length at the triangle's centre is below `limit`. */
  void iterateWhere(const std::function<double(const Point&)>& wanted, double limit, double length);

  /** The triangles as they now are, with origin and material of the nearest triangle that their patch had. */
  TriangleMesh result();

private:
  class Impl;
  std::unique_ptr<Impl> Work;
};
}  // namespace kalos::meshing

#endif
