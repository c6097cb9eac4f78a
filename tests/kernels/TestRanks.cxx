// SPDX-License-Identifier: BSD-3-Clause
// Several ranks, here as threads, give bitwise the numbers of one, and none waits forever.
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "estimator/control/Ranks.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
// Gathers the parts of a number of threads.
class Meeting
{
public:
  explicit Meeting(int size) : Parts(size) {}

  int size() const { return static_cast<int>(this->Parts.size()); }

  std::vector<double> gather(int rank, const std::vector<double>& own)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Parts[rank] = own;
    if (++this->Arrived == this->size())
    {
      this->Joined.clear();
      for (const auto& part : this->Parts)
        this->Joined.insert(this->Joined.end(), part.begin(), part.end());
      this->Arrived = 0;
      ++this->Round;
      this->Change.notify_all();
      return this->Joined;
    }
    const int round = this->Round;
    this->Change.wait(lock, [&] { return this->Round != round; });
    return this->Joined;
  }

private:
  std::mutex Mutex;
  std::condition_variable Change;
  std::vector<std::vector<double>> Parts;
  std::vector<double> Joined;
  int Arrived = 0, Round = 0;
};

class ThreadRank : public Ranks
{
public:
  ThreadRank(Meeting& meeting, int rank) : All(meeting), Own(rank) {}
  int rank() const override { return this->Own; }
  int size() const override { return this->All.size(); }
  std::vector<double> gather(const std::vector<double>& own) const override { return this->All.gather(this->Own, own); }

private:
  Meeting& All;
  int Own;
};

Receivers points()
{
  Receivers r;
  for (double x : {0.3, 1.6, 2.4, 4.999})
  {
    r.points.push_back({x, 0.6, 0});
    r.normals.push_back({0, 0, 1});
  }
  return r;
}

struct Outcome
{
  Result result;
  std::string error;
};

std::vector<Outcome> solveOn(int size, Settings settings, const std::function<bool(int, double)>& progress)
{
  const Scene scene(rooms::litRoom(0.6));
  Meeting meeting(size);
  std::vector<Outcome> outcomes(size);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < size; ++rank)
    threads.emplace_back([&, rank, settings]() mutable {
      const ThreadRank ranks(meeting, rank);
      settings.ranks = &ranks;
      try
      {
        outcomes[rank].result = solve(scene, points(), settings, [&](double f) { return progress(rank, f); });
      }
      catch (const std::exception& error)
      {
        outcomes[rank].error = error.what();
      }
    });
  for (auto& thread : threads)
    thread.join();
  return outcomes;
}

bool goOn(int, double)
{
  return true;
}
}  // namespace

TEST(Ranks, GiveBitwiseTheNumbersOfOne)
{
  for (const Method method : {Method::Compensated, Method::Gathered, Method::Local, Method::SphereExact, Method::Direct,
                              Method::Paths, Method::PhotonMap})
    for (const bool goal : {false, true})
    {
      Settings s;
      s.method = method;
      s.threads = 1;
      s.trajectories = 1600;
      s.epsilon = 0.5;
      s.relativeError = goal ? 0.01 : 0;
      const Result one = solve(Scene(rooms::litRoom(0.6)), points(), s);
      ASSERT_GT(one.illuminance[1], 0);
      for (const int size : {2, 3, 4, 40})
        for (const Outcome& rank : solveOn(size, s, goOn))
        {
          EXPECT_EQ(rank.error, "");
          EXPECT_EQ(rank.result.illuminance, one.illuminance) << size << " ranks";
          EXPECT_EQ(rank.result.standardError, one.standardError);
          EXPECT_EQ(rank.result.direct, one.direct);
          EXPECT_EQ(rank.result.largestScoreShare, one.largestScoreShare);
          EXPECT_EQ(rank.result.trusted, one.trusted);
          EXPECT_EQ(rank.result.trajectories, one.trajectories);
          ASSERT_EQ(rank.result.audit.size(), one.audit.size() + 1);  // the line on the ranks
          for (std::size_t i = 0; i < one.audit.size(); ++i)
            EXPECT_EQ(rank.result.audit[i].choice, one.audit[i].choice);
        }
    }
}

TEST(Ranks, EveryReplicateHasOneOwner)
{
  for (const int size : {1, 2, 3, 4, 7, 32, 1000})
  {
    Meeting meeting(size);
    const ThreadRank ranks(meeting, 0);
    EXPECT_EQ(ranks.firstReplicate(0, 32), 0);
    EXPECT_EQ(ranks.firstReplicate(size, 32), 32);
    for (int rank = 0; rank < size; ++rank)
    {
      const int count = ranks.firstReplicate(rank + 1, 32) - ranks.firstReplicate(rank, 32);
      EXPECT_GE(count, 32 / size);
      EXPECT_LE(count, (32 + size - 1) / size);
    }
  }
}

TEST(Ranks, StopTogetherWhenOneIsAskedTo)
{
  Settings s;
  s.threads = 1;
  s.relativeError = 1e-6;
  const std::vector<Outcome> outcomes = solveOn(3, s, [](int rank, double f) { return rank != 1 || f == 0; });
  for (const Outcome& rank : outcomes)
  {
    EXPECT_EQ(rank.error, "");
    EXPECT_TRUE(rank.result.aborted);
    EXPECT_GT(rank.result.trajectories, 0);
    EXPECT_EQ(rank.result.illuminance, outcomes[0].result.illuminance);
  }
}

TEST(Ranks, FailTogetherWhenOneFails)
{
  Settings s;
  s.threads = 1;
  s.relativeError = 1e-6;
  const std::vector<Outcome> outcomes = solveOn(3, s, [](int rank, double) -> bool {
    if (rank == 2)
      throw std::runtime_error("out of memory");
    return true;
  });
  EXPECT_EQ(outcomes[2].error, "out of memory");
  for (const int rank : {0, 1})
    EXPECT_EQ(outcomes[rank].error, "rank 2 of 3: failed; its own message says why");
}
