// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/RadiositySystem.h"

#include <cmath>

#include "estimator/tracing/VertexRound.h"
#include "geometry/Polygon.h"
#include "sampling/Warp.h"
#include "scene/RayBatch.h"

namespace kalos
{
namespace
{
constexpr double tolerance = 1e-6;
constexpr int mostIterations = 1000;
constexpr double near = 0.02;                              // form factor above which y is drawn by solid angle
constexpr int areaSamples = 8;                             // of luminaires' areas, at each point
constexpr double corner[3] = {2.0 / 3, 1.0 / 6, 1.0 / 6};  // weights of Gauss's first point

// Value at a corner of the plane through the values at Gauss's points: of the corner's own point, of each other.
constexpr double own = 5.0 / 3, other = -1.0 / 3;
}  // namespace

RadiositySystem::RadiositySystem(const Scene& scene, const RadiosityMesh& mesh, const DirectLight& luminaires,
                                 bool linear, bool shadows)
    : Scene_(scene), Mesh(mesh), Luminaires(luminaires), Each(linear ? points : 1), Shadows(shadows)
{
  this->Matrix.resize(this->unknowns() * this->unknowns());
}

Vec3 RadiositySystem::point(std::size_t element, int k) const
{
  const RadiosityElement& e = this->Mesh.elements()[element];
  return corner[0] * e.corner[k] + corner[1] * e.corner[(k + 1) % 3] + corner[2] * e.corner[(k + 2) % 3];
}

bool RadiositySystem::solve(std::uint64_t seed, int replicate, Workers& workers)
{
  const std::size_t elements = this->Mesh.elements().size();
  this->Direct.assign(this->unknowns(), {});
  if (!workers.forEach(elements, [&](std::size_t i) {
        this->drawDirect(i, seed, replicate);
        this->drawRows(i, seed, replicate);
      }))
    return false;
  this->iterate();
  return true;
}

void RadiositySystem::drawDirect(std::size_t i, std::uint64_t seed, int replicate)
{
  const RadiosityElement& e = this->Mesh.elements()[i];
  SampleStream random(Sampling::Independent, mixBits(seed) + i, static_cast<std::uint64_t>(replicate),
                      Purpose::DirectLight, 0);
  for (int k = 0; k < points; ++k)
  {
    const Sensor sensor(this->Scene_.anchor(e.triangle, this->point(i, k), e.normal));
    DirectLight::View view;
    this->Luminaires.prepareView(sensor, view);
    Bands& sum = this->Direct[i * this->Each + (this->Each == 1 ? 0 : static_cast<std::size_t>(k))];
    const double share = this->Each == 1 ? 1.0 / points : 1;
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += share * (view.points[b] + view.areas[b]);
    for (int s = 0; s < areaSamples && this->Luminaires.fluctuates(); ++s)
    {
      Bands light;
      const double excess = this->Luminaires.sampleAreas(sensor, view, random, light);
      for (int b = 0; b < this->Scene_.bands(); ++b)
        sum[b] += share * excess * light[b] / areaSamples;
    }
  }
}

double RadiositySystem::formFactor(const Vec3& x, const Vec3& n, std::size_t j, SampleStream& random, Vec3& y,
                                   double* weight) const
{
  const RadiosityElement& e = this->Mesh.elements()[j];
  const Vec3 &a = e.corner[0], &b = e.corner[1], &c = e.corner[2];
  if (!(dot(x - a, e.normal) > 0) || (dot(a - x, n) <= 0 && dot(b - x, n) <= 0 && dot(c - x, n) <= 0))
    return 0;
  const double factor = polygonFormFactor(x, n, e.corner, 3);
  if (!(factor > 0))
    return 0;
  const double u1 = random.next(), u2 = random.next();
  double s, t;
  uniformTriangle(u1, u2, s, t);
  const Vec3 ab = b - a, ac = c - a, across = cross(ab, ac);
  const SphericalTriangle seen = factor > near ? SphericalTriangle(x, a, b, c) : SphericalTriangle();
  double density = 2 / length(across);  // of y per m2, or per sr
  if (seen.solidAngle() > 0)
  {
    // Where that direction meets the element's plane.
    const Vec3 direction = seen.sample(u1, u2);
    const Vec3 d = x + dot(a - x, e.normal) / dot(direction, e.normal) * direction - a;
    s = std::clamp(dot(cross(d, ac), across) / dot(across, across), 0.0, 1.0);
    t = std::clamp(dot(cross(ab, d), across) / dot(across, across), 0.0, 1.0 - s);
    density = 1 / seen.solidAngle();
    if (!std::isfinite(s + t))
      s = t = 1.0 / 3;  // a direction along the plane
  }
  y = a + s * ab + t * ac;
  // The kernel at y over its mean: weights of the corners whose mean is exact and whose sum is one.
  const Vec3 d = y - x;
  const double squared = dot(d, d), cosine = std::max(0.0, dot(d, n)) / std::sqrt(squared);
  const double turned = seen.solidAngle() > 0 ? 1 : absDot(d, e.normal) / (squared * std::sqrt(squared));
  const double share = cosine * turned / (pi * density * factor);
  const double weights[3] = {1 - s - t, s, t};
  for (int k = 0; k < 3; ++k)
    weight[k] = share * weights[k] + (1 - share) / 3;
  return factor;
}

void RadiositySystem::drawRows(std::size_t i, std::uint64_t seed, int replicate)
{
  const RadiosityElement& e = this->Mesh.elements()[i];
  const std::size_t elements = this->Mesh.elements().size();
  std::fill_n(&this->Matrix[i * this->Each * this->unknowns()], this->Each * this->unknowns(), 0.0f);
  struct Pair
  {
    std::size_t j;
    double factor, weight[3];
  };
  std::vector<Pair> pairs;
  std::vector<ShadowRay> rays;
  for (int k = 0; k < points; ++k)
  {
    const Vec3 x = this->point(i, k);
    const RayAnchor from = this->Scene_.anchor(e.triangle, x, e.normal);
    SampleStream random(Sampling::Independent, mixBits(seed) + i, static_cast<std::uint64_t>(replicate),
                        Purpose::Selection, static_cast<std::uint64_t>(k));
    pairs.clear();
    rays.clear();
    for (std::size_t j = 0; j < elements; ++j)
    {
      Pair pair{j, 0, {}};
      Vec3 y;
      pair.factor = this->formFactor(x, e.normal, j, random, y, pair.weight);
      if (!(pair.factor > 0))
        continue;
      pairs.push_back(pair);
      const RadiosityElement& to = this->Mesh.elements()[j];
      if (this->Shadows)
        rays.push_back({from, this->Scene_.anchor(to.triangle, y, to.normal), false});
    }
    shadowTogether(this->Scene_.rays(), rays);
    float* row =
        &this->Matrix[(i * this->Each + (this->Each == 1 ? 0 : static_cast<std::size_t>(k))) * this->unknowns()];
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
      if (this->Shadows && rays[p].hidden)
        continue;
      const auto& [j, factor, weight] = pairs[p];
      if (this->Each == 1)
        row[j] += static_cast<float>(factor / points);
      else
        for (std::size_t c = 0; c < points; ++c)
          row[j * points + c] += static_cast<float>(factor * (weight[c] * (own - other) + other));
    }
  }
}

void RadiositySystem::iterate()
{
  const std::size_t n = this->unknowns();
  const int bands = this->Scene_.bands();
  auto material = [&](std::size_t u) -> const Material& {
    return this->Scene_.material(this->Mesh.elements()[u / this->Each].triangle);
  };
  auto multiply = [&](std::size_t u, const std::vector<Bands>& values) {
    Bands sum{};
    const float* row = &this->Matrix[u * n];
    for (int b = 0; b < bands; ++b)
      for (std::size_t v = 0; v < n; ++v)
        sum[b] += static_cast<double>(row[v]) * values[v][b];
    return sum;
  };
  std::vector<Bands> sent(n);  // lm/m2
  for (std::size_t u = 0; u < n; ++u)
    if (this->Mesh.elements()[u / this->Each].front)
      sent[u] = material(u).exitance;
  this->FromMeshes.assign(n, {});
  for (std::size_t u = 0; u < n; ++u)
    this->FromMeshes[u] = multiply(u, sent);
  this->Reflected.assign(n, {});
  for (std::size_t u = 0; u < n; ++u)
    for (int b = 0; b < bands; ++b)
      sent[u][b] = material(u).reflectance[b] * (this->Direct[u][b] + this->FromMeshes[u][b]);
  this->Residual = 1;
  for (this->Iterations = 0; this->Iterations<mostIterations&& this->Residual> tolerance; ++this->Iterations)
  {
    double change = 0, largest = 0;
    for (std::size_t u = 0; u < n; ++u)
    {
      const Bands found = multiply(u, sent);
      for (int b = 0; b < bands; ++b)
      {
        change = std::max(change, std::abs(found[b] - this->Reflected[u][b]));
        largest = std::max(largest, std::abs(found[b]));
        sent[u][b] += material(u).reflectance[b] * (found[b] - this->Reflected[u][b]);
      }
      this->Reflected[u] = found;
    }
    this->Residual = largest > 0 ? change / largest : 0;
  }
}

Bands RadiositySystem::at(const RadiosityMesh::Place& place, const std::vector<Bands>& values) const
{
  if (this->Each == 1)
    return values[place.element];
  Bands sum{};
  for (std::size_t k = 0; k < points; ++k)
    for (int b = 0; b < this->Scene_.bands(); ++b)
      sum[b] += (place.weight[k] * (own - other) + other) * values[points * place.element + k][b];
  return sum;
}

Bands RadiositySystem::exitance(const RadiosityMesh::Place& place) const
{
  const Material& material = this->Scene_.material(this->Mesh.elements()[place.element].triangle);
  const Bands lamps = this->at(place, this->Direct), meshes = this->meshes(place), more = this->reflected(place);
  Bands sum{};
  for (int b = 0; b < this->Scene_.bands(); ++b)
    sum[b] = std::max(0.0, material.reflectance[b] * (lamps[b] + meshes[b] + more[b]));
  return sum;
}
}  // namespace kalos
