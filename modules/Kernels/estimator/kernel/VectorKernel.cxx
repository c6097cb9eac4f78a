// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "estimator/kernel/VectorKernel.cxx"
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)  // no vectors of fixed size
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
#include <hwy/highway.h>

#include "estimator/kernel/VectorKernel.h"

#ifndef kalos_estimator_kernel_VectorKernel_once
#define kalos_estimator_kernel_VectorKernel_once
namespace kalos
{
namespace
{
// What the vector code reads: whole groups of VertexTile::lanes.
struct TileArrays
{
  const float *HWY_RESTRICT px, *HWY_RESTRICT py, *HWY_RESTRICT pz, *HWY_RESTRICT nx, *HWY_RESTRICT ny,
      *HWY_RESTRICT nz;
  const float *HWY_RESTRICT inverseDensity, *HWY_RESTRICT luminous;
  int count;
};

// A number as the sum of two single-precision numbers.
struct SplitNumber
{
  float high, low;
  explicit SplitNumber(double x)
      : high(static_cast<float>(x)), low(static_cast<float>(x - static_cast<double>(this->high)))
  {
  }
};

struct SensorNumbers
{
  SplitNumber x, y, z;
  float nx, ny, nz;  // minus the normal over pi
  float share;
  SensorNumbers(const Sensor& s, double gatherShare)
      : x(s.position.x),
        y(s.position.y),
        z(s.position.z),
        nx(static_cast<float>(-s.normal.x / pi)),
        ny(static_cast<float>(-s.normal.y / pi)),
        nz(static_cast<float>(-s.normal.z / pi)),
        share(static_cast<float>(gatherShare))
  {
  }
};
}  // namespace
}  // namespace kalos
#endif

HWY_BEFORE_NAMESPACE();
namespace kalos
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// out = G / (1 + G share inverseDensity); if weighed times luminous, summed up along each lane. Returns the largest
// then.
template <bool weighed>
HWY_INLINE float evaluate(TileArrays v, const SensorNumbers& s, float* HWY_RESTRICT out)
{
  const hn::CappedTag<float, VertexTile::lanes> d;
  constexpr int width = hn::MaxLanes(hn::CappedTag<float, VertexTile::lanes>()), parts = VertexTile::lanes / width;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-36f), share = hn::Set(d, s.share);
  const auto rx = hn::Set(d, s.x.high), ry = hn::Set(d, s.y.high), rz = hn::Set(d, s.z.high);
  const auto lx = hn::Set(d, s.x.low), ly = hn::Set(d, s.y.low), lz = hn::Set(d, s.z.low);
  const auto sx = hn::Set(d, s.nx), sy = hn::Set(d, s.ny), sz = hn::Set(d, s.nz);
  auto largest = zero;
  hn::Vec<decltype(d)> sum[parts];
  for (auto& part : sum)
    part = zero;
  for (int group = 0; group < v.count; group += VertexTile::lanes)
    for (int part = 0; part < parts; ++part)
    {
      const int i = group + part * width;
      const auto dx = hn::Add(hn::Sub(rx, hn::LoadU(d, v.px + i)), lx);  // from the vertex to the sensor
      const auto dy = hn::Add(hn::Sub(ry, hn::LoadU(d, v.py + i)), ly);
      const auto dz = hn::Add(hn::Sub(rz, hn::LoadU(d, v.pz + i)), lz);
      const auto d2 = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
      const auto atSensor = hn::Add(hn::Add(hn::Mul(dx, sx), hn::Mul(dy, sy)), hn::Mul(dz, sz));  // d cos(theta) / pi
      const auto atVertex = hn::Add(hn::Add(hn::Mul(dx, hn::LoadU(d, v.nx + i)), hn::Mul(dy, hn::LoadU(d, v.ny + i))),
                                    hn::Mul(dz, hn::LoadU(d, v.nz + i)));  // d cos(theta')
      const auto product = hn::Mul(hn::Max(atSensor, zero), hn::Max(atVertex, zero));
      // G = product / d^4, so that G / (1 + G/G*) = product / (d^4 + product / G*).
      const auto limit = hn::Mul(share, hn::LoadU(d, v.inverseDensity + i));
      const auto below = hn::Add(hn::Add(hn::Mul(d2, d2), least), hn::Mul(product, limit));
      const auto weight = weighed ? hn::LoadU(d, v.luminous + i) : one;
      const auto value = hn::Div(hn::Mul(product, weight), below);
      if (weighed)
      {
        sum[part] = hn::Add(sum[part], value);
        largest = hn::Max(largest, value);
      }
      hn::StoreU(weighed ? sum[part] : value, d, out + i);
    }
  return weighed ? hn::GetLane(hn::MaxOfLanes(d, largest)) : 0;
}

void kernels(const TileArrays& v, const SensorNumbers& s, float* kernel)
{
  evaluate<false>(v, s, kernel);
}

float scores(const TileArrays& v, const SensorNumbers& s, float* reached)
{
  return evaluate<true>(v, s, reached);
}
}  // namespace HWY_NAMESPACE
}  // namespace kalos
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kalos
{
HWY_EXPORT(kernels);
HWY_EXPORT(scores);

namespace
{
// Calls work(arrays) for the whole groups of a tile, and for what is left over in a copy filled up with zeros.
template <class Work>
void forGroups(const VertexTile& t, const Work& work)
{
  const VertexSet& v = t.vertices;
  const float* source[] = {
      v.px.data(),      v.py.data(), v.pz.data(), v.nx.data(), v.ny.data(), v.nz.data(), v.inverseDensity.data(),
      v.luminous.data()};
  alignas(64) float filled[8][VertexTile::capacity];
  const bool whole = t.count % VertexTile::lanes == 0;
  for (int a = 0; a < 8; ++a)
  {
    source[a] += t.begin;
    if (whole)
      continue;
    std::fill(std::copy_n(source[a], t.count, filled[a]), filled[a] + t.paddedCount(), 0.0f);
    source[a] = filled[a];
  }
  work(TileArrays{source[0], source[1], source[2], source[3], source[4], source[5], source[6], source[7],
                  t.paddedCount()});
}
}  // namespace

void evaluateKernels(const VertexTile& tile, const Sensor& sensor, double share, float* kernel)
{
  forGroups(tile, [&](const TileArrays& v) { HWY_DYNAMIC_DISPATCH(kernels)(v, SensorNumbers(sensor, share), kernel); });
}

void scoreTile(const VertexTile& tile, const Sensor& sensor, double share, TileScores& scored)
{
  forGroups(tile, [&](const TileArrays& v) {
    scored.largest = HWY_DYNAMIC_DISPATCH(scores)(v, SensorNumbers(sensor, share), scored.reached);
    scored.count = v.count;
  });
}
}  // namespace kalos
#endif
