// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/RadiosityMesh.h"

#include <algorithm>
#include <cmath>

#include "estimator/tracing/Trajectories.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr int starts = 4096, raysOfSide = 64;
constexpr std::size_t noElement = ~std::size_t{0};
constexpr int bisections = 60;
}  // namespace

LitSides::LitSides(const Scene& scene, const Emission& emission, std::uint64_t seed)
    : Lit(2 * scene.data().triangles.size(), 0)
{
  std::vector<std::size_t> found;
  auto note = [&](std::uint32_t triangle, bool front) {
    const std::size_t side = 2 * triangle + front;
    if (this->Lit[side])
      return;
    this->Lit[side] = 1;
    found.push_back(side);
  };
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
      note(t, true);
  for (int i = 0; emission.totalFlux() > 0 && i < starts; ++i)
  {
    SampleStream random(Sampling::Sobol, seed, pilotReplicate, Purpose::Trajectory, static_cast<std::uint64_t>(i));
    const EmissionSample start = emission.sample(random);
    const SurfacePoint y = scene.trace(start.anchor, start.direction);
    if (y.valid)
      note(y.triangle, y.front);
  }
  for (std::size_t next = 0; next < found.size(); ++next)
  {
    const auto triangle = static_cast<std::uint32_t>(found[next] / 2);
    const Vec3 n = found[next] % 2 ? scene.normal(triangle) : -scene.normal(triangle);
    const Frame frame(n);
    const Vec3 a = scene.corner(triangle, 0), b = scene.corner(triangle, 1), c = scene.corner(triangle, 2);
    for (std::uint64_t k = 0; k < raysOfSide; ++k)
    {
      SampleStream random(Sampling::Sobol, seed + found[next], pilotReplicate, Purpose::Gather, k);
      const double u1 = random.next(), u2 = random.next(), v1 = random.next(), v2 = random.next();
      double s, t;
      uniformTriangle(v1, v2, s, t);
      const SurfacePoint y = scene.trace(scene.anchor(triangle, a + s * (b - a) + t * (c - a), n),
                                         frame.toWorld(cosineHemisphere(u1, u2)));
      if (y.valid)
        note(y.triangle, y.front);
    }
  }
  this->Sides = found.size();
}

std::uint32_t RadiosityMesh::cuts(const Scene& scene, std::uint32_t triangle, double length_)
{
  double longest = 0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, length(scene.corner(triangle, (k + 1) % 3) - scene.corner(triangle, k)));
  return static_cast<std::uint32_t>(std::clamp(std::ceil(longest / length_ * (1 - 1e-9)), 1.0, 4096.0));
}

std::size_t RadiosityMesh::count(const Scene& scene, const LitSides& sides, double length)
{
  std::size_t sum = 0;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    const std::size_t m = cuts(scene, t, length);
    sum += m * m * (static_cast<std::size_t>(sides.lit(t, false)) + static_cast<std::size_t>(sides.lit(t, true)));
  }
  return sum;
}

double RadiosityMesh::lengthFor(const Scene& scene, const LitSides& sides, std::size_t wanted)
{
  double low = 1e-3 * scene.size(), high = 2 * scene.size();  // too many elements, few enough
  for (int i = 0; i < bisections; ++i)
  {
    const double middle = std::sqrt(low * high);
    (RadiosityMesh::count(scene, sides, middle) > wanted ? low : high) = middle;
  }
  return high;
}

RadiosityMesh::RadiosityMesh(const Scene& scene, const LitSides& sides, double length)
    : Scene_(scene), First(2 * scene.data().triangles.size(), noElement), Cuts(scene.data().triangles.size())
{
  for (std::uint32_t t = 0; t < this->Cuts.size(); ++t)
  {
    const std::uint32_t m = this->Cuts[t] = cuts(scene, t, length);
    const Vec3 a = scene.corner(t, 0), s = 1.0 / m * (scene.corner(t, 1) - a), r = 1.0 / m * (scene.corner(t, 2) - a);
    for (const bool front : {false, true})
    {
      if (!sides.lit(t, front))
        continue;
      this->First[2 * t + front] = this->Elements.size();
      const Vec3 n = front ? scene.normal(t) : -scene.normal(t);
      auto add = [&](const Vec3& p, const Vec3& q, const Vec3& o) {
        this->Elements.push_back({{p, q, o}, n, t, front});
      };
      for (std::uint32_t i = 0; i < m; ++i)
        for (std::uint32_t j = 0; i + j < m; ++j)
        {
          const Vec3 p = a + i * s + j * r;
          add(p, p + s, p + r);
          if (i + j + 1 < m)
            add(p + s + r, p + r, p + s);
        }
    }
  }
}

bool RadiosityMesh::locate(const SurfacePoint& point, Place& place) const
{
  const std::uint32_t t = point.triangle, m = this->Cuts[t];
  const std::size_t first = this->First[2 * t + point.front];
  if (first == noElement)
    return false;
  // Barycentric coordinates of the point in the triangle, in elements.
  const Vec3 a = this->Scene_.corner(t, 0), s = this->Scene_.corner(t, 1) - a, r = this->Scene_.corner(t, 2) - a;
  const Vec3 d = point.position - a, n = cross(s, r);
  const double area = dot(n, n);
  const double x = std::clamp(dot(cross(d, r), n) / area, 0.0, 1.0) * m;
  const double y = std::clamp(dot(cross(s, d), n) / area, 0.0, 1.0) * m;
  const auto i = std::min(m - 1, static_cast<std::uint32_t>(x));
  const auto j = std::min(m - 1 - i, static_cast<std::uint32_t>(y));
  const double u = x - i, v = std::min(1.0, y - j);
  const bool upper = u + v > 1 && i + j + 1 < m;
  place.element = first + 2 * std::size_t{m} * i - std::size_t{i} * i + 2 * j + upper;
  place.weight[0] = upper ? u + v - 1 : std::max(0.0, 1 - u - v);
  place.weight[1] = upper ? 1 - u : u;
  place.weight[2] = upper ? 1 - v : v;
  return true;
}
}  // namespace kalos
