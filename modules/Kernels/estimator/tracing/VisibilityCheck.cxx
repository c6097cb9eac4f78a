// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/VisibilityCheck.h"

#include "estimator/tracing/VertexSet.h"

namespace kalos
{
void VisibilityCheck::add(const RayAnchor& from, std::size_t surface, const SurfacePoint& to)
{
  this->Packet.set(this->Count, this->Scene_.anchor(to), VertexSet::stored(from));
  this->Surface[this->Count++] = surface;
  if (this->Count == SegmentPacket::width)
    this->finish();
}

void VisibilityCheck::finish()
{
  if (this->Count == 0)
    return;
  const std::uint32_t hidden = this->Scene_.rays().occluded(this->Packet, this->Count);
  for (int i = 0; i < this->Count; ++i)
  {
    this->Energy.checked(this->Surface[i]) += 1;
    this->Energy.unseen(this->Surface[i]) += hidden >> i & 1;
  }
  this->Count = 0;
}
}  // namespace kalos
