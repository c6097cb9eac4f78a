// SPDX-License-Identifier: BSD-3-Clause
#include "scene/TriangleTree.h"

#include <algorithm>
#include <numeric>

namespace kalos
{
void TriangleTree::Box::include(const Vec3& p, double margin)
{
  const double at[] = {p.x, p.y, p.z};
  for (int k = 0; k < 3; ++k)
  {
    this->low[k] = std::min(this->low[k], static_cast<float>(at[k] - margin));
    this->high[k] = std::max(this->high[k], static_cast<float>(at[k] + margin));
  }
}

void TriangleTree::Box::include(const Box& b)
{
  for (int k = 0; k < 3; ++k)
  {
    this->low[k] = std::min(this->low[k], b.low[k]);
    this->high[k] = std::max(this->high[k], b.high[k]);
  }
}

float TriangleTree::Box::diagonal() const
{
  float square = 0;
  for (int k = 0; k < 3; ++k)
    square += (this->high[k] - this->low[k]) * (this->high[k] - this->low[k]);
  return std::sqrt(square);
}

TriangleTree::TriangleTree(const Scene& scene, const std::function<bool(std::uint32_t)>& isPlain)
    : Scene_(scene), Order(scene.data().triangles.size()), Boxes(scene.data().triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  for (const std::uint32_t t : this->Order)
    for (int i = 0; i < 3; ++i)
      this->Boxes[t].include(scene.corner(t, i), scene.reach(t, scene.corner(t, i)));
  this->build(0, static_cast<std::uint32_t>(this->Order.size()), isPlain);
}

std::uint32_t TriangleTree::build(std::uint32_t first, std::uint32_t end,
                                  const std::function<bool(std::uint32_t)>& isPlain)
{
  constexpr std::uint32_t leaf = 6;
  const auto index = static_cast<std::uint32_t>(this->Nodes.size());
  const auto& material = this->Scene_.data().triangleMaterial;
  Node node;
  float low[3] = {infinite, infinite, infinite}, high[3] = {-infinite, -infinite, -infinite};  // of middles
  node.material = first < end ? material[this->Order[first]] : mixed;
  for (std::uint32_t i = first; i < end; ++i)
  {
    const std::uint32_t t = this->Order[i];
    const Box& box = this->Boxes[t];
    node.box.include(box);
    node.largest = std::max(node.largest, box.diagonal());
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], box.middle(k));
      high[k] = std::max(high[k], box.middle(k));
    }
    if (material[t] != node.material || !isPlain(t))
      node.material = mixed;
  }
  node.first = first;
  node.end = end;
  this->Nodes.push_back(node);
  if (end - first <= leaf)
    return index;
  int axis = 0;
  for (const int k : {1, 2})
    if (high[k] - low[k] > high[axis] - low[axis])
      axis = k;
  const std::uint32_t half = first + (end - first) / 2;
  std::nth_element(
      this->Order.begin() + first, this->Order.begin() + half, this->Order.begin() + end,
      [&](std::uint32_t a, std::uint32_t b) { return this->Boxes[a].middle(axis) < this->Boxes[b].middle(axis); });
  const std::uint32_t left = this->build(first, half, isPlain), right = this->build(half, end, isPlain);
  this->Nodes[index].first = left;
  this->Nodes[index].right = right;
  return index;
}
}  // namespace kalos
