// SPDX-License-Identifier: BSD-3-Clause
// Repair, singular edges and remeshing against the number of triangles: processor time, its growth as a power of the
// number, and memory, beside the goals. Repair and edges of 10^6 triangles in 60 s and 3 GB, growing no faster than
// n log n, which over this range is a power of 1.09; a 5 m room at 5 cm in 10 s. Exit status 1 when a goal is missed.
//
//     build/bin/MeshingBenchmarks
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <ctime>

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

template <typename Work>
double cpuSeconds(const Work& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Exponent of the power law through points of (number, seconds), by least squares of the logarithms.
class Growth
{
public:
  void add(double n, double seconds)
  {
    const double x = std::log(n), y = std::log(seconds);
    count_ += 1;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  double exponent() const { return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_); }

private:
  double count_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

bool goal(const char* what, double value, double limit, const char* unit)
{
  std::printf("  %-46s %8.3g %-3s goal %g %s: %s\n", what, value, unit, limit, unit, value <= limit ? "met" : "MISSED");
  return value <= limit;
}
}  // namespace

int main()
{
  std::printf("  triangles   repair (s)   edges (s)   edges/(n ln n) (ns)   curves   peak (MB)\n");
  Growth growth;
  double seconds = 0;
  for (const double wanted : {1e4, 1e5, 1e6})
  {
    TriangleMesh mesh = furnished(wanted);
    const auto n = static_cast<double>(mesh.triangles.size());
    std::size_t curves = 0;
    const double repairing = cpuSeconds([&] { repair(mesh, {}); });
    const double finding = cpuSeconds([&] { curves = findSingularEdges(mesh, {}).curves.size(); });
    growth.add(n, finding);
    seconds = repairing + finding;
    std::printf("  %9.0f   %10.3f   %9.3f   %19.1f   %6zu   %9.0f\n", n, repairing, finding,
                1e9 * finding / (n * std::log(n)), curves, peakMegabytes());
  }
  bool met = goal("repair and edges of 10^6 triangles", seconds, 60, "s");
  met &= goal("memory", peakMegabytes() / 1024, 3, "GB");
  met &= goal("power of n that edge finding grows with", growth.exponent(), 1.15, "");

  TriangleMesh room;
  solids::addBox(room, {0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}, true);
  repair(room, {});
  RemeshSettings settings;
  settings.edgeLength = 0.05;
  RemeshReport report;
  met &= goal("a room of 5 m remeshed at 5 cm", cpuSeconds([&] { report = remesh(room, settings); }), 10, "s");
  std::printf("  %zu triangles, smallest angle %.1f degrees\n", report.trianglesAfter,
              report.minimumAngle * 180 / 3.14159265358979);
  return met ? 0 : 1;
}
