// SPDX-License-Identifier: BSD-3-Clause
// Glass on the way of gather rays.
#include "estimator/gathering/WavefrontGather.h"

namespace kalos
{
// Where a ray ends that opaque surfaces would end at y: at each pane of glass it passes or is reflected, in proportion
// to what the glass does with light. The path then starts at the last pane that has reflected it.
SurfacePoint WavefrontGather::passPanes(std::size_t i, SurfacePoint y)
{
  const Scene& scene = this->Rays.scene();
  PathState& path = this->Paths[i];
  RayAnchor from = path.at.anchor;
  for (SurfacePoint pane = scene.pane(from, path.sampled.direction, y); pane.valid;
       pane = scene.pane(from, path.sampled.direction, y))
  {
    if (path.sampled.mirror)
      this->Rays.luminaires().addSeen(from.lifted(), path.sampled.direction, pane, path.throughput, this->found(i));
    const Glass& glass = *scene.material(pane.triangle).glass;
    const double cosine = dot(path.sampled.direction, pane.normal), through = glass.transmittance(cosine),
                 back = glass.reflectance(cosine);
    for (int b = 0; b < scene.bands(); ++b)
      path.throughput[b] *= through + back;
    const bool passes = path.random.next() * (through + back) < through;
    from = passes ? scene.behind(pane) : scene.anchor(pane);
    if (passes && !path.sampled.mirror)
      continue;
    path.at.anchor = from;
    path.at.position = pane.position;
    if (passes)
      continue;
    path.sampled.direction = reflected(-path.sampled.direction, pane.normal);
    path.sampled.mirror = true;
    y = scene.trace(from, path.sampled.direction);
  }
  return y;
}
}  // namespace kalos
