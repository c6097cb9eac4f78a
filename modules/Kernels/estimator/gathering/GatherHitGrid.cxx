// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/GatherHitGrid.h"

#include <cstring>

#include "sampling/Random.h"

namespace kalos
{
std::vector<Face> facesOf(const Scene& scene)
{
  std::vector<Face> faces(scene.data().triangles.size());
  for (std::uint32_t t = 0; t < faces.size(); ++t)
  {
    const Vec3& n = scene.normal(t);
    Face& face = faces[t];
    face.normal[0] = static_cast<float>(n.x);
    face.normal[1] = static_cast<float>(n.y);
    face.normal[2] = static_cast<float>(n.z);
    face.plane = static_cast<float>(dot(n, scene.corner(t, 0)));
    face.across = static_cast<std::uint32_t>(mainAxis(n));
    auto quarter = [](double x) { return static_cast<std::uint32_t>(std::floor(4 * x + 4.5)); };
    face.key = quarter(n.x) << 8 | quarter(n.y) << 4 | quarter(n.z);
  }
  return faces;
}

std::uint64_t cellKey(const Face& face, const SurfaceHit& hit, float distance, float share)
{
  // The exponent of the width: 2^e, and 2^-e, from the bits of the float.
  const float width = std::max(distance * share, 1e-6f);
  std::uint32_t bits;
  std::memcpy(&bits, &width, sizeof bits);
  const std::uint32_t exponent = bits >> 23, inverseBits = (254 - exponent) << 23;
  float inverse;
  std::memcpy(&inverse, &inverseBits, sizeof inverse);
  auto index = [&](float x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x * inverse))); };
  const float u = hit.position[face.across == 0 ? 1 : 0], v = hit.position[face.across == 2 ? 1 : 2];
  const std::uint64_t level = static_cast<std::uint64_t>(face.key) << 16 | exponent << 1 | (hit.side & 1);
  // Offset from the origin, because planes through the scene's centre would lie between two layers.
  const std::uint64_t layer = index(4 * face.plane + 0.37f / inverse);
  return mixBits(mixBits(index(u) ^ index(v) << 32) + mixBits(layer << 32 ^ level));
}

void GatherHitGrid::add(SurfaceHit& hit, std::uint64_t seed)
{
  if (2 * this->Cells.size() >= this->Slots.size())
    this->grow();
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t i = hit.cell & mask;
  while (this->Slots[i].cell >= 0 && this->Slots[i].key != hit.cell)
    i = (i + 1) & mask;
  Slot& slot = this->Slots[i];
  if (slot.cell < 0)
  {
    slot = {hit.cell, static_cast<std::int32_t>(this->Cells.size())};
    this->Cells.emplace_back();
  }
  // Reservoir sampling: each of the first n hits is kept with probability 1/n.
  Cell& cell = this->Cells[slot.cell];
  ++cell.hits;
  hit.cell = static_cast<std::uint64_t>(slot.cell);
  const std::uint64_t random = mixBits(seed + ++this->Added) >> 32;
  if (random * static_cast<std::uint64_t>(cell.hits) < 1ull << 32)
    cell.representative = hit;
}

void GatherHitGrid::grow()
{
  std::vector<Slot> old(std::max<std::size_t>(64, 4 * this->Slots.size()));
  old.swap(this->Slots);
  const std::size_t mask = this->Slots.size() - 1;
  for (const Slot& slot : old)
  {
    if (slot.cell < 0)
      continue;
    std::size_t i = slot.key & mask;
    while (this->Slots[i].cell >= 0)
      i = (i + 1) & mask;
    this->Slots[i] = slot;
  }
}
}  // namespace kalos
