// SPDX-License-Identifier: BSD-3-Clause
// Repair, singular edges and remeshing against the number of triangles. Goals: repair and edges of 10^6 triangles in 60
// s and 3 GB, growing no faster than n log n; a 5 m room at 5 cm in 10 s.
//
//     build/bin/MeshingBenchmarks
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>

#include "Solids.h"
#include "remesh/SurfaceRemesh.h"
#include "repair/SurfaceRepair.h"
#include "singular/SingularEdges.h"

using namespace kalos::meshing;

namespace
{
/// A soup of about n triangles: a room with 100 turned boxes in stacks of two, every face in squares.
TriangleMesh furnished(double n)
{
  TriangleMesh mesh;
  const int squares = std::max(1, static_cast<int>(std::lround(std::sqrt(n / (101 * 12)))));
  solids::addBox(mesh, {0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 4}, true, squares);
  for (int i = 0; i < 100; ++i)
  {
    const double x = 3 + 6 * (i % 5), y = 1.5 + 3 * (i / 5 % 10), angle = 0.37 * i;
    solids::addTurnedBox(mesh, {x, y, i < 50 ? 0.0 : 1.0}, {1.2, 0.8, 1}, angle, squares);
  }
  return mesh;
}

double peakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void RepairAndSingularEdges(benchmark::State& state)
{
  std::size_t triangles = 0, curves = 0;
  for (auto _ : state)
  {
    TriangleMesh mesh = furnished(static_cast<double>(state.range(0)));
    triangles = mesh.triangles.size();
    repair(mesh, {});
    curves = findSingularEdges(mesh, {}).curves.size();
  }
  state.SetComplexityN(static_cast<std::int64_t>(triangles));
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["curves"] = static_cast<double>(curves);
  state.counters["peak_MB"] = peakMegabytes();
}

void SingularEdgesOnly(benchmark::State& state)
{
  const TriangleMesh mesh = furnished(static_cast<double>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(findSingularEdges(mesh, {}));
  state.SetComplexityN(static_cast<std::int64_t>(mesh.triangles.size()));
}

void RemeshRoom(benchmark::State& state)
{
  for (auto _ : state)
  {
    TriangleMesh mesh;
    solids::addBox(mesh, {0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}, true);
    repair(mesh, {});
    RemeshSettings settings;
    settings.edgeLength = 0.05;
    const RemeshReport report = remesh(mesh, settings);
    state.counters["triangles"] = static_cast<double>(report.trianglesAfter);
    state.counters["smallest_degrees"] = report.minimumAngle * 180 / 3.14159265358979;
  }
}
}  // namespace

BENCHMARK(RepairAndSingularEdges)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(SingularEdgesOnly)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(RemeshRoom)->Unit(benchmark::kSecond)->Iterations(1);
