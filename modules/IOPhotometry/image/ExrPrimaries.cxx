// SPDX-License-Identifier: BSD-3-Clause
#include "ExrPrimaries.h"

#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <cmath>

namespace kalos
{
namespace
{
constexpr double Rounding = 1e-4;  // of primaries that are written in single precision, and rounded to a few digits
}  // namespace

ExrPrimaries primariesOf(const Imf::Header& header)
{
  ExrPrimaries primaries;
  if (!Imf::hasChromaticities(header))
  {
    return primaries;
  }
  const auto toXyz = Imf::RGBtoXYZ(Imf::chromaticities(header), 1.0F);
  const auto toRec709 = toXyz * Imf::XYZtoRGB(Imf::Chromaticities(), 1.0F);
  for (int from = 0; from < 3; ++from)
  {
    for (int to = 0; to < 3; ++to)
    {
      primaries.toRec709[to][from] = toRec709[from][to];
      primaries.isRec709 = primaries.isRec709 && std::abs(toRec709[from][to] - (from == to ? 1.0 : 0.0)) < Rounding;
    }
  }
  for (int c = 0; !primaries.isRec709 && c < 3; ++c)
  {
    primaries.luminance[c] = toXyz[c][1];
  }
  return primaries;
}
}  // namespace kalos
