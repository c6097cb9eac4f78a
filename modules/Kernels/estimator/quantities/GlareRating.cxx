// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/quantities/GlareRating.h"

#include <cmath>
#include <limits>

#include "geometry/Polygon.h"

namespace kalos
{
namespace
{
constexpr double degree = pi / 180;
constexpr double smallArea = 0.005;  // m^2, below which a source counts as one of this size
constexpr double largeAngle = 0.1;   // sr
constexpr double widest = 3;         // T/R and H/R where the table of CIE 117 ends
constexpr double highest = 1.9;
constexpr int parts = 8;       // of each side of a luminous area
constexpr int fewestCuts = 2;  // a triangle is 16 pieces at least
constexpr int mostCuts = 14;
constexpr double largestPiece = 0.25;  // longest edge over distance

// One observer's view of the emitters, in the scene's coordinates.
class View
{
public:
  View(const Scene& scene, const Observer& observer)
      : Scene_(scene), Who(observer), Eye(observer.position - scene.origin())
  {
  }

  void add(std::size_t i)
  {
    const Luminaire& l = this->Scene_.data().luminaires[i];
    const Vec3 from = this->Eye - l.position;
    const double d2 = dot(from, from);
    const Vec3 out = normalized(from);  // from the luminaire to the eye
    const double index = positionIndex(this->Who, -out);
    const double candela = d2 > 0 ? intensity(l, out) : 0;
    if (!(candela > 0) || !std::isfinite(index))
      return;
    const double seen = this->visibleShare(i);
    const double area = length(cross(l.sideU, l.sideV)) * std::abs(dot(l.axis, out));
    const bool isSmall = area < smallArea;
    // L^2 omega = (I/A)^2 A/d^2
    this->count(seen * candela * candela / (std::max(area, smallArea) * d2) / (index * index), area / d2, isSmall);
  }

  void addTriangle(std::uint32_t t)
  {
    const Vec3 corners[3] = {this->Scene_.corner(t, 0), this->Scene_.corner(t, 1), this->Scene_.corner(t, 2)};
    const Vec3& n = this->Scene_.normal(t);
    if (!(dot(n, this->Eye - corners[0]) > 0))
      return;
    const double luminance = photometric(this->Scene_.material(t).exitance, this->Scene_.bands()) / pi;
    double weighted = 0, angle = 0;  // sum of omega / p^2 and of omega over the pieces that are seen
    this->cut(t, corners, 0, weighted, angle);
    this->count(luminance * luminance * weighted, angle, false);
  }

  const GlareSum& result() const { return this->Sum; }

private:
  void count(double contribution, double angle, bool isSmall)
  {
    if (!(contribution > 0))
      return;
    this->Sum.sum += contribution;
    ++this->Sum.sources;
    this->Sum.small += isSmall;
    this->Sum.large += angle > largeAngle;
  }

  double visibleShare(std::size_t luminaire) const
  {
    const Luminaire& l = this->Scene_.data().luminaires[luminaire];
    RayAnchor target = this->Scene_.luminaireAnchor(luminaire);
    if (l.isPoint())
      return this->visibility(target);
    double visible = 0;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j)
      {
        target.point = l.position + ((i + 0.5) / parts - 0.5) * l.sideU + ((j + 0.5) / parts - 0.5) * l.sideV;
        visible += this->visibility(target);
      }
    return visible / (parts * parts);
  }

  // Glass dims the luminance that the eye sees; it counts by its square.
  double visibility(const RayAnchor& target) const
  {
    const RayScene& rays = this->Scene_.rays();
    return rays.occluded(this->Eye, target) ? 0 : std::pow(rays.transmittance(this->Eye, target), 2);
  }

  void cut(std::uint32_t t, const Vec3 c[3], int depth, double& weighted, double& angle) const
  {
    const Vec3 middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
    const double distance = length(middle - this->Eye);
    const double longest = std::max({length(c[1] - c[0]), length(c[2] - c[1]), length(c[0] - c[2])});
    if (depth < fewestCuts || (depth < mostCuts && longest > largestPiece * distance))
    {
      const Vec3 m[3] = {0.5 * (c[1] + c[2]), 0.5 * (c[2] + c[0]), 0.5 * (c[0] + c[1])};
      const Vec3 pieces[4][3] = {{c[0], m[2], m[1]}, {m[2], c[1], m[0]}, {m[1], m[0], c[2]}, {m[0], m[1], m[2]}};
      for (const auto& piece : pieces)
        this->cut(t, piece, depth + 1, weighted, angle);
      return;
    }
    const double index = positionIndex(this->Who, normalized(middle - this->Eye));
    const RayAnchor target = this->Scene_.anchor(t, middle, this->Scene_.normal(t));
    const double visible = std::isfinite(index) ? this->visibility(target) : 0;
    if (!(visible > 0))
      return;
    const double omega = SphericalTriangle(this->Eye, c[0], c[1], c[2]).solidAngle();
    weighted += visible * omega / (index * index);
    angle += omega;
  }

  const Scene& Scene_;
  const Observer& Who;
  Vec3 Eye;
  GlareSum Sum;
};
}  // namespace

double positionIndex(const Observer& observer, const Vec3& to)
{
  const double ahead = dot(to, observer.sight);
  if (!(ahead > 0))
    return std::numeric_limits<double>::infinity();
  const Vec3 side = normalized(cross(observer.sight, observer.up)), up = cross(side, observer.sight);
  const double height = dot(to, up), across = std::abs(dot(to, side));
  if (across > widest * ahead || height > highest * ahead)
    return std::numeric_limits<double>::infinity();
  const double tangent = std::hypot(height, across) / ahead;
  if (height < 0)
  {
    const double r = std::min(tangent, 3.0);
    return 1 + (r < 0.6 ? 0.8 : 1.2) * r;
  }
  const double s = std::atan(tangent) / degree, t = std::atan2(across, height) / degree;
  return std::exp((35.2 - 0.31889 * t - 1.22 * std::exp(-2 * t / 9)) * 1e-3 * s +
                  (21 + 0.26667 * t - 0.002963 * t * t) * 1e-5 * s * s);
}

GlareSum glareSum(const Scene& scene, const Observer& observer)
{
  View view(scene, observer);
  for (std::size_t i = 0; i < scene.data().luminaires.size(); ++i)
    view.add(i);
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
      view.addTriangle(t);
  return view.result();
}

double unifiedGlareRating(double sum, double indirectIlluminance)
{
  if (!(indirectIlluminance > 0))
    return std::numeric_limits<double>::quiet_NaN();
  return 8 * std::log10(0.25 * pi / indirectIlluminance * sum);
}
}  // namespace kalos
