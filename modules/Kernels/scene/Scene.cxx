// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Scene.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace kalos
{
namespace
{
void require(bool condition, const std::string& message)
{
  if (!condition)
    throw std::invalid_argument(message);
}

void checkMaterial(const Material& m, int bands, const std::string& where)
{
  require(m.specular >= 0 && m.mirror >= 0, where + "specular and mirror must be 0 or more");
  require(m.specular == 0 || (m.roughness > 0 && m.roughness <= 1), where + "roughness must lie in (0, 1]");
  for (int b = 0; b < bands; ++b)
  {
    require(m.reflectance[b] >= 0 && m.reflectance[b] + m.specular + m.mirror < 1,
            where + "reflectance, specular and mirror must sum to less than 1");
    require(m.exitance[b] >= 0 && std::isfinite(m.exitance[b]), where + "exitance must be 0 or more");
  }
}

void check(const SceneDescription& d)
{
  require(d.bands >= 1 && d.bands <= maxBands, "bands: must be 1 to " + std::to_string(maxBands));
  require(d.triangleMaterial.size() == d.triangles.size(), "triangleMaterial: one entry per triangle is expected");
  require(d.surfaceNames.empty() || d.triangleSurface.size() == d.triangles.size(),
          "triangleSurface: one entry per triangle is expected");
  for (const std::uint32_t surface : d.triangleSurface)
    require(surface < d.surfaceNames.size(), "triangleSurface: names a surface that does not exist");
  for (std::size_t i = 0; i < d.points.size(); ++i)
    require(isFinite(d.points[i]), "point " + std::to_string(i) + ": coordinates must be finite");
  for (std::size_t i = 0; i < d.triangles.size(); ++i)
  {
    for (auto corner : d.triangles[i])
      require(corner < d.points.size(), "triangle " + std::to_string(i) + ": names a point that does not exist");
    require(d.triangleMaterial[i] < d.materials.size(), "triangle " + std::to_string(i) + ": has no material");
  }
  for (std::size_t i = 0; i < d.luminaires.size(); ++i)
    require(d.luminaires[i].distribution != Distribution::Measured ||
                (d.luminaires[i].table && d.luminaires[i].table->flux() > 0),
            "luminaire " + std::to_string(i) + ": a measured distribution needs a table with some flux");
  for (std::size_t i = 0; i < d.materials.size(); ++i)
    checkMaterial(d.materials[i], d.bands, "material " + std::to_string(i) + ": ");
}
}  // namespace

Vec3 Scene::recentre(SceneDescription& d, double& size)
{
  check(d);
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  auto include = [&](const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  };
  for (const Vec3& p : d.points)
    include(p);
  if (d.points.empty())
    for (const Luminaire& l : d.luminaires)
      include(l.position);
  if (d.points.empty() && d.luminaires.empty())
    include({});
  const Vec3 centre = 0.5 * (low + high);
  size = maxAbs(high - low);
  for (Vec3& p : d.points)
    p = p - centre;
  for (Luminaire& l : d.luminaires)
    l.position = l.position - centre;
  return centre;
}

Scene::Scene(SceneDescription description)
    : Data(std::move(description)),
      Origin(recentre(this->Data, this->Size)),
      Rays(this->Data.points, this->Data.triangles)
{
  for (Material material : this->Data.materials)
  {
    this->Brdfs.emplace_back(material, this->Data.bands);
    material.reflectance = {};
    this->Lobes.emplace_back(material, this->Data.bands);
  }
  const auto count = static_cast<std::uint32_t>(this->Data.triangles.size());
  this->Normals.resize(count);
  this->Areas.resize(count);
  this->Lifts.reserve(count);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const Vec3 a = this->corner(t, 0);
    const Vec3 twiceArea = cross(this->corner(t, 1) - a, this->corner(t, 2) - a);
    this->Areas[t] = 0.5 * length(twiceArea);
    require(this->Areas[t] > 0, "triangle " + std::to_string(t) + ": has no area");
    this->Normals[t] = normalized(twiceArea);
    this->SurfaceArea += this->Areas[t];
    this->Lifts.push_back(this->liftAt(t));
  }
  for (const Luminaire& l : this->Data.luminaires)
    this->LuminaireAnchors.push_back(
        l.isOneSided()
            ? this->anchorWithin(l.position, l.axis, 0.5 * length(l.sideU + l.sideV) + this->contact(l.position))
            : RayAnchor(l.position));
  this->Coplanar = findCoplanarFaces(*this);
  this->Glossy = std::make_shared<const GlossyPlanes>(*this);
}

Scene::Lift Scene::liftAt(std::uint32_t t) const
{
  const Vec3 &n = this->Normals[t], a = this->corner(t, 0), b = this->corner(t, 1), c = this->corner(t, 2);
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  const double slender = longest / (2 * this->Areas[t]);  // the longest side over the height on it
  const bool isAcrossAxis = maxAbs(n) > 1 - 1e-12;        // its corners share a coordinate, which is rounded alike
  const double slope = roundingScale * (isAcrossAxis ? 1.0 : std::max(1.0, 0.25 * slender));
  return {static_cast<float>(slope * absDot(n, largestAbs(largestAbs(a, b), c))), static_cast<float>(slope)};
}

RayAnchor Scene::anchorWithin(const Vec3& p, const Vec3& n, double radius) const
{
  RayAnchor anchor(p, n, this->contact(p), roundingScale);
  this->Rays.nearby(p, radius, [&](std::uint32_t t) {
    const double height = std::abs(dot(p - this->corner(t, 0), this->Normals[t]));
    if (std::abs(dot(this->Normals[t], n)) < 0.999)
      return true;
    const RayAnchor own = this->anchor(t, p, n);
    if (height > std::max(own.base, this->contact(p)))
      return true;
    anchor.base = std::max(anchor.base, own.base);
    anchor.slope = std::max(anchor.slope, own.slope);
    return true;
  });
  return anchor;
}

SurfacePoint Scene::trace(const RayAnchor& start, const Vec3& direction) const
{
  return this->point(this->Rays.intersect(start, direction), direction);
}

SurfacePoint Scene::point(const Hit& hit, const Vec3& direction) const
{
  SurfacePoint point;
  if (!hit.valid)
    return point;
  point.valid = true;
  point.triangle = hit.triangle;
  // The point from the barycentric weights lies in the triangle's plane to double precision, as the kernels need.
  const Vec3 a = this->corner(hit.triangle, 0);
  point.position = a + hit.u * (this->corner(hit.triangle, 1) - a) + hit.v * (this->corner(hit.triangle, 2) - a);
  if (this->isOverlapped(hit.triangle))
  {
    point.triangle = this->uppermost(hit.triangle, point.position, direction);
    const Vec3& plane = this->Normals[point.triangle];
    point.position += dot(this->corner(point.triangle, 0) - point.position, plane) * plane;
  }
  const Vec3& n = this->Normals[point.triangle];
  point.front = dot(n, direction) < 0;
  point.normal = point.front ? n : -n;
  return point;
}

std::uint32_t Scene::uppermost(std::uint32_t t, const Vec3& p, const Vec3& direction) const
{
  if (!this->isOverlapped(t))
    return t;
  std::uint32_t top = t;
  const double here = this->reach(t, p);
  this->Rays.nearby(p, 2 * std::max(here, this->contact(p)), [&](std::uint32_t o) {
    const double height = std::abs(dot(p - this->corner(o, 0), this->Normals[o]));
    if (this->isOverlapped(o) && std::abs(dot(this->Normals[o], this->Normals[t])) > 0.998 &&
        height <= std::max(here, this->reach(o, p)) && this->isOver(o, p, 0) && liesOver(*this, o, top, direction))
      top = o;
    return true;
  });
  return top;
}

std::vector<std::array<Vec3, 3>> Scene::luminousParts(std::uint32_t triangle) const
{
  const auto found = this->Coplanar.luminousParts.find(triangle);
  if (found != this->Coplanar.luminousParts.end())
    return found->second;
  return {{this->corner(triangle, 0), this->corner(triangle, 1), this->corner(triangle, 2)}};
}

namespace
{
// Whether p, within `reach` of the triangle's plane, lies over the triangle or within `reach` of its border.
bool over(const Vec3& p, const Vec3 corners[3], const Vec3& normal, double reach)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 edge = corners[(i + 1) % 3] - corners[i];
    if (dot(cross(edge, p - corners[i]), normal) < -reach * length(edge))
      return false;
  }
  return true;
}

double squaredDistanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  const Vec3 d = p - a - share * along;
  return dot(d, d);
}

double squaredDistance(const Vec3& p, const Vec3 corners[3], const Vec3& normal)
{
  if (over(p, corners, normal, 0))
  {
    const double height = dot(p - corners[0], normal);
    return height * height;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    nearest = std::min(nearest, squaredDistanceToSegment(p, corners[i], corners[(i + 1) % 3]));
  return nearest;
}

// The largest pi G that a sensor of normal n has with points of a wall at right angles which is at unit distance.
constexpr double rightAngle = 3 * 1.7320508075688772 / 16;

// An upper bound of pi G = cos(theta) cos(theta') / d^2 between a sensor of normal n and the points of a triangle that
// is `distance` away and `height` under or over whose plane it lies; `cosine` is between n and the way to that plane.
double largestKernel(double cosine, double height, double distance)
{
  if (!(distance > 0))
    return std::numeric_limits<double>::infinity();
  // In the whole plane, x heights from the foot of the perpendicular: (cosine + x sine) / (1 + x^2)^2 / height^2.
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const double root = std::sqrt(4 * cosine * cosine + 3 * sine * sine);
  const double x = cosine < 0 ? (root - 2 * cosine) / (3 * sine) : sine / (root + 2 * cosine);
  const double inPlane = sine > 0 || cosine > 0 ? (cosine + x * sine) / std::pow(1 + x * x, 2) : 0;
  // In this part of it cos(theta') <= height / distance.
  return std::min(inPlane / (height * height), height / std::pow(distance, 3));
}
}  // namespace

bool Scene::isOver(std::uint32_t t, const Vec3& p, double reach) const
{
  const Vec3 corners[3] = {this->corner(t, 0), this->corner(t, 1), this->corner(t, 2)};
  return over(p, corners, this->Normals[t], reach);
}

bool Scene::clear(const Vec3& p, const Vec3& n, double radius) const
{
  constexpr int enough =
      2000;  // triangles to test; more would cost more than gather rays, for example with a fine mesh behind the sensor
  const double touch = 4 * this->contact(p);  // lower triangles belong to the sensor's own surface
  const double limit = rightAngle / (radius * radius);
  bool clear = true;
  int seen = 0;
  this->Rays.nearby(p, radius, [&](std::uint32_t t) {
    const Vec3 corners[3] = {this->corner(t, 0), this->corner(t, 1), this->corner(t, 2)};
    if (++seen > enough)
      clear = false;
    if (!clear || std::none_of(corners, corners + 3, [&](const Vec3& c) { return dot(c - p, n) > touch; }))
      return clear;
    const Vec3& side = this->Normals[t];
    const double squared = squaredDistance(p, corners, side), over = dot(p - corners[0], side);
    const double cosine = over > 0 ? -dot(side, n) : dot(side, n);
    if (squared < radius * radius && largestKernel(cosine, std::abs(over), std::sqrt(squared)) > limit)
      clear = false;
    return clear;
  });
  return clear;
}
}  // namespace kalos
