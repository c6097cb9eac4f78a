// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints that are refused: of other solves, or damaged.
#include <gtest/gtest.h>

#include <cstring>

#include "CheckpointShelf.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
// The message about a refused checkpoint; empty when the solve resumed from it.
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
