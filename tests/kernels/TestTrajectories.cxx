// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/kernel/PairKernel.h"
#include "estimator/tracing/Trajectories.h"
#include "sampling/Warp.h"

using namespace kalos;

// Roulette, not truncation: the mean number of collisions is 1/(1 - rho). 20 000 trajectories; the number of collisions
// is geometric with variance rho/(1-rho)^2; |z| < 4.4, false alarm 1e-5 each.
TEST(Trajectories, LengthIsNotLimited)
{
  for (double rho : {0.05, 0.5, 0.95})
  {
    const Scene scene(rooms::litRoom(rho));
    const Emission emission(scene);
    const int count = 20000;
    const LightVertices chunk = traceTrajectories(scene, emission, {}, 0, 0, count);
    const double mean = double(chunk.reflected.size()) / count;
    const double error = std::sqrt(rho) / (1 - rho) / std::sqrt(double(count));
    EXPECT_LT(std::abs(mean - 1 / (1 - rho)), 4.4 * error) << "rho " << rho;
    for (float m : chunk.reflected.flux[0])
      EXPECT_NEAR(m, rho * 10000, 0.1);
  }
}

TEST(Trajectories, EmissionCarriesTheWholeFlux)
{
  SceneDescription d = rooms::furnace(0.6, 100);
  Luminaire lamp;
  lamp.position = {2.5, 2.5, 4};
  lamp.flux = 5000;
  d.luminaires.push_back(lamp);
  const Scene scene(d);
  const Emission emission(scene);
  EXPECT_NEAR(emission.totalFlux(), 5000 + 100 * scene.surfaceArea(), 1e-6);
  // Share of the luminaire's starts: binomial, |z| < 4.4 (false alarm 1e-5).
  const double share = 5000 / emission.totalFlux();
  int fromLamp = 0;
  const int count = 40000;
  for (int i = 0; i < count; ++i)
  {
    SampleStream random(Sampling::Independent, 2, 0, Purpose::Trajectory, i);
    fromLamp += !emission.sample(random).onSurface;
  }
  EXPECT_LT(std::abs(fromLamp - share * count), 4.4 * std::sqrt(count * share * (1 - share)));
}

// Starts on a rectangle are uniform over it: mean and variance of both coordinates, 10 000 starts, |z| < 4.4 (false
// alarm 1e-5 each).
TEST(Trajectories, RectanglesEmitAllOver)
{
  SceneDescription d = rooms::litRoom(0.6);
  Luminaire& panel = d.luminaires[0];
  panel.position = {2, 3, 4};
  panel.sideU = {1.2, 0, 0};
  panel.sideV = {0, 0.4, 0};
  const Scene scene(d);
  const Emission emission(scene);
  const int count = 10000;
  double sum[2] = {}, squares[2] = {};
  for (int i = 0; i < count; ++i)
  {
    SampleStream random(Sampling::Independent, 5, 0, Purpose::Trajectory, i);
    const Vec3 p = emission.sample(random).anchor.point + scene.origin() - Vec3{2, 3, 4};
    const double x[2] = {p.x / 1.2, p.y / 0.4};
    for (int k = 0; k < 2; ++k)
    {
      sum[k] += x[k];
      squares[k] += x[k] * x[k];
    }
  }
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_LT(std::abs(sum[k] / count), 4.4 * std::sqrt(1.0 / 12 / count)) << k;
    EXPECT_LT(std::abs(squares[k] / count - 1.0 / 12), 4.4 * std::sqrt(1.0 / 180 / count)) << k;  // of u^2: 1/180
  }
}

// The vector code against the formula (E3) in double precision.
TEST(PairKernel, AgreesWithTheFormula)
{
  const Scene scene(rooms::furnace(0.6, 100));
  const Emission emission(scene);
  const VertexSet v = traceTrajectories(scene, emission, {}, 0, 0, 2000).reflected;
  const Vec3 n = normalized(Vec3{0.2, 0.3, 1});
  const Sensor receiver(placeReceiver(scene, Vec3{2.4, 2.5, 1} - scene.origin(), n));
  std::size_t scored = 0, expected = 0;
  for (std::size_t begin = 0; begin < v.size(); begin += PairBlock::capacity)
  {
    const int count = static_cast<int>(std::min<std::size_t>(PairBlock::capacity, v.size() - begin));
    PairBlock block;
    formPairs(v, begin, count, receiver, 0, block);
    for (int i = 0; i < block.count; ++i, ++scored)
    {
      const int j = block.index[i];
      const Vec3 d = Vec3{v.px[j], v.py[j], v.pz[j]} - receiver.position;
      const double d2 = dot(d, d);
      const double g = dot(d, n) * -dot(d, Vec3{v.nx[j], v.ny[j], v.nz[j]}) / (pi * d2 * d2);
      EXPECT_NEAR(block.kernel[i], g, 1e-5 * g + 1e-9);
    }
    for (int j = static_cast<int>(begin); j < static_cast<int>(begin) + count; ++j)
    {
      const Vec3 d = Vec3{v.px[j], v.py[j], v.pz[j]} - receiver.position;
      expected += dot(d, n) > 1e-6 && dot(d, Vec3{v.nx[j], v.ny[j], v.nz[j]}) < -1e-6;
    }
  }
  EXPECT_NEAR(double(scored), double(expected), 2);
}

// Down to a distance of 1e-6 m and beyond the scene, in both forms and for tiles that are no whole number of lanes: as
// exact as estimator/kernel/VectorKernel.h says, against double precision at the same vertices.
TEST(VectorKernel, IsExactAtEveryDistance)
{
  const Scene scene(rooms::furnace(0.6, 0));
  const Vec3 n = normalized(Vec3{0.2, 0.3, 1});
  const Sensor sensor(placeReceiver(scene, Vec3{2.4, 0.5, 1} - scene.origin(), n));
  RandomStream random(1, 0, Purpose::Selection, 0);
  auto direction = [&] {
    const double u1 = random.next(), u2 = random.next();
    return uniformSphere(u1, u2);
  };
  VertexSet v;
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 p = sensor.position + std::pow(10, 8 * random.next() - 6) * direction();
    v.add(scene.anchor(p, direction()), uniformBands(1 + random.next()), 0.1 + random.next());
  }
  double largestError = 0;
  std::size_t scored = 0;
  for (double share : {0.0, 0.02, 5.0})
    for (int size : {1, 15, 16, 100, 128})
      for (std::size_t begin = 0; begin + size <= v.size(); begin += size)
      {
        float kernel[VertexTile::capacity];
        TileScores scores;
        evaluateKernels({v, begin, size}, sensor, share, kernel);
        scoreTile({v, begin, size}, sensor, share, scores);
        double along[VertexTile::lanes] = {}, sum = 0, largest = 0;
        for (int i = 0; i < size; ++i)
        {
          const Vec3 d = v.position(begin + i) - sensor.position;
          const double d2 = dot(d, d);
          const double g = std::max(0.0, dot(d, n)) * std::max(0.0, -dot(d, v.normal(begin + i))) / (pi * d2 * d2);
          const double expected = g / (1 + g * share * double(v.inverseDensity[begin + i]));
          largestError = std::max(largestError, std::abs(double(kernel[i]) - expected) * pi * d2);
          const double score = double(kernel[i]) * double(v.luminous[begin + i]);
          along[i % VertexTile::lanes] += score;
          EXPECT_NEAR(double(scores.reached[i]), along[i % VertexTile::lanes], 4e-6 * along[i % VertexTile::lanes]);
          scored += kernel[i] > 0;
          sum += score;
          largest = std::max(largest, score);
        }
        EXPECT_NEAR(scores.total(), sum, 4e-6 * sum);
        EXPECT_NEAR(double(scores.largest), largest, 1e-6 * largest);
      }
  EXPECT_LT(largestError, 1e-6);
  EXPECT_GT(scored, 3000u);
}
