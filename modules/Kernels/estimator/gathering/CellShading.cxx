// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/CellShading.h"

#include <algorithm>

namespace kalos
{
namespace
{
constexpr std::size_t partSize = 256;  // cells
}

void CellShading::add(std::vector<SurfaceHit>& hits)
{
  for (SurfaceHit& hit : hits)
    this->Grid.add(hit, this->Round.seed);
}

void CellShading::reserve()
{
  this->Picked.resize(this->cells());
  this->Indirect.resize(this->cells() * static_cast<std::size_t>(this->Rays.scene().bands()));
}

std::size_t CellShading::parts() const
{
  return (this->cells() + partSize - 1) / partSize;
}

void CellShading::shade(std::size_t part)
{
  const int bands = this->Rays.scene().bands();
  WavefrontGather wave(this->Rays, this->Round.pool);
  const std::size_t begin = std::min(this->cells(), part * partSize), end = std::min(this->cells(), begin + partSize);
  for (std::size_t c = begin; c < end; ++c)
    this->estimate(this->Grid.cells()[c].representative, wave);
  wave.run();
  for (std::size_t c = begin; c < end; ++c)
  {
    std::copy_n(wave.light(c - begin), bands, &this->Indirect[c * bands]);
    this->Picked[c] = wave.picks(c - begin);
  }
}

void CellShading::clear()
{
  this->Grid = {};
  this->Indirect = {};
  this->Picked = {};
}

const double* CellShading::indirect(const SurfaceHit& hit) const
{
  return &this->Indirect[hit.cell * static_cast<std::size_t>(this->Rays.scene().bands())];
}

void CellShading::estimate(const SurfaceHit& hit, WavefrontGather& wave) const
{
  wave.indirectLight(sensorAt(this->Rays.scene(), hit), hit.near,
                     SampleStream(Sampling::Independent, this->Round.seed,
                                  static_cast<std::uint64_t>(this->Round.replicate), Purpose::Gather, hit.cell));
}

Sensor sensorAt(const Scene& scene, const SurfaceHit& hit)
{
  const std::uint32_t triangle = hit.side / 2;
  const Vec3 n = hit.side & 1 ? scene.normal(triangle) : -scene.normal(triangle);
  Vec3 p{hit.position[0], hit.position[1], hit.position[2]};
  p += dot(scene.corner(triangle, 0) - p, n) * n;  // onto the plane, in double precision
  return Sensor(scene.anchor(triangle, p, n));
}
}  // namespace kalos
