// SPDX-License-Identifier: BSD-3-Clause
// Local estimation against the ray tracer's own rate for the same shadow rays, in the furnace room with two boxes.
// `ratio` is (seconds of the bare rays) / (seconds of the estimate), both taken here in turn; `speedup` is one thread's
// time over two threads'.
#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "estimator/kernel/PairKernel.h"
#include "estimator/solve/Solver.h"
#include "estimator/tracing/Trajectories.h"

using namespace kalos;

namespace
{
Receivers floorGrid(int side)
{
  Receivers r;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
    {
      r.points.push_back({5 * (i + 0.5) / side, 5 * (j + 0.5) / side, 0.75});
      r.normals.push_back({0, 0, 1});
    }
  return r;
}

double seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The same rays, formed beforehand in full packets, and nothing else.
struct BareRays
{
  std::vector<SegmentPacket> packets;

  BareRays(const Scene& scene, const Receivers& receivers, int trajectories)
  {
    const VertexSet v = traceTrajectories(scene, Emission(scene), {}, 0, 0, trajectories).reflected;
    int lane = 0;
    PairBlock block;
    for (std::size_t i = 0; i < receivers.points.size(); ++i)
    {
      const Sensor r(placeReceiver(scene, receivers.points[i] - scene.origin(), receivers.normals[i]));
      for (std::size_t begin = 0; begin < v.size(); begin += PairBlock::capacity)
      {
        formPairs(v, begin, static_cast<int>(std::min<std::size_t>(PairBlock::capacity, v.size() - begin)), r, 0,
                  block);
        for (int k = 0; k < block.count; ++k, lane = (lane + 1) % SegmentPacket::width)
        {
          if (lane == 0)
            packets.emplace_back();
          packets.back().set(lane, r.anchor, v.anchor(static_cast<std::size_t>(block.index[k])));
        }
      }
    }
  }

  void trace(const RayScene& rays) const
  {
    for (const SegmentPacket& p : this->packets)
      benchmark::DoNotOptimize(rays.occluded(p, SegmentPacket::width));
  }
};

void LocalEstimationAgainstBareRays(benchmark::State& state)
{
  const Scene scene(rooms::furnishedRoom(0.6));
  const Receivers receivers = floorGrid(32);
  Settings s;
  s.method = Method::Local;
  s.trajectories = 3200;
  s.threads = 1;
  const BareRays bare(scene, receivers, static_cast<int>(s.trajectories));
  double rays = 0, estimate = 0;
  for (auto _ : state)
  {
    rays += seconds([&] { bare.trace(scene.rays()); });
    estimate += seconds([&] { solve(scene, receivers, s); });
  }
  state.counters["ratio"] = rays / estimate;
  state.counters["Mrays/s"] = 1e-6 * 16 * bare.packets.size() * state.iterations() / rays;
}
BENCHMARK(LocalEstimationAgainstBareRays)->Unit(benchmark::kMillisecond)->Iterations(8);

void LocalEstimationOnTwoThreads(benchmark::State& state)
{
  const Scene scene(rooms::furnishedRoom(0.6));
  const Receivers receivers = floorGrid(32);
  Settings s;
  s.method = Method::Local;
  s.trajectories = 6400;
  double one = 0, two = 0;
  for (auto _ : state)
  {
    s.threads = 1;
    one += seconds([&] { solve(scene, receivers, s); });
    s.threads = 2;
    two += seconds([&] { solve(scene, receivers, s); });
  }
  state.counters["speedup"] = one / two;
}
BENCHMARK(LocalEstimationOnTwoThreads)->Unit(benchmark::kMillisecond)->Iterations(8);

void UnshadowedPairs(benchmark::State& state)
{
  const Scene scene(rooms::furnishedRoom(0.6));
  const Receivers receivers = floorGrid(16);
  const VertexSet v = traceTrajectories(scene, Emission(scene), {}, 0, 0, 3200).reflected;
  TileScores scores;
  std::size_t pairs = 0;
  for (auto _ : state)
    for (std::size_t i = 0; i < receivers.points.size(); ++i)
    {
      const Sensor r(placeReceiver(scene, receivers.points[i] - scene.origin(), receivers.normals[i]));
      for (std::size_t begin = 0; begin + VertexTile::capacity <= v.size(); begin += VertexTile::capacity)
      {
        scoreTile({v, begin, VertexTile::capacity}, r, 0.01, scores);
        benchmark::DoNotOptimize(scores.reached[0]);
        pairs += VertexTile::capacity;
      }
    }
  state.counters["pairs/s"] = benchmark::Counter(static_cast<double>(pairs), benchmark::Counter::kIsRate);
}
BENCHMARK(UnshadowedPairs)->Unit(benchmark::kMillisecond);
}  // namespace
