// SPDX-License-Identifier: BSD-3-Clause
#include "sky/SkyPattern.h"

#include <stdexcept>
#include <string>

namespace kalos
{
namespace
{
// CIE S 011/E:2003, table 1: a, b, c, d, e of types 1 to 15.
constexpr double cieTypes[15][5] = {
    {4, -0.7, 0, -1, 0},        {4, -0.7, 2, -1.5, 0.15},  {1.1, -0.8, 0, -1, 0},       {1.1, -0.8, 2, -1.5, 0.15},
    {0, -1, 0, -1, 0},          {0, -1, 2, -1.5, 0.15},    {0, -1, 5, -2.5, 0.3},       {0, -1, 10, -3, 0.45},
    {-1, -0.55, 2, -1.5, 0.15}, {-1, -0.55, 5, -2.5, 0.3}, {-1, -0.55, 10, -3, 0.45},   {-1, -0.32, 10, -3, 0.45},
    {-1, -0.32, 16, -3, 0.3},   {-1, -0.15, 16, -3, 0.3},  {-1, -0.15, 24, -2.8, 0.15},
};

class GeneralSky : public SkyPattern
{
public:
  GeneralSky(const SkyCoefficients& coefficients, const Vec3& sun) : K(coefficients), Sun(sun) {}

  double relative(const Vec3& direction) const override
  {
    const double height = std::max(direction.z, this->K.b > 0 ? lowest : tiny);
    const double gradation = 1 + this->K.a * std::exp(this->K.b / height);
    if (this->K.c == 0 && this->K.e == 0)
      return std::max(0.0, gradation);
    const double cosine = std::clamp(dot(direction, this->Sun), -1.0, 1.0), chi = std::acos(cosine);
    const double indicatrix = this->K.base + this->K.c * std::exp(this->K.d * chi) + this->K.e * cosine * cosine;
    return std::max(0.0, gradation * indicatrix);
  }

  bool isUniform() const override { return this->K.a == 0 && this->K.c == 0 && this->K.e == 0; }

private:
  static constexpr double tiny = 1e-300;
  static constexpr double lowest = 0.01;  // sin gamma below which a sky that brightens without bound is level

  SkyCoefficients K;
  Vec3 Sun;
};

class TraditionalOvercast : public SkyPattern
{
public:
  double relative(const Vec3& direction) const override { return (1 + 2 * direction.z) / 3; }
};

class MappedSky : public SkyPattern
{
public:
  MappedSky(const SkyMap& map, const Vec3& north) : Map(map), North(north), East{north.y, -north.x, 0} {}

  double relative(const Vec3& direction) const override
  {
    const double azimuth = std::atan2(dot(direction, this->East), dot(direction, this->North));
    const double across = (0.5 + azimuth / (2 * pi)) * this->Map.width;
    const double down = std::acos(std::clamp(direction.z, -1.0, 1.0)) / pi * this->Map.height;
    const int column = std::min(static_cast<int>(across), this->Map.width - 1);
    const int row = std::min(static_cast<int>(down), this->Map.height - 1);
    return static_cast<double>(this->Map.luminance[static_cast<std::size_t>(row) * this->Map.width + column]);
  }

private:
  SkyMap Map;
  Vec3 North, East;
};
}  // namespace

SkyCoefficients cieSky(int type)
{
  if (type < 1 || type > 15)
    throw std::invalid_argument("sky: type " + std::to_string(type) + " has no coefficients; expected 1 to 15");
  const double* t = cieTypes[type - 1];
  return {t[0], t[1], t[2], t[3], t[4], 1 - t[2] * std::exp(t[3] * pi / 2)};
}

std::unique_ptr<SkyPattern> makeSky(const SkyCoefficients& coefficients, const Vec3& sun)
{
  return std::make_unique<GeneralSky>(coefficients, sun);
}

std::unique_ptr<SkyPattern> makeTraditionalOvercast()
{
  return std::make_unique<TraditionalOvercast>();
}

std::unique_ptr<SkyPattern> makeSky(const SkyMap& map, const Vec3& north)
{
  if (map.width < 1 || map.height < 1 ||
      map.luminance.size() != static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height))
    throw std::invalid_argument("sky: the map's size does not match its values");
  return std::make_unique<MappedSky>(map, north);
}
}  // namespace kalos
