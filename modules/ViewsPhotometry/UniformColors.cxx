// SPDX-License-Identifier: BSD-3-Clause
#include "UniformColors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kalos
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

using Lab = std::array<double, 3>;

/** Oklab to linear sRGB, with the matrices of Ottosson's definition. */
Rgb linearRgb(const Lab& lab)
{
  const double l = std::pow(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2], 3.0);
  const double m = std::pow(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2], 3.0);
  const double s = std::pow(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2], 3.0);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool inGamut(const Rgb& rgb)
{
  return std::all_of(rgb.begin(), rgb.end(), [](double c) { return c >= 0.0 && c <= 1.0; });
}

Lab fromHue(double lightness, double chroma, double hue)
{
  return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

/** The curve at t in [0,1]. */
Lab curve(double t)
{
  const double lightness = 0.15 + 0.82 * t;
  const double hue = (270.0 + 200.0 * t) * Pi / 180.0;
  double inside = 0.0;
  double outside = 0.4;
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (inside + outside);
    (inGamut(linearRgb(fromHue(lightness, middle, hue))) ? inside : outside) = middle;
  }
  // Nearly all the chroma there is, but no more than keeps the curve smooth.
  const double chroma = std::min(0.95 * inside, 0.17);
  return fromHue(lightness, chroma, hue);
}

double distance(const Lab& a, const Lab& b)
{
  return std::sqrt(std::pow(a[0] - b[0], 2.0) + std::pow(a[1] - b[1], 2.0) + std::pow(a[2] - b[2], 2.0));
}

Rgb encode(const Rgb& linear)
{
  Rgb encoded{};
  std::transform(linear.begin(), linear.end(), encoded.begin(), [](double c) {
    c = std::clamp(c, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  });
  return encoded;
}

std::array<Rgb, 256> makeColors()
{
  constexpr int fine = 4096;
  std::vector<double> length(fine + 1, 0.0);
  for (int i = 1; i <= fine; ++i)
  {
    const double before = static_cast<double>(i - 1) / fine;
    length[i] = length[i - 1] + distance(curve(before), curve(static_cast<double>(i) / fine));
  }
  std::array<Rgb, 256> colors{};
  for (std::size_t c = 0; c < colors.size(); ++c)
  {
    const double wanted = length.back() * static_cast<double>(c) / 255.0;
    const auto at = std::lower_bound(length.begin(), length.end(), wanted) - length.begin();
    colors[c] = encode(linearRgb(curve(static_cast<double>(std::min<std::ptrdiff_t>(at, fine)) / fine)));
  }
  return colors;
}
}  // namespace

const std::array<Rgb, 256>& uniformColors()
{
  static const std::array<Rgb, 256> colors = makeColors();
  return colors;
}
}  // namespace kalos
