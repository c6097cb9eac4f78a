// SPDX-License-Identifier: BSD-3-Clause
// Every method in every pose of one furnished, partly tilted room.
#include <gtest/gtest.h>

#include "Poses.h"
#include "statistics/Replicates.h"

using namespace poses;

namespace
{
const Vec3 middle{2.5, 2.5, 2.5};

// Ten rotations, of which half are mirrored, each with another scale and another place.
std::vector<Pose> tenPoses()
{
  std::vector<Pose> all;
  const double scales[] = {1, 1e-3, 1e3, 1, 30, 0.02, 1, 300, 1, 0.5};
  const double away[] = {0, 0.1, 1000, 1e6, 0, 0.1, 1000, 1e6, 1, 0};
  for (std::uint64_t i = 0; i < 10; ++i)
  {
    Pose pose;
    pose.axes = randomAxes(i + 1);
    pose.mirror = i % 2;
    pose.scale = scales[i];
    RandomStream random(100 + i, 0, Purpose::Selection, 0);
    pose.shift = away[i] * randomDirection(random) - pose.scale * pose.turned(middle);
    all.push_back(pose);
  }
  return all;
}

struct Mean
{
  double value = 0, error = 0;
};

// The mean over the receivers, of each replicate, so that what receivers share is in its error.
Mean meanOf(const Result& result, double factor)
{
  const std::size_t replicates = static_cast<std::size_t>(result.replicates);
  std::vector<double> means(replicates);
  for (std::size_t i = 0; i < result.replicateIlluminance.size(); ++i)
    means[i % replicates] += result.replicateIlluminance[i] * factor / static_cast<double>(result.illuminance.size());
  const MeanAndError found = summarise(means.data(), means.size());
  return {found.mean, found.standardError};
}

Settings settings(Method method, std::uint64_t seed, long long trajectories)
{
  Settings s;
  s.method = method;
  s.seed = seed;
  s.trajectories = trajectories;
  s.keepReplicates = true;
  s.delta = s.epsilon = 0.05;
  return s;
}

class EachMethod : public testing::TestWithParam<std::tuple<const char*, Method, long long>>
{
};
}  // namespace

// The mean over receivers and poses, good to 0.2 % (of direct simulation, which is slow, to 2 %), within 4.5 of its
// standard errors of that of the room as it stands (some 80 degrees of freedom: false alarm 2e-5 a method); every pose
// by itself within 8 (7 or more degrees: 1e-4).
TEST_P(EachMethod, IsTheSameInEveryPose)
{
  const auto [name, method, trajectories] = GetParam();
  const SceneDescription room = tiltedRoom(0.6);
  const Receivers receivers = tiltedReceivers();
  Mean original;
  {
    std::vector<double> means;
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const Mean one = meanOf(solve(Scene(room), receivers, settings(method, seed, trajectories)), 1);
      original.value += one.value / 10;
      squares += one.error * one.error;
    }
    original.error = std::sqrt(squares) / 10;
  }
  double sum = 0, squares = 0;
  std::uint64_t seed = 100;
  for (const Pose& pose : tenPoses())
  {
    Settings s = settings(method, ++seed, trajectories);
    s.delta *= pose.scale;
    s.epsilon *= pose.scale;
    const Mean one = meanOf(solve(Scene(posed(room, pose)), posed(receivers, pose), s), pose.scale * pose.scale);
    EXPECT_LT(std::abs(one.value - original.value), 8 * std::hypot(one.error, original.error))
        << name << ", seed " << seed << ", scale " << pose.scale << ", " << length(pose.shift)
        << " m away: " << one.value / original.value;
    sum += one.value / 10;
    squares += one.error * one.error;
  }
  const double error = std::hypot(std::sqrt(squares) / 10, original.error);
  std::printf("%s: %.5f +- %.5f of the original\n", name, sum / original.value, error / original.value);
  EXPECT_LT(std::abs(sum - original.value), 4.5 * error);
  EXPECT_LT(error, (method == Method::Direct ? 0.02 : 0.002) * original.value);
}

// The mean luminance of an image with a glossy and a mirroring panel, turned and moved with its camera: 4 poses, 8
// standard errors each (7 degrees of freedom: 1e-4). A pixel's error bar covers what it does not share with others:
// the mean's is that of the replicates.
TEST(Poses, ChangeNoImage)
{
  SceneDescription room = tiltedRoom(0.6);
  Material gloss;
  gloss.reflectance = uniformBands(0.3);
  gloss.specular = 0.2;
  gloss.roughness = 0.3;
  Material mirror;
  mirror.mirror = 0.8;
  for (const Material& material : {gloss, mirror})
  {
    room.materials.push_back(material);
    addPanel(room, {1.2 + 0.1 * static_cast<double>(room.materials.size()), 3.2, 2.5}, normalized({0.3, -0.8, 0.2}),
             0.7, static_cast<std::uint32_t>(room.materials.size() - 1));
  }
  const Camera camera{{2.6, 0.3, 2.2}, {2.2, 4, 2.3}, {0, 0, 1}, 60, 16, 12};
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    auto image = [&](const Pose& pose, std::uint64_t seed) {
      Settings s = settings(method, seed, 8192);
      s.delta = s.epsilon = 0;
      const LuminanceResult found = solveLuminance(Scene(posed(room, pose)), posed(camera, pose), s, {}, {});
      return meanOf(found.estimate, pose.scale * pose.scale);
    };
    const Mean original = image({}, 1);
    EXPECT_LT(original.error, 0.02 * original.value);
    const std::vector<Pose> all = tenPoses();
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Mean one = image(all[i], 2 + i);
      EXPECT_LT(std::abs(one.value - original.value), 8 * std::hypot(one.error, original.error)) << "pose " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, EachMethod,
                         testing::Values(std::make_tuple("local", Method::Local, 65536),
                                         std::make_tuple("sphere-published", Method::SpherePublished, 32768),
                                         std::make_tuple("sphere-exact", Method::SphereExact, 32768),
                                         std::make_tuple("disc", Method::Disc, 32768),
                                         std::make_tuple("clamped", Method::Clamped, 32768),
                                         std::make_tuple("compensated", Method::Compensated, 16384),
                                         std::make_tuple("gathered", Method::Gathered, 16384),
                                         std::make_tuple("direct", Method::Direct, 160000),
                                         std::make_tuple("paths", Method::Paths, 16384)),
                         [](const auto& instance) {
                           std::string name = std::get<0>(instance.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
