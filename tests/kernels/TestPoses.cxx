// SPDX-License-Identifier: BSD-3-Clause
// Every method in every pose of one furnished, partly tilted room: illuminance and images.
#include <gtest/gtest.h>

#include "Poses.h"
#include "Student.h"

using namespace poses;

namespace
{
struct Case
{
  const char* name;
  Method method;
  long long trajectories, ofImages;
  double largestError;  // of the mean, relative
};

Settings settings(const Case& c, std::uint64_t seed, long long trajectories)
{
  Settings s;
  s.method = c.method;
  s.seed = seed;
  s.trajectories = trajectories;
  s.keepReplicates = true;
  s.delta = s.epsilon = 0.05;
  return s;
}

Settings scaled(Settings s, double scale)
{
  s.delta *= scale;
  s.epsilon *= scale;
  return s;
}

// Compares what is found in all poses with the original: the mean over receivers and each receiver, with 70 degrees of
// freedom or more; each of the two raises one false alarm in a thousand seeds for all nine methods together. In every
// pose by itself the mean is within 8 standard errors (7 or more degrees: 1e-4).
void expectSame(const Case& c, const Average& original, const Average& found)
{
  const double error = std::hypot(found.mean().standardError, original.mean().standardError) / original.mean().mean;
  const int freedom = std::min(original.freedom(), found.freedom());
  const auto allowedFor = [&](double comparisons) {
    return studentQuantile(std::pow(1 - 1e-3, 1 / (9 * comparisons)), freedom);
  };
  EXPECT_LT(apart(found.mean(), original.mean()), allowedFor(1)) << c.name;
  EXPECT_LT(error, c.largestError) << c.name;
  double farthest = 0, largest = 0;
  for (std::size_t r = 0; r < original.size(); ++r)
  {
    const double there = apart(found.at(r), original.at(r));
    EXPECT_LT(there, allowedFor(static_cast<double>(original.size())))
        << c.name << ", receiver " << r << ": " << found.at(r).mean << " instead of " << original.at(r).mean;
    farthest = std::max(farthest, there);
    largest = std::max(largest, found.at(r).standardError / original.at(r).mean);
  }
  std::printf(
      "%s: mean %.5f +- %.5f of the original; of %zu receivers the farthest is %.1f of %.1f errors off, the "
      "largest error %.2f %%\n",
      c.name, found.mean().mean / original.mean().mean, error, original.size(), farthest,
      allowedFor(static_cast<double>(original.size())), 100 * largest);
}

// What the pixels see, by columns from the right where the pose is mirrored.
Result seen(const LuminanceResult& image, const Camera& camera, bool mirrored)
{
  Result found = image.estimate;
  found.illuminance = image.luminance;
  found.standardError = image.standardError;
  for (auto* values : {&found.illuminance, &found.standardError})
    for (auto row = values->begin(); mirrored && row != values->end(); row += camera.width)
      std::reverse(row, row + camera.width);
  return found;
}

class EachMethod : public testing::TestWithParam<Case>
{
};
}  // namespace

TEST_P(EachMethod, IsTheSameInEveryPose)
{
  const Case& c = GetParam();
  const SceneDescription room = tiltedRoom(0.6);
  const Receivers receivers = tiltedReceivers();
  Average original, found;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    original.add(solve(Scene(room), receivers, settings(c, seed, c.trajectories)), 1);
  std::uint64_t seed = 100;
  for (const Pose& pose : tenPoses())
  {
    found.add(solve(Scene(posed(room, pose)), posed(receivers, pose),
                    scaled(settings(c, ++seed, c.trajectories), pose.scale)),
              pose.scale * pose.scale);
    EXPECT_LT(apart(found.last(), original.mean()), 8)
        << c.name << ", seed " << seed << ", scale " << pose.scale << ", " << length(pose.shift)
        << " m away: " << found.last().mean / original.mean().mean;
  }
  expectSame(c, original, found);
}

// An image with a glossy and a mirroring panel, turned and moved with its camera: what its pixels see.
TEST_P(EachMethod, SeesTheSameInEveryPose)
{
  const Case& c = GetParam();
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
  const Camera camera{{2.6, 0.3, 2.2}, {2.2, 4, 2.3}, {0, 0, 1}, 60, 8, 6};
  Average original, found;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    original.add(seen(solveLuminance(Scene(room), camera, settings(c, seed, c.ofImages)), camera, false), 1);
  std::uint64_t seed = 100;
  for (const Pose& pose : tenPoses())
  {
    const LuminanceResult image = solveLuminance(Scene(posed(room, pose)), posed(camera, pose),
                                                 scaled(settings(c, ++seed, c.ofImages), pose.scale));
    found.add(seen(image, camera, pose.mirror), pose.scale * pose.scale);
    EXPECT_LT(apart(found.last(), original.mean()), 8) << c.name << ", seed " << seed;
  }
  expectSame(c, original, found);
}

INSTANTIATE_TEST_SUITE_P(Poses, EachMethod,
                         testing::Values(Case{"local", Method::Local, 65536, 32768, 0.002},
                                         Case{"sphere_published", Method::SpherePublished, 32768, 32768, 0.002},
                                         Case{"sphere_exact", Method::SphereExact, 32768, 32768, 0.002},
                                         Case{"disc", Method::Disc, 32768, 32768, 0.002},
                                         Case{"clamped", Method::Clamped, 32768, 32768, 0.002},
                                         Case{"compensated", Method::Compensated, 16384, 16384, 0.002},
                                         Case{"gathered", Method::Gathered, 16384, 16384, 0.002},
                                         Case{"direct", Method::Direct, 160000, 160000, 0.02},
                                         Case{"paths", Method::Paths, 16384, 16384, 0.002}),
                         [](const auto& instance) { return std::string(instance.param.name); });
