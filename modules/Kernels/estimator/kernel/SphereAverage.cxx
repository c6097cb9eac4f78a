// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/SphereAverage.h"

namespace kalos
{
namespace
{
double cube(double x)
{
  return x * x * x;
}

// cos(theta_max) of the cone that encloses the ball, for d > epsilon (15).
double coneCosine(double d, double epsilon)
{
  return std::sqrt(1 - epsilon * epsilon / (d * d));
}
}  // namespace

double sphereWeight(double d, double epsilon, SphereChoices choices)
{
  const bool outside = d > epsilon;
  if (!choices.exactWeight)
    return outside ? 3 / (3 * d * d + epsilon * epsilon) : 3 / ((d + epsilon) * (d + epsilon));
  const double ball = 4 * pi / 3 * cube(epsilon);
  if (!choices.redraw)
    return (outside ? 4 * pi * epsilon * (1 - coneCosine(d, epsilon)) : 4 * pi * (d + epsilon)) / ball;
  // C_ball, with its limits at d = 0 and d = epsilon.
  double c = 4 * pi * epsilon;
  if (d > 1e-6 * epsilon)
  {
    const double gap = std::abs(epsilon - d);
    c = 2 * pi * epsilon;
    if (gap > 0)
      c += pi * (epsilon * epsilon - d * d) / d * std::log((epsilon + d) / gap);
  }
  return c / ball;
}

double SphereAverage::kernel(std::size_t, const Sensor& sensor, const Vec3& y, const Vec3& n, double,
                             RandomStream& random) const
{
  const Vec3 toReceiver = sensor.position - y;
  const double d = length(toReceiver), epsilon = this->Epsilon;
  const bool outside = d > epsilon;
  const Frame frame(d > 0 ? (1 / d) * toReceiver : sensor.normal);
  const double coneHeight = outside ? 1 - coneCosine(d, epsilon) : 2;
  for (;;)
  {
    // Draw a point of the enclosing region (16), (19).
    const double phi = 2 * pi * random.next(), cosine = 1 - random.next() * coneHeight, u3 = random.next();
    const double rho = outside ? d + epsilon * (1 - 2 * u3) : u3 * (d + epsilon);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const Vec3 direction = frame.toWorld({sine * std::cos(phi), sine * std::sin(phi), cosine});
    if (length(rho * direction - toReceiver) < epsilon)
    {
      const double atVertex = dot(direction, n), atReceiver = -dot(direction, sensor.normal);
      if (!(atVertex > 0 && atReceiver > 0))
        return 0;
      return sphereWeight(d, epsilon, this->Choices) * atVertex * atReceiver / pi;
    }
    if (!this->Choices.redraw)
      return 0;
  }
}

std::string SphereAverage::describe() const
{
  return "one-sample average over a ball of " + std::to_string(this->Epsilon) + " m for vertices nearer than " +
         std::to_string(this->Delta) + " m, " + (this->Choices.exactWeight ? "exact" : "published") + " weight";
}
}  // namespace kalos
