// SPDX-License-Identifier: BSD-3-Clause
#include "sky/Sky.h"

#include <stdexcept>
#include <string>

namespace kalos
{
const double Sky::sunRadius = 0.5 * 0.53 * pi / 180;
const double Sky::sunSolidAngle = 4 * pi * std::pow(std::sin(Sky::sunRadius / 2), 2);

namespace
{
constexpr int nodes = 64;  // of Gauss and Legendre, in each panel

void require(bool condition, const std::string& message)
{
  if (!condition)
    throw std::invalid_argument("sky: " + message);
}

struct GaussLegendre
{
  double x[nodes], weight[nodes];  // on [0, 1]

  GaussLegendre()
  {
    for (int i = 0; i < nodes; ++i)
    {
      double root = std::cos(pi * (i + 0.75) / (nodes + 0.5)), slope = 1;
      for (int step = 0; step < 8; ++step)
      {
        double p = 1, before = 0;
        for (int k = 1; k <= nodes; ++k)
        {
          const double next = ((2 * k - 1) * root * p - (k - 1) * before) / k;
          before = p;
          p = next;
        }
        slope = nodes * (root * p - before) / (root * root - 1);
        root -= p / slope;
      }
      this->x[i] = 0.5 * (1 - root);
      this->weight[i] = 1 / ((1 - root * root) * slope * slope);
    }
  }
};

// Integral of f over [low, high], whose points crowd at both ends: roots and cusps there do no harm.
template <class F>
double panel(double low, double high, const F& f)
{
  static const GaussLegendre rule;
  double sum = 0;
  for (int i = 0; i < nodes && high > low; ++i)
  {
    const double t = rule.x[i], moved = t * t * (3 - 2 * t);
    sum += rule.weight[i] * 6 * t * (1 - t) * (high - low) * f(low + (high - low) * moved);
  }
  return sum;
}
}  // namespace

Sky::Sky(const SkyDescription& description) : Given(description)
{
  require(this->Given.pattern != nullptr, "no distribution of luminance is given");
  require(std::isfinite(this->Given.horizontalIlluminance) && std::isfinite(this->Given.zenithLuminance),
          "the illuminance must be finite");
  require(this->Given.groundReflectance >= 0 && this->Given.groundReflectance <= 1,
          "the ground's reflectance must lie in [0, 1]");
  require(this->Given.sunIlluminance >= 0 && std::isfinite(this->Given.sunIlluminance),
          "the sun's illuminance must be 0 or more");
  require(isFinite(this->Given.sun) && std::abs(length(this->Given.sun) - 1) < 1e-9,
          "the direction to the sun must be a unit vector");
  const double relative = this->integrate({0, 0, 1});
  require(std::isfinite(relative) && relative >= 0, "the luminance must be finite");
  if (this->Given.horizontalIlluminance >= 0)
  {
    require(relative > 0 || this->Given.horizontalIlluminance == 0, "all of it is black, expected an illuminance of 0");
    this->Scale = relative > 0 ? this->Given.horizontalIlluminance / relative : 0;
  }
  else if (this->Given.zenithLuminance >= 0)
  {
    const double zenith = this->Given.pattern->relative({0, 0, 1});
    require(zenith > 0 || this->Given.zenithLuminance == 0, "the zenith is black, expected a luminance of 0");
    this->Scale = zenith > 0 ? this->Given.zenithLuminance / zenith : 0;
  }
  this->Horizontal = this->Scale * relative;
  this->Ground = this->Given.groundReflectance * this->Horizontal / pi;
  this->SunLuminance = this->Given.sunIlluminance / (pi * std::pow(std::sin(sunRadius), 2));
  this->Directions =
      std::make_shared<const DirectionTable>([this](const Vec3& direction) { return this->luminance(direction); });
}

bool Sky::inDisc(const Vec3& direction) const
{
  static const double widest = std::pow(std::sin(sunRadius), 2);
  const Vec3 across = cross(direction, this->Given.sun);
  return dot(direction, this->Given.sun) > 0 && dot(across, across) < widest;
}

Vec3 Sky::sampleSun(double u1, double u2) const
{
  const double depth = 2 * std::pow(std::sin(sunRadius / 2), 2) * u1;  // 1 - cos
  const double s = std::sqrt(depth * (2 - depth)), phi = 2 * pi * u2;
  return Frame(this->Given.sun).toWorld({s * std::cos(phi), s * std::sin(phi), 1 - depth});
}

double Sky::illuminance(const Vec3& n) const
{
  const double ground = pi * this->Ground * 0.5 * (1 - n.z);
  if (this->isUniform())
    return this->Horizontal * 0.5 * (1 + n.z) + ground;
  return this->Scale * this->integrate(n) + ground;
}

// Over the zenith angle and, in each ring, over the azimuths that are above the plane; about those of n and of the sun.
double Sky::integrate(const Vec3& n) const
{
  const Vec3& sun = this->Given.sun;
  const double sunAzimuth = std::atan2(sun.y, sun.x), sunZenith = std::acos(std::clamp(sun.z, -1.0, 1.0));
  const double azimuth = std::atan2(n.y, n.x), across = std::hypot(n.x, n.y);
  const double edge = std::abs(std::atan2(n.z, across));  // zenith angle where the plane begins to cut the ring
  const auto ring = [&](double theta) {
    const double z = std::cos(theta), s = std::sin(theta);
    // n.z z + across s cos(phi - azimuth) > 0
    const double level = across * s > 0 ? -n.z * z / (across * s) : (n.z > 0 ? -2.0 : 2.0);
    if (level >= 1)
      return 0.0;
    const double half = level <= -1 ? pi : std::acos(level);
    const auto value = [&](double phi) {
      const Vec3 d{s * std::cos(phi), s * std::sin(phi), z};
      return std::max(0.0, dot(d, n)) * this->Given.pattern->relative(d) * s;
    };
    double split = sunAzimuth - azimuth;
    split -= 2 * pi * std::round(split / (2 * pi));
    const double middle = azimuth + std::clamp(split, -half, half);
    return panel(azimuth - half, middle, value) + panel(middle, azimuth + half, value);
  };
  const double first = std::min(edge, std::min(sunZenith, pi / 2)),
               second = std::min(pi / 2, std::max(edge, sunZenith));
  return panel(0, first, ring) + panel(first, second, ring) + panel(second, pi / 2, ring);
}
}  // namespace kalos
