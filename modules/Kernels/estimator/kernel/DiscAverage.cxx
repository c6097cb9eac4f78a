// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/DiscAverage.h"

#include <array>
#include "estimator/control/Receivers.h"

#include "geometry/Polygon.h"

namespace kalos
{
double discFormFactor(const Vec3& y, const Vec3& n, const Vec3& c, const Vec3& m, double radius)
{
  const Vec3 toDisc = c - y;
  const double h = -dot(toDisc, m);  // height of y above the disc
  if (!(h > 0))
    return 0;
  const Vec3 axial = -m, across = toDisc - h * axial;
  const double r = length(across);
  const Vec3 radial = r > 0 ? (1 / r) * across : Vec3{};

  // Lowest point of the disc above the horizon of y.
  const double along = dot(n, axial), tilt = std::sqrt(std::max(0.0, 1 - along * along));
  const double centre = dot(n, toDisc);
  if (centre + radius * tilt <= 0)
    return 0;
  if (centre - radius * tilt >= 0)
  {
    // In full view: vector irradiance of a disc of unit exitance, axial and radial part.
    const double h2 = h * h, r2 = r * r, a2 = radius * radius;
    const double root = std::sqrt((h2 + r2 + a2) * (h2 + r2 + a2) - 4 * r2 * a2);
    const double f = 0.5 * (1 - (h2 + r2 - a2) / root);
    const double g = r > 1e-9 * radius ? h / (2 * r) * ((h2 + r2 + a2) / root - 1) : 0;
    return std::max(0.0, dot(n, axial) * f + dot(n, radial) * g);
  }
  constexpr int sides = 64;
  static const double equalArea = std::sqrt(2 * pi / sides / std::sin(2 * pi / sides));
  const Frame frame(m);
  std::array<Vec3, sides> corners;
  for (int i = 0; i < sides; ++i)
  {
    const double phi = 2 * pi * i / sides;
    corners[i] = c + equalArea * radius * (std::cos(phi) * frame.s + std::sin(phi) * frame.t);
  }
  return polygonFormFactor(y, n, corners.data(), sides);
}

DiscAverage::DiscAverage(const Scene& scene, const Receivers& receivers, double epsilon) : Epsilon(epsilon)
{
  for (std::size_t i = 0; i < receivers.points.size(); ++i)
  {
    std::vector<Vec3> cell = i < receivers.cells.size() ? receivers.cells[i] : std::vector<Vec3>();
    double radius = epsilon, area = pi * epsilon * epsilon;
    if (cell.size() >= 3)
    {
      radius = area = 0;
      for (Vec3& corner : cell)
      {
        radius = std::max(radius, length(corner - receivers.points[i]));
        corner = corner - scene.origin();
      }
      for (std::size_t k = 2; k < cell.size(); ++k)
        area += 0.5 * length(cross(cell[k - 1] - cell[0], cell[k] - cell[0]));
    }
    else
      cell.clear();
    this->Cells.push_back(std::move(cell));
    this->Radius.push_back(radius);
    this->Area.push_back(area);
  }
}

double DiscAverage::kernel(std::size_t receiver, const Sensor& sensor, const Vec3& y, const Vec3& n, double,
                           RandomStream&) const
{
  if (!(dot(y - sensor.position, sensor.normal) > 0))
    return 0;
  const std::vector<Vec3>& cell = this->Cells[receiver];
  const double factor = cell.empty() ? discFormFactor(y, n, sensor.position, sensor.normal, this->Radius[receiver])
                                     : polygonFormFactor(y, n, cell.data(), static_cast<int>(cell.size()));
  return factor / this->Area[receiver];
}

std::string DiscAverage::describe() const
{
  return "average over the receiver's own polygon, else over a disc of " + std::to_string(this->Epsilon) + " m";
}
}  // namespace kalos
