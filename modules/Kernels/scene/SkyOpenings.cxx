// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SkyOpenings.h"

#include <limits>

#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr std::size_t enough = 4096, mostPaths = 1u << 16, mostRays = 1u << 17;
constexpr int mostSegments = 12;
constexpr std::size_t fewestRays = 16;  // to look for openings at all
constexpr std::size_t compared = 400;   // rays, when faces are placed
constexpr int mostPlaces = 24;          // of a face that are tried
constexpr double outside = 1e-4;        // of the scene's size, how far a face lies outside of a surface
constexpr double enoughCovered = 0.97;  // of the rays
constexpr int openingsReplicate = 1 << 21;
}  // namespace

SkyOpenings::SkyOpenings(const Scene& scene, const std::vector<RayAnchor>& receivers, const Walks& walks)
{
  if (!scene.data().sky || receivers.empty() || scene.data().triangles.empty())
    return;
  this->orient(scene);
  const std::vector<Ray> rays = this->escapes(scene, receivers, walks);
  this->Escaped = rays.size();
  if (rays.size() < fewestRays || this->isOutdoors())
    return;
  this->place(scene, receivers, rays);
  this->keep(rays);
}

// The main axis is vertical where a tenth of the surfaces is level, and the others are those of the largest upright
// one.
void SkyOpenings::orient(const Scene& scene)
{
  double level = 0;
  std::size_t largest = 0;
  const auto count = static_cast<std::uint32_t>(scene.data().triangles.size());
  for (std::uint32_t t = 0; t < count; ++t)
  {
    if (std::abs(scene.normal(t).z) > 0.9999)
      level += scene.area(t);
    if (scene.area(t) > scene.area(static_cast<std::uint32_t>(largest)))
      largest = t;
  }
  if (level < 0.1 * scene.surfaceArea())
    this->Axes[2] = scene.normal(static_cast<std::uint32_t>(largest));
  const Frame across(this->Axes[2]);
  constexpr int bins = 90;
  std::array<double, bins> area{};
  std::array<std::uint32_t, bins> foremost{};
  std::array<bool, bins> used{};
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const Vec3 n = across.toLocal(scene.normal(t));
    if (std::abs(n.z) > 1e-3)
      continue;
    const double turn = std::fmod(std::atan2(n.y, n.x) + 2 * pi + pi / bins / 4, pi / 2) / (pi / 2);
    const auto bin = static_cast<std::size_t>(std::min(bins - 1, static_cast<int>(turn * bins)));
    if (!used[bin] || scene.area(t) > scene.area(foremost[bin]))
      foremost[bin] = t;
    used[bin] = true;
    area[bin] += scene.area(t);
  }
  const auto best = static_cast<std::size_t>(std::max_element(area.begin(), area.end()) - area.begin());
  const Vec3 side = used[best] ? scene.normal(foremost[best]) : across.s;
  this->Axes[0] = normalized(side - dot(side, this->Axes[2]) * this->Axes[2]);
  this->Axes[1] = cross(this->Axes[2], this->Axes[0]);
}

std::vector<SkyOpenings::Ray> SkyOpenings::escapes(const Scene& scene, const std::vector<RayAnchor>& receivers,
                                                   const Walks& walks)
{
  std::vector<Ray> rays;
  std::size_t traced = 0;
  for (std::size_t k = 0; k < mostPaths && traced < mostRays && rays.size() < enough; ++k)
  {
    SampleStream random = walks.stream(openingsReplicate, Purpose::Sky, static_cast<long long>(k));
    // Receivers in an order that spreads them from the first on.
    RayAnchor from = receivers[(k * 2654435761u) % receivers.size()];
    ++this->Followed;
    for (int segment = 0; segment < mostSegments && length(from.normal) > 0; ++segment)
    {
      const double u1 = random.next(), u2 = random.next();
      const Vec3 direction = Frame(from.normal).toWorld(cosineHemisphere(u1, u2));
      const SurfacePoint y = scene.trace(from, direction);
      ++traced;
      if (!y.valid)
      {
        rays.push_back({from.point, direction});
        this->AtOnce += segment == 0;
        break;
      }
      const Material& m = scene.material(y.triangle);
      if (!(photometric(m.reflectance, scene.bands()) + m.specular + m.mirror > 0))
        break;
      from = scene.anchor(y);
    }
  }
  return rays;
}

bool SkyOpenings::exitOf(const Box& box, const Vec3& p, const Vec3& d, Face& found) const
{
  const double point[3] = {p.x, p.y, p.z}, way[3] = {d.x, d.y, d.z};
  double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    if (way[k] == 0)
    {
      if (point[k] < box[k][0] || point[k] > box[k][1])
        return false;
      continue;
    }
    const int front = way[k] > 0;
    const double out = (box[k][front] - point[k]) / way[k], in = (box[k][1 - front] - point[k]) / way[k];
    enter = std::max(enter, in);
    if (out < leave)
    {
      leave = out;
      found.face = 2 * k + front;
    }
  }
  if (!(leave > enter) || !std::isfinite(leave))
    return false;
  const int k = found.face / 2, a = (k + 1) % 3, b = (k + 2) % 3;
  found.u = point[a] + leave * way[a];
  found.v = point[b] + leave * way[b];
  return true;
}

// Area that the rays pass through, over the square of the share of them that starts inside.
double SkyOpenings::cost(const Box& box, const std::vector<Ray>& rays, std::size_t step) const
{
  std::vector<std::array<double, 2>> points[6];
  std::size_t all = 0, inside = 0;
  for (std::size_t i = 0; i < rays.size(); i += step)
  {
    ++all;
    const Vec3 p = this->local(rays[i].from);
    const double c[3] = {p.x, p.y, p.z};
    bool within = true;
    for (int k = 0; k < 3; ++k)
      within = within && c[k] >= box[k][0] && c[k] <= box[k][1];
    Face face{};
    if (!within || !this->exitOf(box, p, this->local(rays[i].direction), face))
      continue;
    ++inside;
    points[face.face].push_back({face.u, face.v});
  }
  double area = 0;
  for (auto& face : points)
    for (const CoverRectangle& r : coverPoints(std::move(face)))
      area += r.area();
  const double share = static_cast<double>(inside) / static_cast<double>(all);
  return share > 0 ? area / (share * share) : std::numeric_limits<double>::infinity();
}

void SkyOpenings::place(const Scene& scene, const std::vector<RayAnchor>& receivers, const std::vector<Ray>& rays)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double gap = outside * scene.size();
  Box inner{{{infinite, -infinite}, {infinite, -infinite}, {infinite, -infinite}}};
  std::vector<double> places[3];
  const auto include = [this](Box& box, const Vec3& point) {
    const Vec3 p = this->local(point);
    const std::array<double, 3> c{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = {std::min(box[k][0], c[k]), std::max(box[k][1], c[k])};
    return c;
  };
  for (const RayAnchor& r : receivers)
    include(inner, r.point);
  this->Bounds = inner;
  for (const Triangle& t : scene.data().triangles)
    for (const std::uint32_t corner : t)
    {
      const std::array<double, 3> c = include(this->Bounds, scene.data().points[corner]);
      for (std::size_t k = 0; k < 3; ++k)
        places[k].push_back(c[k]);
    }
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::sort(places[k].begin(), places[k].end());
    places[k].erase(std::unique(places[k].begin(), places[k].end(), [gap](double a, double b) { return b - a < gap; }),
                    places[k].end());
    this->Bounds[k] = {this->Bounds[k][0] - gap, this->Bounds[k][1] + gap};
  }
  for (int face = 0; face < 6; ++face)
    this->placeFace(face, inner, places[face / 2], gap, rays);
}

void SkyOpenings::placeFace(int face, const Box& inner, const std::vector<double>& places, double gap,
                            const std::vector<Ray>& rays)
{
  const std::size_t step = std::max<std::size_t>(1, rays.size() / compared);
  const int k = face / 2, high = face % 2;
  std::vector<double> tried;
  for (const double c : places)
    if (high ? c >= inner[k][1] - gap : c <= inner[k][0] + gap)
      tried.push_back(c);
  double least = this->cost(this->Bounds, rays, step);
  const double stride = std::max(1.0, static_cast<double>(tried.size()) / mostPlaces);
  for (double i = 0; i < static_cast<double>(tried.size()); i += stride)
  {
    Box box = this->Bounds;
    const double c = tried[static_cast<std::size_t>(i)];
    box[k][high] = high ? std::max(c, inner[k][1]) + gap : std::min(c, inner[k][0]) - gap;
    const double found = this->cost(box, rays, step);
    if (found < 0.98 * least)
    {
      least = found;
      this->Bounds = box;
    }
  }
}

void SkyOpenings::keep(const std::vector<Ray>& rays)
{
  std::vector<std::array<double, 2>> points[6];
  std::size_t inside = 0;
  for (const Ray& ray : rays)
  {
    Face face{};
    if (this->encloses(ray.from) && this->exitOf(this->Bounds, this->local(ray.from), this->local(ray.direction), face))
    {
      points[face.face].push_back({face.u, face.v});
      ++inside;
    }
  }
  std::vector<std::pair<int, CoverRectangle>> found;
  for (int face = 0; face < 6; ++face)
    for (const CoverRectangle& r : coverPoints(std::move(points[face])))
      found.emplace_back(face, r);
  // The densest first; where few rays pass, sampling costs more than it finds.
  const auto density = [](const auto& one) { return static_cast<double>(one.second.points) / one.second.area(); };
  std::sort(found.begin(), found.end(),
            [&](const auto& one, const auto& other) { return density(one) > density(other); });
  double covered = 0;
  for (const auto& [face, r] : found)
  {
    const double share = static_cast<double>(r.points) / static_cast<double>(inside);
    if (covered <= enoughCovered)
      this->add(face, r, share);
    covered += share;
  }
}

void SkyOpenings::add(int face, const CoverRectangle& r, double share)
{
  const int k = face / 2, a = (k + 1) % 3, b = (k + 2) % 3;
  const double lowU = std::max(r.low[0], this->Bounds[a][0]), highU = std::min(r.high[0], this->Bounds[a][1]);
  const double lowV = std::max(r.low[1], this->Bounds[b][0]), highV = std::min(r.high[1], this->Bounds[b][1]);
  if (!(highU > lowU && highV > lowV))
    return;
  Rectangle found;
  found.face = face;
  found.corner = this->Bounds[k][face % 2] * this->Axes[k] + lowU * this->Axes[a] + lowV * this->Axes[b];
  found.u = (highU - lowU) * this->Axes[a];
  found.v = (highV - lowV) * this->Axes[b];
  found.outward = face % 2 ? this->Axes[k] : -this->Axes[k];
  found.area = (highU - lowU) * (highV - lowV);
  found.rays = share;
  this->Rectangles.push_back(found);
  this->Extents.push_back({lowU, highU, lowV, highV});
}

bool SkyOpenings::encloses(const Vec3& p) const
{
  const Vec3 q = this->local(p);
  const double c[3] = {q.x, q.y, q.z};
  for (int k = 0; k < 3; ++k)
    if (c[k] < this->Bounds[k][0] || c[k] > this->Bounds[k][1])
      return false;
  return true;
}

int SkyOpenings::exit(const Vec3& p, const Vec3& direction, Vec3& point) const
{
  Face face{};
  if (!this->any() || !this->exitOf(this->Bounds, this->local(p), this->local(direction), face))
    return -1;
  const int k = face.face / 2, a = (k + 1) % 3, b = (k + 2) % 3;
  point = this->Bounds[k][face.face % 2] * this->Axes[k] + face.u * this->Axes[a] + face.v * this->Axes[b];
  return face.face;
}

bool SkyOpenings::covers(std::size_t i, int face, const Vec3& point) const
{
  if (this->Rectangles[i].face != face)
    return false;
  const int k = face / 2;
  const double u = dot(point, this->Axes[(k + 1) % 3]), v = dot(point, this->Axes[(k + 2) % 3]);
  const auto& e = this->Extents[i];
  return u >= e[0] && u <= e[1] && v >= e[2] && v <= e[3];
}
}  // namespace kalos
