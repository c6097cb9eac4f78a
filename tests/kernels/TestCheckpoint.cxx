// SPDX-License-Identifier: BSD-3-Clause
// Solves that go on from a checkpoint, and checkpoints that are refused.
#include <gtest/gtest.h>

#include <cstring>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Checkpoint.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
// Keeps every checkpoint of a solve.
class Shelf : public CheckpointStore
{
public:
  std::string load() override { return this->Given; }
  void save(const std::string& bytes) override { this->Saved.push_back(bytes); }
  std::string name() const override { return "shelf"; }
  double interval() const override { return this->Interval; }

  double Interval = 0;  // s
  std::string Given;
  std::vector<std::string> Saved;
};

SceneDescription room()
{
  SceneDescription d = rooms::furnace(0.6, 50);
  d.luminaires = rooms::litRoom(0.6).luminaires;
  return d;
}

Receivers points()
{
  Receivers r;
  for (double x : {0.01, 0.6, 2.4, 4.9})
  {
    r.points.push_back({x, 0.6, 0});
    r.normals.push_back({0, 0, 1});
  }
  return r;
}

Settings settings(Method method, Shelf& shelf)
{
  Settings s;
  s.method = method;
  s.trajectories = 32 * 700;
  s.epsilon = 0.5;
  s.relativeError = 1e-3;  // not reached: three rounds or more
  s.checkpoint = &shelf;
  return s;
}

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

// What is said about a checkpoint; empty when the solve went on from it.
std::string refusal(const std::string& bytes,
                    const std::function<void(SceneDescription&, Receivers&, Settings&)>& change)
{
  SceneDescription d = room();
  Receivers r = points();
  Shelf shelf;
  shelf.Given = bytes;
  Settings s = settings(Method::Local, shelf);
  s.trajectories = 3200;
  change(d, r, s);
  try
  {
    solve(Scene(d), r, s);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_TRUE(shelf.Saved.empty()) << "a refused checkpoint is left as it is";
    return error.what();
  }
}

std::string checkpointOfLocal()
{
  Shelf shelf;
  Settings s = settings(Method::Local, shelf);
  s.trajectories = 3200;
  solve(Scene(room()), points(), s);
  return shelf.Saved.front();
}
}  // namespace

// From each round of each method, with another number of threads, to bitwise the same end.
TEST(Checkpoint, ResumedSolvesGiveBitwiseTheSameNumbers)
{
  for (const Method method : {Method::Local, Method::SpherePublished, Method::SphereExact, Method::Disc,
                              Method::Clamped, Method::Compensated, Method::Gathered, Method::Direct})
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

// Stopped within a round: what is saved is the last complete one, and time goes on where it was.
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

// What is saved seldom is the last round all the same.
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

TEST(Checkpoint, OthersAreRefusedWithTheReason)
{
  const std::string good = checkpointOfLocal();
  auto same = [](SceneDescription&, Receivers&, Settings&) {};
  EXPECT_EQ(refusal(good, same), "");
  EXPECT_EQ(refusal(good, [](SceneDescription& d, Receivers&, Settings&) { d.points[3].x += 1e-9; }),
            "shelf: checkpoint: belongs to another scene; expected one of this solve, or no file");
  EXPECT_NE(refusal(good, [](SceneDescription& d, Receivers&, Settings&) { d.luminaires[0].flux *= 2; }), "");
  EXPECT_NE(refusal(good, [](SceneDescription& d, Receivers&, Settings&) { d.materials[0].reflectance[0] = 0.3; }), "");
  EXPECT_EQ(refusal(good, [](SceneDescription&, Receivers& r, Settings&) { r.points[0].y = 0.7; }),
            "shelf: checkpoint: belongs to another set of receivers; expected one of this solve, or no file");
  EXPECT_EQ(refusal(good, [](SceneDescription&, Receivers&, Settings& s) { s.seed = 2; }),
            "shelf: checkpoint: was made with seed 1; expected 2, or no file");
  EXPECT_EQ(refusal(good, [](SceneDescription&, Receivers&, Settings& s) { s.method = Method::Direct; }),
            "shelf: checkpoint: was made with method 0; expected 7, or no file");
  EXPECT_EQ(refusal(good, [](SceneDescription&, Receivers&, Settings& s) { s.relativeError = 0.25; }),
            "shelf: checkpoint: was made with error 0.001; expected 0.25, or no file");
  EXPECT_EQ(refusal("not a checkpoint", same),
            "shelf: checkpoint: is no checkpoint of Kalos; expected one, or no file");
  const Identity other{{"version", "0.0.1"}};
  EXPECT_EQ(refusal(seal(other, "state"), same),
            std::string("shelf: checkpoint: was made with version 0.0.1; expected ") +
                identify(Scene(room()), points(), {}, false)[0].second + ", or no file");
}

// With the right checksum and identity.
TEST(Checkpoint, WhatNoSolveHasWrittenIsRefused)
{
  Shelf none;
  Settings s = settings(Method::Local, none);
  s.trajectories = 3200;
  const Identity identity = identify(Scene(room()), points(), s, false);
  const std::string state = unseal(checkpointOfLocal(), identity);
  auto said = [&](const std::string& other) {
    return refusal(seal(identity, other), [](SceneDescription&, Receivers&, Settings&) {});
  };
  EXPECT_EQ(said(state), "");
  EXPECT_EQ(said(state + "x"), "shelf: checkpoint: has 1 bytes after the last value; expected none");
  EXPECT_EQ(said(state.substr(0, state.size() - 1)),
            "shelf: checkpoint: ends before the last value; expected all of them");
  std::string backwards = state;
  const long long trajectories = -1;  // the first value of a state
  std::memcpy(&backwards[0], &trajectories, sizeof trajectories);
  EXPECT_EQ(said(backwards),
            "shelf: checkpoint: has impossible counts; expected trajectories, rays and seconds from 0 on");
}

// A message is one line, whatever bytes were sealed.
TEST(Checkpoint, MessagesQuoteNoControlCharacters)
{
  const std::string version(1, '\0');
  EXPECT_EQ(refusal(seal({{"version", version + "\r\x1b[2J" + std::string(100, 'x')}}, "state"),
                    [](SceneDescription&, Receivers&, Settings&) {}),
            "shelf: checkpoint: was made with version ???[2J" + std::string(54, 'x') + "; expected " +
                identify(Scene(room()), points(), {}, false)[0].second + ", or no file");
}

// Every length that is too short, and random changes of one to eight bytes, in 200 000 places with a fixed seed.
TEST(Checkpoint, DamagedOnesAreRefused)
{
  const Identity identity{{"version", "1"}, {"seed", "7"}};
  std::string state;
  for (int i = 0; i < 60; ++i)
    state += static_cast<char>(i * 37);
  const std::string good = seal(identity, state);
  EXPECT_EQ(unseal(good, identity), state);
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_THROW(unseal(good.substr(0, length), identity), std::invalid_argument) << length << " bytes";
  EXPECT_THROW(unseal(good + "x", identity), std::invalid_argument);
  RandomStream random(3, 0, Purpose::Selection, 0);
  auto draw = [&](std::size_t n) { return static_cast<std::size_t>(random.next() * static_cast<double>(n)); };
  for (int i = 0; i < 200000; ++i)
  {
    std::string bad = good;
    for (std::size_t k = draw(8) + 1; k > 0; --k)
      bad[draw(bad.size())] = static_cast<char>(draw(256));
    if (bad != good)
    {
      ASSERT_THROW(unseal(bad, identity), std::invalid_argument) << "change " << i;
    }
  }
}
