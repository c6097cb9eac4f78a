// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "estimator/direct/LightSampler.cxx"
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)  // no vectors of fixed size
#include <hwy/foreach_target.h>  // compiles this file once for every instruction set
#include <hwy/highway.h>

#include "estimator/direct/LightSampler.h"
#include "photometry/CandelaBound.h"

#ifndef kalos_estimator_direct_LightSampler_once
#define kalos_estimator_direct_LightSampler_once
namespace kalos
{
namespace
{
// What the vector code reads: whole groups of LuminaireWeights::lanes.
struct LampArrays
{
  const float *HWY_RESTRICT x, *HWY_RESTRICT y, *HWY_RESTRICT z;
  const float *HWY_RESTRICT px, *HWY_RESTRICT py, *HWY_RESTRICT pz;
  const float *HWY_RESTRICT zx, *HWY_RESTRICT zy, *HWY_RESTRICT zz;
  const float *HWY_RESTRICT radius, *HWY_RESTRICT near2;
  const float *HWY_RESTRICT isotropic, *HWY_RESTRICT cosine, *HWY_RESTRICT measured;
  const std::int32_t* HWY_RESTRICT bound;
  const float* bounds;  // null: no luminaire has a table
  int count;
};

struct SensorNumbers
{
  float x, y, z, nx, ny, nz;
  explicit SensorNumbers(const Sensor& s)
      : x(static_cast<float>(s.position.x)),
        y(static_cast<float>(s.position.y)),
        z(static_cast<float>(s.position.z)),
        nx(static_cast<float>(s.normal.x)),
        ny(static_cast<float>(s.normal.y)),
        nz(static_cast<float>(s.normal.z))
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
using Tag = hn::CappedTag<float, LuminaireWeights::lanes>;
using Floats = hn::Vec<Tag>;

// Height over the horizon, of what reaches `radius` beyond its middle: positive as soon as any of it is above.
HWY_INLINE Floats lit(Floats height, Floats radius)
{
  const Tag d;
  const auto edge = hn::Mul(hn::Set(d, 0.25f), hn::Add(height, radius));
  return hn::Max(hn::Max(height, edge), hn::Zero(d));
}

// The bound's value in the direction (vx, vy, vz) of length `distance` and component `along` the pole.
HWY_INLINE Floats boundAt(const LampArrays& l, int i, Floats vx, Floats vy, Floats vz, Floats along, Floats distance)
{
  const Tag d;
  const hn::RebindToSigned<Tag> di;
  const auto zero = hn::Zero(d), half = hn::Set(d, 0.5f);
  const auto px = hn::LoadU(d, l.px + i), py = hn::LoadU(d, l.py + i), pz = hn::LoadU(d, l.pz + i);
  const auto zx = hn::LoadU(d, l.zx + i), zy = hn::LoadU(d, l.zy + i), zz = hn::LoadU(d, l.zz + i);
  const auto z = hn::Add(hn::Add(hn::Mul(vx, zx), hn::Mul(vy, zy)), hn::Mul(vz, zz));
  // q = v . (zero x pole): the photometric frame is left-handed.
  const auto qx = hn::Sub(hn::Mul(zy, pz), hn::Mul(zz, py)), qy = hn::Sub(hn::Mul(zz, px), hn::Mul(zx, pz));
  const auto qz = hn::Sub(hn::Mul(zx, py), hn::Mul(zy, px));
  const auto q = hn::Add(hn::Add(hn::Mul(vx, qx), hn::Mul(vy, qy)), hn::Mul(vz, qz));

  const auto square = hn::Max(hn::Sub(half, hn::Div(hn::Mul(half, along), distance)), zero);
  const auto row =
      hn::Min(hn::Mul(hn::Sqrt(square), hn::Set(d, 1.0f * CandelaBound::rows)), hn::Set(d, CandelaBound::rows - 0.5f));
  const auto t = hn::Div(q, hn::Add(hn::Add(hn::Abs(z), hn::Abs(q)), hn::Set(d, 1e-30f)));
  const auto turned = hn::IfThenElse(hn::Ge(z, zero), hn::Add(hn::Set(d, 1.0f), t), hn::Sub(hn::Set(d, 3.0f), t));
  const auto column = hn::Clamp(hn::Mul(turned, hn::Set(d, 0.25f * CandelaBound::columns)), zero,
                                hn::Set(d, CandelaBound::columns - 0.5f));
  const auto bin =
      hn::Add(hn::Mul(hn::ConvertTo(di, row), hn::Set(di, CandelaBound::columns)), hn::ConvertTo(di, column));
  return hn::GatherIndex(d, l.bounds, hn::Add(bin, hn::LoadU(di, l.bound + i)));
}

// Returns whether any is near.
bool weighAll(const LampArrays& l, const SensorNumbers& s, float* HWY_RESTRICT out)
{
  const Tag d;
  constexpr int width = hn::MaxLanes(Tag());
  const auto zero = hn::Zero(d);
  const auto sx = hn::Set(d, s.x), sy = hn::Set(d, s.y), sz = hn::Set(d, s.z);
  const auto nx = hn::Set(d, s.nx), ny = hn::Set(d, s.ny), nz = hn::Set(d, s.nz);
  bool anyNear = false;
  for (int i = 0; i < l.count; i += width)
  {
    const auto radius = hn::LoadU(d, l.radius + i);
    const auto vx = hn::Sub(sx, hn::LoadU(d, l.x + i));  // from the luminaire to the sensor
    const auto vy = hn::Sub(sy, hn::LoadU(d, l.y + i));
    const auto vz = hn::Sub(sz, hn::LoadU(d, l.z + i));
    const auto d2 = hn::Add(hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy)), hn::Mul(vz, vz));
    const auto below = hn::Add(hn::Add(hn::Mul(vx, nx), hn::Mul(vy, ny)), hn::Mul(vz, nz));  // -d cos(theta)
    const auto along = hn::Add(hn::Add(hn::Mul(vx, hn::LoadU(d, l.px + i)), hn::Mul(vy, hn::LoadU(d, l.py + i))),
                               hn::Mul(vz, hn::LoadU(d, l.pz + i)));  // d cos(gamma)
    const auto within = hn::Add(d2, hn::Mul(radius, radius));         // never 0
    const auto distance = hn::Sqrt(within);
    auto candela = hn::Add(hn::LoadU(d, l.isotropic + i),
                           hn::Div(hn::Mul(hn::LoadU(d, l.cosine + i), lit(along, radius)), distance));
    if (l.bounds)
      candela = hn::Add(candela, hn::Mul(hn::LoadU(d, l.measured + i),
                                         boundAt(l, i, vx, vy, vz, along, hn::Sqrt(hn::Max(d2, hn::Set(d, 1e-36f))))));
    const auto weight = hn::Div(hn::Mul(candela, lit(hn::Neg(below), radius)), hn::Mul(within, distance));
    const auto isNear = hn::Lt(d2, hn::LoadU(d, l.near2 + i));
    anyNear = anyNear || !hn::AllFalse(d, isNear);
    hn::StoreU(hn::IfThenElse(isNear, hn::Set(d, -1.0f), hn::Max(weight, zero)), d, out + i);
  }
  return anyNear;
}
}  // namespace HWY_NAMESPACE
}  // namespace kalos
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kalos
{
HWY_EXPORT(weighAll);

namespace
{
constexpr double nearRectangle = 2;  // times the larger side: beyond, its middle stands for it
constexpr double rounding = 1e-5;    // of a length, what single precision may lose

void push(std::vector<float>& x, std::vector<float>& y, std::vector<float>& z, const Vec3& v)
{
  x.push_back(static_cast<float>(v.x));
  y.push_back(static_cast<float>(v.y));
  z.push_back(static_cast<float>(v.z));
}
}  // namespace

void LuminaireWeights::sum()
{
  std::fill_n(this->Lane, lanes, 0.0);
  for (std::size_t i = 0; i < this->weight.size(); i += lanes)
    for (int lane = 0; lane < lanes; ++lane)
      this->Lane[lane] += static_cast<double>(this->weight[i + lane]);
  this->Total = 0;
  for (const double lane : this->Lane)
    this->Total += lane;
}

std::size_t LuminaireWeights::draw(double u) const
{
  // A lane, then a luminaire of it; the last that has weight where rounding leads beyond it.
  double rest = u * this->Total;
  int lane = 0, last = 0;
  for (; lane < lanes; ++lane)
  {
    if (!(this->Lane[lane] > 0))
      continue;
    last = lane;
    if (rest < this->Lane[lane])
      break;
    rest -= this->Lane[lane];
  }
  std::size_t found = static_cast<std::size_t>(last);
  for (std::size_t i = found; i < this->weight.size(); i += lanes)
  {
    if (!(this->weight[i] > 0))
      continue;
    found = i;
    if (lane < lanes && rest < static_cast<double>(this->weight[i]))
      break;
    rest -= static_cast<double>(this->weight[i]);
  }
  return found;
}

LightSampler::LightSampler(const Scene& scene) : Count(scene.data().luminaires.size())
{
  if (this->Count < 2)
    return;  // nothing to choose
  for (const Luminaire& luminaire : scene.data().luminaires)
    this->add(luminaire, rounding * scene.size());
  while (this->All.x.size() % LuminaireWeights::lanes)
    this->add(Luminaire{}, 1);
}

void LightSampler::add(const Luminaire& l, double leastRadius)
{
  Lamps& all = this->All;
  const bool isTable = l.distribution == Distribution::Measured,
             aboutSide = isTable && l.table->pole() == CandelaTable::Pole::Side;
  push(all.x, all.y, all.z, l.position);
  push(all.px, all.py, all.pz, aboutSide ? l.up : l.axis);
  push(all.zx, all.zy, all.zz, aboutSide ? l.axis : cross(l.axis, l.up));
  const double side = std::max(length(l.sideU), length(l.sideV)), times = l.isOpening() ? nearOpening : nearRectangle;
  const double nearBelow = l.isPoint() ? 0 : (1 + rounding) * times * side + leastRadius;
  all.near2.push_back(static_cast<float>(nearBelow * nearBelow));
  const double corner = 0.5 * std::max(length(l.sideU + l.sideV), length(l.sideU - l.sideV));
  all.radius.push_back(static_cast<float>(leastRadius + (isTable ? 0 : corner)));
  const bool isIsotropic = l.isPoint() && l.distribution == Distribution::Isotropic;
  all.isotropic.push_back(static_cast<float>(isIsotropic ? l.flux / (4 * pi) : 0));
  all.cosine.push_back(static_cast<float>(isIsotropic || isTable ? 0 : l.flux / pi));
  all.measured.push_back(static_cast<float>(isTable ? l.flux / l.table->flux() : 0));
  all.bound.push_back(isTable ? this->boundOf(l) : 0);
}

std::int32_t LightSampler::boundOf(const Luminaire& l)
{
  constexpr int size = CandelaBound::rows * CandelaBound::columns;
  const auto found = std::find(this->Tables.begin(), this->Tables.end(), l.table.get());
  const auto k = static_cast<std::int32_t>(found - this->Tables.begin());
  if (found == this->Tables.end())
  {
    const CandelaBound bound(*l.table);
    this->Tables.push_back(l.table.get());
    this->Bounds.insert(this->Bounds.end(), bound.candela().begin(), bound.candela().end());
  }
  return k * size;
}

bool LightSampler::weigh(const Sensor& sensor, LuminaireWeights& weights) const
{
  const Lamps& l = this->All;
  weights.weight.resize(l.x.size());
  return HWY_DYNAMIC_DISPATCH(weighAll)(
      {l.x.data(), l.y.data(), l.z.data(), l.px.data(), l.py.data(), l.pz.data(), l.zx.data(), l.zy.data(), l.zz.data(),
       l.radius.data(), l.near2.data(), l.isotropic.data(), l.cosine.data(), l.measured.data(), l.bound.data(),
       this->Bounds.empty() ? nullptr : this->Bounds.data(), static_cast<int>(l.x.size())},
      SensorNumbers(sensor), weights.weight.data());
}
}  // namespace kalos
#endif
