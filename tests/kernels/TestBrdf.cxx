// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "material/Brdf.h"
#include "sampling/Random.h"
#include "sampling/Sobol.h"
#include "sampling/Warp.h"

using namespace kalos;

static Material satin(double reflectance, double specular, double roughness)
{
  Material m;
  m.reflectance = uniformBands(reflectance);
  m.specular = specular;
  m.roughness = roughness;
  return m;
}

static const Material materials[] = {satin(0.4, 0.04, 0.2), satin(0.9, 0.09, 0.5), satin(0, 0.6, 1),
                                     satin(0.5, 0.3, 0.35)};
static const Vec3 n{0, 0, 1};

static Vec3 direction(double theta, double phi)
{
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TEST(Brdf, IsReciprocal)
{
  RandomStream random(1, 0, Purpose::Gather, 0);
  for (const Material& m : materials)
  {
    const Brdf brdf(m, 1);
    for (int i = 0; i < 200; ++i)
    {
      const double a = random.next(), b = random.next(), c = random.next(), d = random.next();
      const Vec3 wi = cosineHemisphere(a, b), wo = cosineHemisphere(c, d);
      const double there = brdf.timesPi(n, wi, wo)[0], back = brdf.timesPi(n, wo, wi)[0];
      EXPECT_NEAR(there, back, 1e-10 * (1 + there));
    }
  }
}

// The light that leaves is what albedo() says and never more than arrives: quadrature over the hemisphere, in the angle
// about the mirror direction's plane, 1500 x 1500 cells, good to 1e-3 for these widths.
TEST(Brdf, ConservesEnergy)
{
  for (const Material& m : materials)
  {
    const Brdf brdf(m, 1);
    for (double theta : {0.05, 1.4})
    {
      const Vec3 wo = direction(theta, 0);
      double sum = 0;
      const int steps = 1500;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
          sum += brdf.timesPi(n, cosineHemisphere((i + 0.5) / steps, (j + 0.5) / steps), wo)[0];
      const double leaving = sum / (double(steps) * steps);
      EXPECT_NEAR(leaving, brdf.albedo(wo.z, uniformBands(1)), 4e-3) << m.roughness << " at " << theta;
      EXPECT_LE(leaving, 1);
    }
  }
}

// The density integrates to the albedo: what sample() does not draw is absorbed. Visible normals may reflect below the
// horizon, which loses a little of the lobe, and much of it at roughness 1 (weights make up for it; not tested here).
TEST(Brdf, DensityIntegratesToTheAlbedo)
{
  for (const Material& m : materials)
  {
    if (m.roughness == 1)
      continue;
    const Brdf brdf(m, 1);
    const Vec3 wo = direction(0.7, 1);
    double sum = 0;
    const int steps = 1500;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j)
      {
        const Vec3 wi = cosineHemisphere((i + 0.5) / steps, (j + 0.5) / steps);
        sum += pi * brdf.density(n, wo, wi, uniformBands(1)) / wi.z;
      }
    EXPECT_NEAR(sum / (double(steps) * steps), brdf.albedo(wo.z, uniformBands(1)), 0.06 * m.specular + 0.003);
  }
}

// Samples follow the density: the mean weight is the albedo. 200 000 samples, |z| < 4.4 (false alarm 1e-5 each), with
// the table's interpolation error of 2e-3.
TEST(Brdf, SamplesCarryTheAlbedo)
{
  for (const Material& m : materials)
  {
    const Brdf brdf(m, 1);
    const Vec3 wo = direction(0.9, 2);
    RandomStream random(3, 0, Purpose::Gather, 0);
    const int count = 200000;
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i)
    {
      const double u0 = random.next(), u1 = random.next(), u2 = random.next();
      const BrdfSample s = brdf.sample(n, wo, uniformBands(1), u0, u1, u2);
      const double w = s.alive ? s.weight[0] : 0;
      EXPECT_LT(w, 3);
      sum += w;
      squares += w * w;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    EXPECT_LT(std::abs(mean - brdf.albedo(wo.z, uniformBands(1))), 4.4 * error + 2e-3);
  }
}

TEST(Brdf, MirrorIsDrawnByItsShare)
{
  Material m = satin(0.3, 0, 1);
  m.mirror = 0.5;
  const Brdf brdf(m, 1);
  const Vec3 wo = direction(0.4, 0.3);
  const BrdfSample s = brdf.sample(n, wo, uniformBands(1), 0.49, 0.1, 0.2);
  EXPECT_TRUE(s.alive && s.mirror);
  EXPECT_NEAR(s.direction.x, -wo.x, 1e-15);
  EXPECT_NEAR(s.direction.z, wo.z, 1e-15);
  EXPECT_FALSE(brdf.sample(n, wo, uniformBands(1), 0.51, 0.1, 0.2).mirror);
  EXPECT_FALSE(brdf.sample(n, wo, uniformBands(1), 0.81, 0.1, 0.2).alive);
  // With gloss beside the mirror nothing is reflected beyond what both reflect.
  Material both = satin(0, 0.6, 0.3);
  both.mirror = 0.3;
  const Brdf glossy(both, 1);
  const double albedo = 0.3 + glossy.albedo(wo.z, uniformBands(1));
  EXPECT_TRUE(glossy.sample(n, wo, uniformBands(1), albedo - 0.02, 0.1, 0.2).alive);
  EXPECT_FALSE(glossy.sample(n, wo, uniformBands(1), albedo + 0.02, 0.1, 0.2).alive);
}

// Nearly a mirror: the lobe reflects by Schlick's formula, F0 + (1 - F0)(1 - cos)^5.
TEST(Brdf, NarrowLobeReflectsBySchlick)
{
  const Brdf brdf(satin(0, 0.3, 0.02), 1);
  for (const double mu : {0.3, 0.5, 0.8, 1.0})
    EXPECT_NEAR(brdf.albedo(mu, uniformBands(1)), 0.3 + 0.7 * std::pow(1 - mu, 5), 5e-3) << mu;
}

// Every elementary interval of area 2^-8 holds one of the first 256 points: a (0,2)-sequence, whatever the scrambling.
TEST(Sobol, IsStratifiedInEveryElementaryInterval)
{
  for (std::uint64_t key : {1ull, 77ull, 123456789ull})
    for (int k = 0; k <= 8; ++k)
    {
      std::vector<int> cells(256);
      for (std::uint32_t i = 0; i < 256; ++i)
      {
        double u1, u2;
        sobolPoint(key, i, u1, u2);
        ++cells[(static_cast<int>(u1 * (1 << k)) << (8 - k)) + static_cast<int>(u2 * (1 << (8 - k)))];
      }
      for (int c : cells)
        EXPECT_EQ(c, 1);
    }
}
