// SPDX-License-Identifier: BSD-3-Clause
/** Distances of points to the nearest of many segments. */
#ifndef KalosMeshingEdgeDistance_h
#define KalosMeshingEdgeDistance_h

#include <cstddef>
#include <memory>

#include "singular/SingularEdges.h"

namespace kalos::meshing
{
class EdgeDistance
{
public:
  explicit EdgeDistance(const Curves& curves);
  ~EdgeDistance();

  struct Nearest
  {
    double distance;    ///< m; infinite without curves
    std::size_t curve;  ///< index in Curves::curves
  };
  Nearest nearest(const Point& point) const;

private:
  struct Impl;
  std::unique_ptr<Impl> Tree;
};
}  // namespace kalos::meshing

#endif
