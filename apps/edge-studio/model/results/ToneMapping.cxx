// SPDX-License-Identifier: BSD-3-Clause
#include "results/ToneMapping.h"

#include <algorithm>
#include <cmath>

namespace studio
{
Exposure exposureOf(const QVector<ResultPtr>& results, const Display& display)
{
  Exposure exposure;
  exposure.white = rangeOf(results, display)[1];
  const std::vector<double> values = litValues(results, display);
  double sum = 0;
  for (double value : values)
    sum += std::log(value);
  exposure.average = values.empty() ? 0.18 * exposure.white : std::exp(sum / static_cast<double>(values.size()));
  return exposure;
}

double toneMapped(double luminance, const Exposure& exposure)
{
  constexpr double key = 0.18;
  const double x = key / exposure.average * std::max(0.0, luminance), white = key / exposure.average * exposure.white;
  return std::min(1.0, x * (1 + x / (white * white)) / (1 + x));
}

double encoded(double light)
{
  const double c = std::clamp(light, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

vtkSmartPointer<vtkLookupTable> photographicGreys(const Exposure& exposure)
{
  constexpr int count = 1024;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(1e-4 * exposure.white, exposure.white);
  table->SetScaleToLog10();
  for (int i = 0; i < count; ++i)
  {
    const double value = exposure.white * std::pow(10.0, 4 * (static_cast<double>(i) / (count - 1) - 1)),
                 grey = i == 0 ? 0 : encoded(toneMapped(value, exposure));
    table->SetTableValue(i, grey, grey, grey);
  }
  return table;
}

std::array<unsigned char, 3> photographicColour(const double bands[3], const Exposure& exposure)
{
  const double luminance = 0.2126 * bands[0] + 0.7152 * bands[1] + 0.0722 * bands[2];
  const double scale = luminance > 0 ? toneMapped(luminance, exposure) / luminance : 0;
  std::array<unsigned char, 3> colour;
  for (int i = 0; i < 3; ++i)
    colour[i] = static_cast<unsigned char>(std::lround(255 * encoded(scale * bands[i])));
  return colour;
}
}  // namespace studio
