// SPDX-License-Identifier: BSD-3-Clause
// Solves that resume from a checkpoint.
#include <gtest/gtest.h>

#include "CheckpointShelf.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
void expectSame(const Result& a, const Result& b)
{
  EXPECT_EQ(a.illuminance, b.illuminance);
  EXPECT_EQ(a.standardError, b.standardError);
  EXPECT_EQ(a.direct, b.direct);
  EXPECT_EQ(a.illuminanceBands, b.illuminanceBands);
  EXPECT_EQ(a.kernelCorrection, b.kernelCorrection);
  EXPECT_EQ(a.largestScoreShare, b.largestScoreShare);
  EXPECT_EQ(a.trusted, b.trusted);
  EXPECT_EQ(a.trajectories, b.trajectories);
  ASSERT_EQ(a.audit.size(), b.audit.size());
  for (std::size_t i = 0; i < a.audit.size(); ++i)
    EXPECT_EQ(a.audit[i].choice, b.audit[i].choice);
}

// A solve, and from each of its checkpoints again; `shelf` is where its settings keep them.
Result expectResumed(const Receivers& receivers, Settings s, Shelf& shelf)
{
  const Scene scene(room());
  Result whole = solve(scene, receivers, s);
  s.checkpoint = nullptr;
  expectSame(solve(scene, receivers, s), whole);
  EXPECT_GE(shelf.Saved.size(), 3u);
  for (std::size_t i = 0; i < shelf.Saved.size(); ++i)
  {
    Shelf again;
    again.Given = shelf.Saved[i];
    s.checkpoint = &again;
    s.threads = 3;
    const Result resumed = solve(scene, receivers, s);
    expectSame(resumed, whole);
    EXPECT_GE(resumed.rays, whole.rays);
    if (i + 1 == shelf.Saved.size())
    {
      EXPECT_GT(resumed.seconds, 0.5 * whole.seconds) << "nothing is left to do, and the time before counts";
    }
    EXPECT_EQ(again.Saved.size(), shelf.Saved.size() - 1 - i);
  }
  return whole;
}
}  // namespace

// Every method resumes from each of its rounds, with another number of threads, and ends with bitwise the same numbers.
TEST(Checkpoint, ResumedSolvesGiveBitwiseTheSameNumbers)
{
  for (const Method method :
       {Method::Local, Method::SpherePublished, Method::SphereExact, Method::Disc, Method::Clamped, Method::Compensated,
        Method::Gathered, Method::Direct, Method::Paths, Method::PhotonMap})
  {
    Shelf shelf;
    expectResumed(points(), settings(method, shelf), shelf);
  }
}

// With a goal, receivers that reached it are skipped: the same ones after a resume.
TEST(Checkpoint, ResumedSolvesLetTheSameReceiversRest)
{
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    Receivers r = points();
    for (int i = 0; i < 12; ++i)
    {
      r.points.push_back({2.5, 0.2 + 0.05 * i, 2.5});  // in the open
      r.normals.push_back({0, 0, 1});
    }
    Shelf shelf;
    Settings s = settings(method, shelf);
    s.trajectories *= 8;
    s.relativeError = method == Method::Gathered ? 0.004 : 0.01;  // far from where a pilot is
    const Result whole = expectResumed(r, s, shelf);
    const auto spared = std::find_if(whole.audit.begin(), whole.audit.end(),
                                     [](const AuditLine& line) { return line.subject == "effort"; });
    ASSERT_NE(spared, whole.audit.end());
    EXPECT_LT(std::stod(spared->choice), 99.9);
  }
}

// A solve that is stopped within a round saves the last complete one; the time continues from there.
TEST(Checkpoint, AbortedSolvesKeepTheirLastRound)
{
  const Scene scene(room());
  Shelf shelf;
  Settings s = settings(Method::Compensated, shelf);
  s.trajectories *= 32;  // long enough to be told of progress before it ends
  const Result whole = solve(scene, points(), s);
  Shelf stopped;
  s.checkpoint = &stopped;
  const Result aborted = solve(scene, points(), s, [](double f) { return f < 0.3; });
  ASSERT_TRUE(aborted.aborted);
  ASSERT_FALSE(stopped.Saved.empty());
  Shelf again;
  again.Given = stopped.Saved.back();
  s.checkpoint = &again;
  const Result resumed = solve(scene, points(), s);
  expectSame(resumed, whole);
  EXPECT_GT(resumed.seconds, aborted.seconds);
}

// Even when saving is rare, the last round is saved.
TEST(Checkpoint, TheLastRoundIsSaved)
{
  const Scene scene(room());
  Shelf often, seldom, again;
  seldom.Interval = 1e9;
  Settings s = settings(Method::Compensated, often);
  solve(scene, points(), s);
  ASSERT_GE(often.Saved.size(), 3u);
  s.checkpoint = &seldom;
  solve(scene, points(), s);
  ASSERT_EQ(seldom.Saved.size(), 1u);
  again.Given = seldom.Saved.front();
  s.checkpoint = &again;
  solve(scene, points(), s);
  EXPECT_TRUE(again.Saved.empty()) << "nothing is left to do";
}

TEST(Checkpoint, ImagesAreResumedToo)
{
  const Scene scene(room());
  Camera camera;
  camera.position = {2.5, 0.3, 2.6};
  camera.target = {2.5, 5, 2};
  camera.width = camera.height = 6;
  Shelf shelf;
  Settings s = settings(Method::Compensated, shelf);
  s.trajectories = 6400;
  const LuminanceResult whole = solveLuminance(scene, camera, s);
  ASSERT_GE(shelf.Saved.size(), 2u);
  Shelf again;
  again.Given = shelf.Saved.front();
  s.checkpoint = &again;
  const LuminanceResult resumed = solveLuminance(scene, camera, s);
  EXPECT_EQ(resumed.luminance, whole.luminance);
  EXPECT_EQ(resumed.standardError, whole.standardError);
  camera.fieldOfView = 46;
  EXPECT_THROW(solveLuminance(scene, camera, s), std::invalid_argument);
}
