// SPDX-License-Identifier: BSD-3-Clause
// Luminaires are chosen by cheap stand-ins: these bound the true light, and sampling by them has the right mean.
#include <gtest/gtest.h>

#include "ManyLuminaires.h"
#include "estimator/direct/DirectLight.h"
#include "geometry/Polygon.h"
#include "sampling/Warp.h"

using namespace kalos;

namespace
{
std::vector<Sensor> sensors(const Scene& scene, int count)
{
  RandomStream random(12, 0, Purpose::Trajectory, 0);
  std::vector<Sensor> found;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 p = randomVector(random, 5);
    const double u = random.next();
    found.emplace_back(placeReceiver(scene, p - scene.origin(), uniformSphere(u, random.next())));
  }
  return found;
}

// What a point of this intensity gives, lx.
double exact(const Luminaire& l, const Sensor& s)
{
  const Vec3 v = s.position - l.position;
  const double d2 = dot(v, v), cosine = -dot(v, s.normal) / std::sqrt(d2);
  return cosine > 0 ? intensity(l, normalized(v)) * cosine / d2 : 0;
}

// What a luminous rectangle gives.
double rectangle(const Luminaire& l, const Sensor& s)
{
  const Vec3 u = 0.5 * l.sideU, v = 0.5 * l.sideV, c = l.position;
  const Vec3 corners[] = {c - u - v, c + u - v, c + u + v, c - u + v};
  const double exitance = l.flux / length(cross(l.sideU, l.sideV));
  return dot(s.position - c, l.axis) > 0 ? exitance * polygonFormFactor(s.position, s.normal, corners, 4) : 0;
}

// What an opening gives that is near: as many small points of its intensity.
double opening(const Luminaire& l, const Sensor& s)
{
  constexpr int cut = 40;
  double sum = 0;
  for (int i = 0; i < cut * cut; ++i)
  {
    Luminaire part = l;
    part.position += ((i / cut + 0.5) / cut - 0.5) * l.sideU + ((i % cut + 0.5) / cut - 0.5) * l.sideV;
    sum += exact(part, s) / (cut * cut);
  }
  return sum;
}

bool isRectangle(const Luminaire& l)
{
  return !l.isPoint() && !l.isOpening();
}
}  // namespace

TEST(LightSampler, StandInsOfPointsAreTheirLightAndBoundsOfTables)
{
  const Scene scene(lit(8));
  const LightSampler choice(scene);
  double smooth = 0, smoothBound = 0;
  int near = 0;
  for (const Sensor& s : sensors(scene, 3000))
  {
    LuminaireWeights weights;
    near += choice.weigh(s, weights);
    ASSERT_EQ(weights.weight.size() % LuminaireWeights::lanes, 0u);
    for (std::size_t i = 0; i < scene.data().luminaires.size(); ++i)
    {
      const Luminaire& l = scene.data().luminaires[i];
      const double e = exact(l, s), w = static_cast<double>(weights.weight[i]);
      ASSERT_TRUE(w < 0 || !l.isOpening() || !isNear(l, s.position)) << "luminaire " << i;
      if (w < 0)
        continue;
      const double d = length(s.position - l.position), floor = 1e-4 * l.flux / (d * d);
      if (isRectangle(l))
      {
        ASSERT_GE(w, 0.4 * rectangle(l, s)) << "luminaire " << i;
      }
      else if (l.distribution != Distribution::Measured)
      {
        ASSERT_NEAR(w, e, 1e-3 * e + floor) << "luminaire " << i;
      }
      else
      {
        ASSERT_GE(w, (1 - 1e-4) * e) << "luminaire " << i;
      }
      if (i % 8 == 2)
      {
        smooth += e;
        smoothBound += w;
      }
    }
    for (std::size_t i = scene.data().luminaires.size(); i < weights.weight.size(); ++i)
      ASSERT_EQ(weights.weight[i], 0);
  }
  EXPECT_GT(near, 100);
  EXPECT_LT(smoothBound, 1.15 * smooth);
}

// Deterministic: of evenly spaced numbers, each luminaire gets its share, to one or two.
TEST(LightSampler, DrawsInProportion)
{
  constexpr int draws = 100000;
  LuminaireWeights weights;
  weights.weight.resize(48);
  for (int i = 0; i < 40; ++i)
    weights.weight[i] = static_cast<float>(i % 5 == 3 ? 0 : 1 + i * i % 7);
  weights.sum();
  std::vector<int> drawn(48);
  for (int k = 0; k < draws; ++k)
    ++drawn[weights.draw((k + 0.5) / draws)];
  for (std::size_t i = 0; i < drawn.size(); ++i)
    EXPECT_NEAR(drawn[i], draws * weights.share(i), 2) << i;
  EXPECT_GT(weights.weight[weights.draw(std::nextafter(1.0, 0.0))], 0);
}

// 64 luminaires of all kinds, drawn one at a time, against the sum over them. 24 sensors within 4.5 standard errors:
// false alarm below 2e-4; the grid that an opening is cut into is good to a thousandth.
TEST(LightSampler, OneOfManyHasTheMeanOfAll)
{
  constexpr int samples = 60000;
  const Scene scene(lit(8));
  const DirectLight light(scene, false, false);
  int near = 0;
  for (const Sensor& s : sensors(scene, 24))
  {
    double expected = 0, sum = 0, squares = 0;
    for (const Luminaire& l : scene.data().luminaires)
    {
      const bool isNearOpening = l.isOpening() && isNear(l, s.position);
      near += isNearOpening;
      expected += isRectangle(l) ? rectangle(l, s) : isNearOpening ? opening(l, s) : exact(l, s);
    }
    for (int k = 0; k < samples; ++k)
    {
      SampleStream random(Sampling::Independent, 5, 0, Purpose::DirectLight, static_cast<std::uint64_t>(k));
      const double e = light.sample(s, random)[0];
      sum += e / samples;
      squares += e * e / samples;
    }
    const double error = std::sqrt((squares - sum * sum) / samples);
    EXPECT_NEAR(sum, expected, 4.5 * error + 1e-3 * expected);
    EXPECT_LT(error, 0.02 * expected);
  }
  EXPECT_GT(near, 5);
}

// Shadow rays in packets find what single ones find, with the same random numbers.
TEST(LightSampler, PacketsOfSensorsSeeWhatEachSees)
{
  SceneDescription d = lit(3);
  rooms::addBox(d, {1.5, 1, 0.5}, {3, 2.5, 3.5}, 0, false);
  const Scene scene(d);
  const DirectLight light(scene, false, true);
  const std::vector<Sensor> all = sensors(scene, 40 * SegmentPacket::width);
  int lighted = 0, dark = 0;
  for (std::size_t begin = 0; begin < all.size(); begin += SegmentPacket::width)
  {
    const int count = begin % 3 == 0 ? SegmentPacket::width : 11;
    SampleStream together(Sampling::Independent, 8, 0, Purpose::DirectLight, begin), alone = together;
    DirectLight::Sample found[SegmentPacket::width];
    light.sample(&all[begin], count, together, found);
    for (int i = 0; i < count; ++i)
    {
      const double e = light.sample(all[begin + static_cast<std::size_t>(i)], alone)[0];
      EXPECT_DOUBLE_EQ(found[i].light[0], e) << begin + static_cast<std::size_t>(i);
      ++(e > 0 ? lighted : dark);
    }
  }
  EXPECT_GT(lighted, 100);
  EXPECT_GT(dark, 100);
}

// A glossy sensor: several rectangles together are what each is alone. 4.5 standard errors.
TEST(LightSampler, GlossSeesTheSumOfRectangles)
{
  constexpr int samples = 200000;
  Material satin;
  satin.reflectance = uniformBands(0.3);
  satin.specular = 0.5;
  satin.roughness = 0.1;
  const Brdf brdf(satin, 1);
  SceneDescription all;
  rooms::addBox(all, {0, 0, 0}, {5, 5, 5}, rooms::addMaterial(all, 0), true);
  for (int i = 0; i < 5; ++i)
  {
    Luminaire l;
    l.position = {0.8 + 0.8 * i, 2.5, 4};
    l.flux = 1000 * (1 + i);
    l.sideU = {0.3, 0, 0};
    l.sideV = {0, 1 + 0.5 * i, 0};
    all.luminaires.push_back(l);
  }
  auto measure = [&](const std::vector<Luminaire>& luminaires, double& error) {
    SceneDescription some = all;
    some.luminaires = luminaires;
    const Scene scene(some);
    const DirectLight light(scene, false, false);
    Sensor s(placeReceiver(scene, Vec3{2, 2.5, 1} - scene.origin(), {0, 0, 1}));
    s.brdf = &brdf;
    s.outgoing = normalized({-0.4, 0.1, 1});
    double sum = 0, squares = 0;
    for (int k = 0; k < samples; ++k)
    {
      SampleStream random(Sampling::Independent, 6, 0, Purpose::DirectLight, static_cast<std::uint64_t>(k));
      const double e = light.sample(s, random)[0];
      sum += e / samples;
      squares += e * e / samples;
    }
    error = std::sqrt((squares - sum * sum) / samples);
    return sum;
  };
  double together, variance = 0, sum = 0;
  const double found = measure(all.luminaires, together);
  for (const Luminaire& l : all.luminaires)
  {
    double error;
    sum += measure({l}, error);
    variance += error * error;
  }
  EXPECT_NEAR(found, sum, 4.5 * std::sqrt(together * together + variance));
  EXPECT_LT(std::hypot(together, std::sqrt(variance)), 0.01 * sum);
}
