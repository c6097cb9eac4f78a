// SPDX-License-Identifier: BSD-3-Clause
// Highlights of luminaires in glossy planes: means by quadrature, the bound of single scores, and the shares of others.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "Student.h"
#include "estimator/direct/Highlights.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
Luminaire isotropic(const Vec3& position)
{
  Luminaire lamp;
  lamp.position = position;
  lamp.flux = 4 * pi;  // 1 cd
  lamp.distribution = Distribution::Isotropic;
  return lamp;
}

SceneDescription plate(double roughness, double side, double reflectance = 0)
{
  SceneDescription d;
  d.materials[rooms::addMaterial(d, reflectance)].specular = 0.4;
  d.materials[0].roughness = roughness;
  rooms::addQuad(d, {-side / 2, -side / 2, 0}, {side, 0, 0}, {0, side, 0}, 0);
  return d;
}

Sensor sensorAt(const Vec3& p, const Vec3& n)
{
  Sensor sensor{RayAnchor(p)};
  sensor.normal = normalized(n);
  sensor.highlightsApart = true;
  return sensor;
}

// By a midpoint rule over the square about the origin, in polar cells about `middle` that are fine there.
double byQuadrature(const Scene& scene, double side, const Vec3& lamp, const Sensor& sensor, const Vec3& middle)
{
  constexpr int rings = 1200, sectors = 600;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j)
    {
      // r = scale (e^(6 t) - 1)
      const double scale = 0.005, t = (i + 0.5) / rings, r = scale * (std::exp(8 * t) - 1),
                   phi = 2 * pi * (j + 0.5) / sectors;
      const double area = 8 * scale * std::exp(8 * t) / rings * 2 * pi / sectors * r;
      const Vec3 y = middle + Vec3{r * std::cos(phi), r * std::sin(phi), 0};
      if (std::max(std::abs(y.x), std::abs(y.y)) > side / 2)
        continue;
      const Vec3 l = lamp - y, s = sensor.position - y;
      const Vec3 wi = normalized(l), wo = normalized(s);
      const double cosines = wi.z * wo.z * std::max(0.0, -dot(wo, sensor.normal));
      sum += scene.brdf(0).lobeTimesPi({0, 0, 1}, wi, wo) / pi * cosines / (dot(l, l) * dot(s, s)) * area;
    }
  return sum;
}
}  // namespace

// Sharp and wide lobes, a lamp near the plane, a sensor near it, a plane that ends beside the mirror point. 20 000
// samples each; |z| < 4.5, false alarm 1e-5 each; the midpoint rule is good to 1e-3.
TEST(Highlights, MeanIsTheIntegralOverThePlane)
{
  struct Pair
  {
    Vec3 lamp, sensor, normal;
  };
  const Pair pairs[] = {{{0.2, 0.1, 1.0}, {0.9, -0.3, 1.4}, {0, 0, -1}},
                        {{0.0, 0.0, 0.02}, {0.5, 0.4, 0.9}, {-1, 0, 0}},
                        {{-0.6, 0.3, 1.2}, {0.4, 0.1, 0.01}, {-1, 0, 0}},
                        {{-0.9, 0.0, 0.5}, {2.9, 0.2, 0.9}, {-1, 0, -0.2}}};
  constexpr double side = 2;
  constexpr int count = 20000;
  for (const double roughness : {0.1, 0.25, 0.5})
    for (const Pair& pair : pairs)
    {
      SceneDescription d = plate(roughness, side);
      d.luminaires.push_back(isotropic(pair.lamp));
      const Scene scene(d);
      const Highlights highlights(scene, true, true);
      const Sensor sensor = sensorAt(pair.sensor - scene.origin(), pair.normal);
      SampleStream random(Sampling::Independent, 5, 0, Purpose::Highlight, 0);
      double sum = 0, squares = 0;
      for (int i = 0; i < count; ++i)
      {
        const double e = highlights.sample(sensor, random)[0];
        sum += e;
        squares += e * e;
      }
      const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
      const double above = pair.lamp.z + pair.sensor.z;
      const Vec3 middle = pair.lamp + (pair.lamp.z / above) * (pair.sensor - pair.lamp);
      const double exact = byQuadrature(scene, side, pair.lamp, sensor, {middle.x, middle.y, 0});
      EXPECT_LT(std::abs(mean - exact), 4.5 * error + 2e-3 * exact)
          << roughness << " at " << pair.lamp.z << ' ' << pair.sensor.z;
      EXPECT_LT(error, 0.05 * exact);
    }
}

// Worst pairs: lamps and sensors from 1 mm to 10 m over a wide plane and beside each other, lobes down to 0.03. No
// score exceeds the bound of the header, 25 times what the mirror image would send straight at the sensor.
TEST(Highlights, ScoresAreBounded)
{
  RandomStream random(9, 0, Purpose::Averaging, 0);
  auto height = [&] { return 1e-3 * std::pow(1e4, random.next()); };
  double largest = 0;
  for (int k = 0; k < 400; ++k)
  {
    SceneDescription d = plate(0.03 + 0.47 * random.next(), 100);
    const Vec3 lamp{0, 0, height()}, at{height(), 0, height()};
    d.luminaires.push_back(isotropic(lamp));
    const Scene scene(d);
    const Highlights highlights(scene, true, false);
    const Sensor sensor =
        sensorAt(at - scene.origin(), {random.next() - 0.5, random.next() - 0.5, random.next() - 0.5});
    SampleStream samples(Sampling::Independent, 7, 0, Purpose::Highlight, static_cast<std::uint64_t>(k));
    const Vec3 way = at - Vec3{lamp.x, lamp.y, -lamp.z};
    for (int i = 0; i < 2000; ++i)
      largest = std::max(largest, highlights.sample(sensor, samples)[0] * dot(way, way));
  }
  std::cout << "largest score over the image's illuminance " << largest << '\n';
  EXPECT_LT(largest, 25);
  EXPECT_GT(largest, 1);
}

// Highlights apart, and left to vertices and gather rays: two ways, one truth, at receivers on a wall and a ceiling
// over a satin floor that several lobes reflect again. |t| < 4.8 for six values: false alarm below 1e-3.
TEST(Highlights, MoveNoMean)
{
  SceneDescription d = rooms::litRoom(0.4);
  for (Material& m : d.materials)
  {
    m.specular = 0.3;
    m.roughness = 0.5;
  }
  d.luminaires[0].position = {1.5, 2, 3};
  const Scene scene(d);
  Receivers r;
  r.points = {{5, 2, 1.5}, {2, 3, 5}, {2, 1, 0}};
  r.normals = {{-1, 0, 0}, {0, 0, -1}, {0, 0, 1}};
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    Settings s;
    s.method = method;
    s.trajectories = 200000;
    const Result apart = solve(scene, r, s);
    s.disabled = {Technique::Highlights};
    s.seed = 2;
    const Result mixed = solve(scene, r, s);
    for (std::size_t i = 0; i < r.points.size(); ++i)
    {
      const double error = std::hypot(apart.standardError[i], mixed.standardError[i]);
      EXPECT_LT(std::abs(apart.illuminance[i] - mixed.illuminance[i]), 4.8 * error) << i;
      EXPECT_LT(error, 0.02 * mixed.illuminance[i]);
    }
  }
}
