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
  std::array<Vector3, 3> Axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  ///< images of the unit vectors
  Vector3 Origin{};                                                                  ///< image of the origin

  Vector3 Direction(const Vector3& d) const
  {
    return d[0] * this->Axes[0] + d[1] * this->Axes[1] + d[2] * this->Axes[2];
  }
  Vector3 Point(const Vector3& p) const { return this->Origin + this->Direction(p); }
  /** This map after `inner`. */
  Transform operator*(const Transform& inner) const
  {
    Transform product;
    for (int i = 0; i < 3; ++i)
    {
      product.Axes[i] = this->Direction(inner.Axes[i]);
    }
    product.Origin = this->Point(inner.Origin);
    return product;
  }
  /** Whether it turns right hands into left ones, and so the corners of a polygon over. */
  bool Mirrors() const { return dot(cross(this->Axes[0], this->Axes[1]), this->Axes[2]) < 0.0; }
};
}  // namespace kalos::scene

#endif
