// SPDX-License-Identifier: BSD-3-Clause
// Pairs of triangles whose boxes meet.
#ifndef kalos_scene_TriangleTree_h
#define kalos_scene_TriangleTree_h

#include <functional>
#include <limits>
#include <utility>

#include "scene/Scene.h"

namespace kalos
{
/// A tree of boxes about the triangles of a scene, each wider by how far single precision may put it off its plane.
/// Every pair is looked for from its smaller triangle, and branches of smaller triangles alone are left out, and those
/// of one material if it is plain: pairs of it do not matter.
class TriangleTree
{
public:
  TriangleTree(const Scene& scene, const std::function<bool(std::uint32_t)>& isPlain);

  /// Calls visit(other) for the triangles that are larger than t, or as large and later.
  template <class Visit>
  void forEachLarger(std::uint32_t t, const Visit& visit) const
  {
    const float size = this->Boxes[t].diagonal();
    std::uint32_t stack[64];
    int open = 0;
    stack[open++] = 0;
    while (open > 0)
    {
      const Node& node = this->Nodes[stack[--open]];
      if (node.largest < size || node.material == this->Scene_.data().triangleMaterial[t] ||
          !node.box.meets(this->Boxes[t]))
        continue;
      if (node.right)
      {
        stack[open++] = node.right;
        stack[open++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.end; ++i)
      {
        const std::uint32_t other = this->Order[i];
        if (this->Boxes[other].meets(this->Boxes[t]) &&
            std::make_pair(this->Boxes[other].diagonal(), other) > std::make_pair(size, t))
          visit(other);
      }
    }
  }

private:
  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static constexpr std::uint32_t mixed = ~0u;  // in place of a material: more than one, or such as matter by themselves

  // In single precision: what meets at borders alone does not matter.
  struct Box
  {
    float low[3] = {infinite, infinite, infinite}, high[3] = {-infinite, -infinite, -infinite};

    void include(const Vec3& p, double margin);
    void include(const Box& b);
    float middle(int axis) const { return 0.5f * (this->low[axis] + this->high[axis]); }
    float diagonal() const;
    bool meets(const Box& b) const
    {
      for (int k = 0; k < 3; ++k)
        if (this->low[k] > b.high[k] || b.low[k] > this->high[k])
          return false;
      return true;
    }
  };
  struct Node
  {
    Box box;
    float largest = 0;
    std::uint32_t material = mixed;
    std::uint32_t first = 0, end = 0;  // of a leaf: triangles in Order; else `first` is the left branch
    std::uint32_t right = 0;           // 0: a leaf
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t end, const std::function<bool(std::uint32_t)>& isPlain);

  const Scene& Scene_;
  std::vector<std::uint32_t> Order;
  std::vector<Box> Boxes;
  std::vector<Node> Nodes;
};
}  // namespace kalos

#endif
