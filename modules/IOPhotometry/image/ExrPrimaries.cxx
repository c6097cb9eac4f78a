// SPDX-License-Identifier: BSD-3-Clause
#include "ExrPrimaries.h"

#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <cmath>

#include "vtkKalosArrayNames.h"

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

void toRec709(vtkFloatArray* bands, const ExrPrimaries& primaries)
{
  for (vtkIdType i = 0; i < bands->GetNumberOfTuples(); ++i)
  {
    float* rgb = bands->GetPointer(3 * i);
    const double own[3] = {rgb[0], rgb[1], rgb[2]};
    for (int c = 0; c < 3; ++c)
    {
      const double* row = primaries.toRec709[c];
      rgb[c] = static_cast<float>(row[0] * own[0] + row[1] * own[1] + row[2] * own[2]);
    }
  }
}

vtkSmartPointer<vtkFloatArray> luminanceOf(vtkFloatArray* bands, const ExrPrimaries& primaries)
{
  auto luminance = vtkSmartPointer<vtkFloatArray>::New();
  luminance->SetName(vtkKalosArrayNames::Luminance);
  luminance->SetNumberOfTuples(bands->GetNumberOfTuples());
  const double* weights = primaries.luminance;
  for (vtkIdType i = 0; i < bands->GetNumberOfTuples(); ++i)
  {
    const float* rgb = bands->GetPointer(3 * i);
    luminance->SetValue(i, static_cast<float>(weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2]));
  }
  return luminance;
}
}  // namespace kalos
