// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "singular/Contacts.h"
#include "singular/EdgeAngles.h"
#include "singular/MeshEdges.h"

namespace kalos::meshing
{
namespace
{
/// Where one triangle meets the plane of the other: a piece of the common line, and the sides on which it lies.
struct Trace
{
  Point ends[2];
  bool above = false, below = false;
};

/// Corners within `distance` of the plane count as lying in it. False without a piece of some length.
bool trace(const Point corners[3], const Point& origin, const Point& normal, double distance, Trace& result)
{
  double height[3];
  for (int i = 0; i < 3; ++i)
  {
    height[i] = dot(corners[i] - origin, normal);
    if (std::abs(height[i]) <= distance)
      height[i] = 0.0;
    result.above |= height[i] > 0.0;
    result.below |= height[i] < 0.0;
  }
  int found = 0;
  for (int i = 0; i < 3 && found < 2; ++i)
  {
    if (height[i] == 0.0)
      result.ends[found++] = corners[i];
  }
  for (int i = 0; i < 3 && found < 2; ++i)
  {
    const int j = (i + 1) % 3;
    if (height[i] * height[j] < 0.0)
      result.ends[found++] = corners[i] + (height[i] / (height[i] - height[j])) * (corners[j] - corners[i]);
  }
  return found == 2 && (result.above || result.below);
}

Point atParameter(const Trace& trace, const double parameters[2], double t)
{
  const double span = parameters[1] - parameters[0];
  return trace.ends[0] + ((t - parameters[0]) / span) * (trace.ends[1] - trace.ends[0]);
}

void addSheets(const Trace& trace, const Point& axis, const Point& normal, const Point& otherNormal,
               std::vector<Sheet>& sheets)
{
  Point outwards = cross(axis, normal);
  if (dot(outwards, otherNormal) < 0.0)
    outwards = -1.0 * outwards;
  if (trace.above)
    sheets.push_back({outwards, normal});
  if (trace.below)
    sheets.push_back({-1.0 * outwards, normal});
}
}  // namespace

bool intersect(const TriangleMesh& mesh, const Triangle& a, const Triangle& b, double distance,
               const EdgeSettings& settings, Segment& piece)
{
  int common = 0;
  for (const std::uint32_t corner : a)
    common += std::find(b.begin(), b.end(), corner) != b.end();
  if (common > 1)
    return false;

  const Point cornersOfA[3] = {mesh.points[a[0]], mesh.points[a[1]], mesh.points[a[2]]};
  const Point cornersOfB[3] = {mesh.points[b[0]], mesh.points[b[1]], mesh.points[b[2]]};
  const Point normalOfA = unit(doubledArea(mesh, a)), normalOfB = unit(doubledArea(mesh, b));
  const Point line = cross(normalOfA, normalOfB);
  if (norm(line) < std::sin(settings.flat))
    return false;
  const Point axis = unit(line);

  // The piece of the common line that each has, and their overlap.
  Trace ofA, ofB;
  if (!trace(cornersOfA, cornersOfB[0], normalOfB, distance, ofA) ||
      !trace(cornersOfB, cornersOfA[0], normalOfA, distance, ofB))
    return false;
  double inA[2], inB[2];
  for (int i = 0; i < 2; ++i)
  {
    inA[i] = dot(axis, ofA.ends[i] - cornersOfA[0]);
    inB[i] = dot(axis, ofB.ends[i] - cornersOfA[0]);
  }
  const double start = std::max(std::min(inA[0], inA[1]), std::min(inB[0], inB[1]));
  const double end = std::min(std::max(inA[0], inA[1]), std::max(inB[0], inB[1]));
  if (end - start <= 2.0 * distance)
    return false;
  // Nearly parallel triangles can overlap along the line and yet lie apart from each other.
  piece.start = atParameter(ofA, inA, start);
  piece.end = atParameter(ofA, inA, end);
  if (norm(piece.start - atParameter(ofB, inB, start)) > 4.0 * distance ||
      norm(piece.end - atParameter(ofB, inB, end)) > 4.0 * distance)
    return false;

  // Corners that count as lying in a plane may be a little off: put the ends where the planes meet, if they do so
  // clearly.
  const double cosine = dot(normalOfA, normalOfB), squaredSine = dot(line, line);
  for (Point* tip : {&piece.start, &piece.end})
  {
    const double ofPlaneA = dot(*tip - cornersOfA[0], normalOfA), ofPlaneB = dot(*tip - cornersOfB[0], normalOfB);
    if (squaredSine > 0.01)
      *tip = *tip - (((ofPlaneA - cosine * ofPlaneB) / squaredSine) * normalOfA +
                     ((ofPlaneB - cosine * ofPlaneA) / squaredSine) * normalOfB);
  }

  std::vector<Sheet> sheets;
  sheets.reserve(4);
  addSheets(ofA, axis, normalOfA, normalOfB, sheets);
  addSheets(ofB, axis, normalOfB, normalOfA, sheets);
  const EdgeAngles angles = measureAngles(axis, sheets, settings.flat);
  piece.edge = {EdgeClass::Contact, angles.front, angles.back, 0.0};
  classify(piece.edge, settings);
  return piece.edge.severity > 0.0;
}
}  // namespace kalos::meshing
