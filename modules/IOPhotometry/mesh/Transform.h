// SPDX-License-Identifier: BSD-3-Clause
/** Affine maps of space, as the nodes of a glTF have. */
#ifndef KalosTransform_h
#define KalosTransform_h

#include <array>

#include "Mesh.h"

namespace kalos::scene
{
struct Transform
{
  std::array<Vector3, 3> axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  ///< images of the unit vectors
  Vector3 origin{};                                                                  ///< image of the origin

  Vector3 direction(const Vector3& d) const
  {
    return d[0] * this->axes[0] + d[1] * this->axes[1] + d[2] * this->axes[2];
  }
  Vector3 point(const Vector3& p) const { return this->origin + this->direction(p); }
  /** This map after `inner`. */
  Transform operator*(const Transform& inner) const
  {
    Transform product;
    for (int i = 0; i < 3; ++i)
    {
      product.axes[i] = this->direction(inner.axes[i]);
    }
    product.origin = this->point(inner.origin);
    return product;
  }
  /** Whether it changes handedness, and so the orientation of polygons. */
  bool mirrors() const { return dot(cross(this->axes[0], this->axes[1]), this->axes[2]) < 0.0; }
};
}  // namespace kalos::scene

#endif
