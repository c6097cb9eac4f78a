// SPDX-License-Identifier: BSD-3-Clause
// Polygons cut into triangles: the areas are those of the shapes, holes stay open, sides stay.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/Triangulation.h"

namespace
{
using kalos::meshing::Point;

/// The signed area along z of what covers the polygon.
double coveredArea(const std::vector<Point>& corners)
{
  const auto triangles = kalos::meshing::triangulate(corners);
  EXPECT_TRUE(triangles.has_value());
  double area = 0.0;
  for (const auto& [a, b, c] : triangles.value_or(std::vector<std::array<std::uint32_t, 3>>()))
    area += cross(corners[b] - corners[a], corners[c] - corners[a])[2] / 2.0;
  return area;
}

std::vector<Point> flat(std::initializer_list<std::array<double, 2>> points)
{
  std::vector<Point> corners;
  for (const auto& p : points)
    corners.push_back({p[0], p[1], 1.0});
  return corners;
}
}  // namespace

/// A wall of 4 x 3 m with a window of 2 x 1 m that a bridge joins to the outline, as exporters write it.
TEST(Triangulation, AWindowStaysOpen)
{
  std::vector<Point> wall = flat({{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {3, 2}, {3, 1}, {1, 1}});
  EXPECT_FALSE(kalos::meshing::isConvex(wall));
  EXPECT_NEAR(coveredArea(wall), 10.0, 1e-12);
  std::reverse(wall.begin(), wall.end());
  EXPECT_NEAR(coveredArea(wall), -10.0, 1e-12);
}

/// The hole runs the way of the outline: inside is still what is gone around an odd number of times.
TEST(Triangulation, AHoleThatTurnsTheSameWayStaysOpen)
{
  EXPECT_NEAR(coveredArea(flat({{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}, {1, 1}, {3, 1}, {3, 2}, {1, 2}, {1, 1}})), 10.0,
              1e-12);
}

TEST(Triangulation, TwoWindowsAndACornerOnAnEdge)
{
  const auto wall = flat({{0, 0},
                          {5, 0},
                          {10, 0},
                          {10, 3},
                          {0, 3},
                          {0, 0},
                          {1, 1},
                          {1, 2},
                          {2, 2},
                          {2, 1},
                          {1, 1},
                          {0, 0},
                          {5, 0},
                          {6, 1},
                          {6, 2},
                          {8, 2},
                          {8, 1},
                          {6, 1},
                          {5, 0}});
  EXPECT_NEAR(coveredArea(wall), 27.0, 1e-12);
}

/// Combs with teeth as narrow as a micrometre, which VTK's ear cutting took for a crossing.
TEST(Triangulation, ConcaveOutlinesDoNotCross)
{
  for (const double width : {0.5, 1e-3, 1e-6})
  {
    std::vector<Point> comb{{0, 0, 0}};
    for (int i = 0; i < 40; ++i)
    {
      comb.push_back({i + width, 0, 0});
      comb.push_back({i + width, -3, 0});
      comb.push_back({i + 1.0, -3, 0});
      comb.push_back({i + 1.0, 0, 0});
    }
    comb.push_back({40, 2, 0});
    comb.push_back({0, 2, 0});
    EXPECT_NEAR(coveredArea(comb), 80.0 + 40.0 * (1.0 - width) * 3.0, 1e-9);
  }
}

/// In any place of space: the vector area is that of the outline.
TEST(Triangulation, TurnedAndFarAway)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto wall =
      flat({{0, 0}, {4, 0}, {4, 3}, {2, 1.5}, {0, 3}, {0, 0}, {1, 0.5}, {1, 1}, {2, 1}, {2, 0.5}, {1, 0.5}});
  for (int i = 0; i < 50; ++i)
  {
    const Point u = kalos::meshing::unit({uniform(random), uniform(random), uniform(random)});
    const Point v = kalos::meshing::unit(cross(u, Point{uniform(random), uniform(random), uniform(random)}));
    const Point origin = 1e3 * Point{uniform(random), uniform(random), uniform(random)};
    std::vector<Point> corners;
    for (const Point& p : wall)
      corners.push_back(origin + p[0] * u + p[1] * v);
    const auto triangles = kalos::meshing::triangulate(corners);
    ASSERT_TRUE(triangles.has_value());
    Point area{0.0, 0.0, 0.0};
    for (const auto& [a, b, c] : *triangles)
      area = area + 0.5 * cross(corners[b] - corners[a], corners[c] - corners[a]);
    EXPECT_NEAR(norm(area - 8.5 * cross(u, v)), 0.0, 1e-8);
  }
}

TEST(Triangulation, ACrossingIsTold)
{
  EXPECT_FALSE(kalos::meshing::triangulate(flat({{0, 0}, {1, 1}, {1, 0}, {0, 2}})).has_value());
  EXPECT_TRUE(kalos::meshing::isConvex(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})));
}
