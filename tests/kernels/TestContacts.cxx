// SPDX-License-Identifier: BSD-3-Clause
// Contacts, gaps, seams and thin walls from a nanometre on: what leaks, what is darkened wrongly, and the light there.
#include <gtest/gtest.h>

#include "Poses.h"
#include "Student.h"
#include "sampling/Warp.h"
#include "scene/Placement.h"
#include "scene/RayBatch.h"

using namespace poses;

namespace
{
constexpr double heights[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};

// A room of 4 m x 4 m x 3 m with a box of 1 m, `gap` above the floor.
SceneDescription roomWithBox(double gap)
{
  SceneDescription d;
  const auto grey = rooms::addMaterial(d, 0.6);
  rooms::addBox(d, {0, 0, 0}, {4, 4, 3}, grey, true);
  rooms::addBox(d, {2, 2, gap}, {1, 1, 1}, grey, false);
  Luminaire lamp;
  lamp.position = {1.2, 1.3, 2.9};
  lamp.flux = 5000;
  d.luminaires.push_back(lamp);
  return d;
}

// Pairs of a receiver and a place on a surface, of which it is known whether they see each other.
class Pairs
{
public:
  Pairs(const SceneDescription& d, const Pose& pose) : Posed(pose), Lit(posed(d, pose)) {}

  void expect(bool visible, const Vec3& p, const Vec3& n, const Vec3& target, const Vec3& facing)
  {
    const RayAnchor from = this->place(p, n), to = this->place(target, facing);
    std::vector<ShadowRay> ray{{from, to, isInGap(this->Lit, from)}};
    shadowTogether(this->Lit.rays(), ray);
    const bool hidden = ray[0].hidden, alone = this->Lit.rays().occluded(from, to);
    (visible ? this->Open : this->Closed) += 1;
    (visible ? this->Darkened : this->Leaked) += visible ? hidden || alone : !(hidden && alone);
  }

  void report(const char* what, double size) const
  {
    std::printf("%s, %g m: %d of %d leak, %d of %d are darkened\n", what, size, this->Leaked, this->Closed,
                this->Darkened, this->Open);
    EXPECT_EQ(this->Leaked, 0) << what << ", " << size << " m";
    EXPECT_EQ(this->Darkened, 0) << what << ", " << size << " m";
    EXPECT_GE(this->Open + this->Closed, 800);
  }

private:
  RayAnchor place(const Vec3& p, const Vec3& n) const
  {
    return placeReceiver(this->Lit, this->Posed(p) - this->Lit.origin(), this->Posed.turned(n));
  }

  Pose Posed;
  Scene Lit;
  int Open = 0, Closed = 0, Leaked = 0, Darkened = 0;
};

class EachPose : public testing::TestWithParam<std::uint64_t>
{
protected:
  Pose pose() const
  {
    Pose pose;
    pose.axes = GetParam() > 0 ? randomAxes(GetParam()) : pose.axes;
    if (GetParam() > 2)
      pose.shift = {1000, -300, 20};
    return pose;
  }
  RandomStream random{GetParam(), 0, Purpose::Selection, 0};
  double between(double low, double high) { return low + (high - low) * this->random.next(); }
};
}  // namespace

// From the side of the box and from the floor before it all of that half of the room is seen; from the floor in the box
// nothing of it.
TEST_P(EachPose, NothingIsDarkenedAtTheFootOfABox)
{
  for (const double h : heights)
  {
    Pairs pairs(roomWithBox(0), this->pose());
    for (int i = 0; i < 400; ++i)
    {
      const double y = this->between(2.1, 2.9);
      const Vec3 wall{0, this->between(0.1, 3.9), this->between(0.1, 2.9)};
      const Vec3 ceiling{this->between(0.1, 1.8), this->between(0.1, 3.9), 3};
      pairs.expect(true, {2, y, h}, {-1, 0, 0}, wall, {1, 0, 0});
      pairs.expect(true, {2, y, h}, {-1, 0, 0}, ceiling, {0, 0, -1});
      pairs.expect(true, {2 - h, y, 0}, {0, 0, 1}, wall, {1, 0, 0});
      if (h < 1e-6)  // on the box's side, to the rounding of coordinates
        continue;
      pairs.expect(false, {2 + h, y, 0}, {0, 0, 1}, wall, {1, 0, 0});
      pairs.expect(false, {2 + h, y, 0}, {0, 0, 1}, ceiling, {0, 0, -1});
    }
    pairs.report("foot", h);
  }
}

// Below a box that floats: light gets to the floor there through the gap alone.
TEST_P(EachPose, GapsLetThroughWhatIsInThem)
{
  for (const double gap : heights)
  {
    Pairs pairs(roomWithBox(gap), this->pose());
    for (int i = 0; i < 400; ++i)
    {
      const Vec3 below{this->between(2.2, 2.8), this->between(2.3, 2.7), 0};
      const double slope = gap / (below.x - 2);  // of the ray that just leaves the gap
      pairs.expect(false, below, {0, 0, 1}, {0, below.y, std::max(0.1, 3 * slope * below.x)}, {1, 0, 0});
      pairs.expect(false, below, {0, 0, 1}, {this->between(0, 4), this->between(0, 4), 3}, {0, 0, -1});
      if (gap >= 1e-5)  // faces nearer than single precision can tell lie in one place
        pairs.expect(true, below, {0, 0, 1}, {0, below.y, this->between(0.3, 0.7) * slope * below.x}, {1, 0, 0});
    }
    pairs.report("gap", gap);
  }
}

// A floor of two parts, side by side: what lies on one is hidden by neither.
TEST_P(EachPose, CoplanarNeighboursHideNothing)
{
  SceneDescription d;
  const auto grey = rooms::addMaterial(d, 0.6), white = rooms::addMaterial(d, 0.9);
  rooms::addBox(d, {0, 0, 0}, {4, 4, 3}, grey, true);
  d.triangles.erase(d.triangles.begin(), d.triangles.begin() + 2);
  d.triangleMaterial.resize(d.triangles.size());
  rooms::addQuad(d, {0, 0, 0}, {1.7, 0, 0}, {0, 4, 0}, grey);
  rooms::addQuad(d, {1.7, 0, 0}, {2.3, 0, 0}, {0, 4, 0}, white);
  for (const double h : heights)
  {
    Pairs pairs(d, this->pose());
    for (int i = 0; i < 600; ++i)
    {
      const Vec3 wall{4 * std::round(this->random.next()), this->between(0.1, 3.9), this->between(1e-3, 2.9)};
      const Vec3 facing{wall.x > 0 ? -1.0 : 1.0, 0, 0};
      pairs.expect(true, {1.7 - h, this->between(0.1, 3.9), 0}, {0, 0, 1}, wall, facing);
      pairs.expect(true, {1.7 + h, this->between(0.1, 3.9), 0}, {0, 0, 1}, wall, facing);
      pairs.expect(true, {1.7, this->between(0.1, 3.9), 0}, {0, 0, 1}, wall, facing);
    }
    pairs.report("neighbours", h);
  }
}

// A wall of two faces: nothing gets through, and before it nothing is darkened.
TEST_P(EachPose, ThinWallsStopLight)
{
  for (const double thickness : heights)
  {
    SceneDescription d = rooms::litRoom(0.5);
    rooms::addQuad(d, {2.4, 0, 0}, {0, 0, 5}, {0, 5, 0}, 0);
    rooms::addQuad(d, {2.4 + thickness, 0, 0}, {0, 5, 0}, {0, 0, 5}, 0);
    Pairs pairs(d, this->pose());
    for (int i = 0; i < 400; ++i)
    {
      const Vec3 left{0, this->between(0.1, 4.9), this->between(0.1, 4.9)}, right{5, left.z, left.y};
      const Vec3 on{2.4, this->between(0.1, 4.9), this->between(0.1, 4.9)}, behind{2.4 + thickness, on.y, on.z};
      pairs.expect(false, left, {1, 0, 0}, right, {-1, 0, 0});
      pairs.expect(true, on, {-1, 0, 0}, left, {1, 0, 0});
      pairs.expect(true, behind, {1, 0, 0}, right, {-1, 0, 0});
    }
    pairs.report("wall", thickness);
  }
}

INSTANTIATE_TEST_SUITE_P(Contacts, EachPose, testing::Range<std::uint64_t>(0, 4));

namespace
{
// A path tracer for the room with the box standing in it, by slabs in double precision: no triangle, no lift.
class PathsInTheRoom
{
public:
  // lx on the side of the box at height h: direct light, and the mean over paths with its error.
  MeanAndError sideOfTheBox(double h, int paths)
  {
    const Vec3 p{2, 2.5, h}, n{-1, 0, 0};
    double sum = 0, squares = 0;
    for (int i = 0; i < paths; ++i)
    {
      const double found = this->gathered(p, n);
      sum += found;
      squares += found * found;
    }
    const double mean = sum / paths;
    return {this->lampAt(p, n) + mean, std::sqrt((squares / paths - mean * mean) / paths)};
  }

private:
  static constexpr double reflectance = 0.6;
  RandomStream Random{5, 0, Purpose::Selection, 0};

  static double at(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
  static Vec3 along(int axis, double s) { return {axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0}; }

  // Distance to the box from outside, and the axis of the side that is met; infinite: none.
  static double toBox(const Vec3& o, const Vec3& d, int& axis)
  {
    constexpr double low[] = {2, 2, 0}, high[] = {3, 3, 1};
    double in = 0, out = 1e30;
    axis = -1;
    for (int k = 0; k < 3; ++k)
    {
      double a = (low[k] - at(o, k)) / at(d, k), b = (high[k] - at(o, k)) / at(d, k);
      if (a > b)
        std::swap(a, b);
      if (a > in)
      {
        in = a;
        axis = k;
      }
      out = std::min(out, b);
    }
    return axis >= 0 && in < out ? in : 1e30;
  }

  static double toWalls(const Vec3& o, const Vec3& d, int& axis)
  {
    constexpr double size[] = {4, 4, 3};
    double nearest = 1e30;
    for (int k = 0; k < 3; ++k)
    {
      const double there = ((at(d, k) > 0 ? size[k] : 0) - at(o, k)) / at(d, k);
      if (at(d, k) != 0 && there < nearest)
      {
        nearest = there;
        axis = k;
      }
    }
    return nearest;
  }

  static double lampAt(const Vec3& p, const Vec3& n)
  {
    const Vec3 d = Vec3{1.2, 1.3, 2.9} - p;
    const double square = dot(d, d);
    int axis;
    if (!(dot(d, n) > 0) || !(d.z > 0) || toBox(p, d, axis) < 1)
      return 0;
    return 5000 / pi * d.z * dot(d, n) / (square * square);
  }

  double gathered(Vec3 p, Vec3 n)
  {
    double sum = 0, weight = 1;
    for (;;)
    {
      const double u = this->Random.next(), v = this->Random.next();
      const Vec3 d = Frame(n).toWorld(cosineHemisphere(u, v));
      int wall = 0, side = 0;
      const double far = toWalls(p, d, wall), near = toBox(p, d, side);
      const int axis = near < far ? side : wall;
      p = p + std::min(near, far) * d;
      n = along(axis, at(d, axis) > 0 ? -1.0 : 1.0);
      weight *= reflectance;
      sum += weight * lampAt(p, n);
      if (this->Random.next() >= reflectance)
        return sum;
      weight /= reflectance;
    }
  }
};
}  // namespace

// The foot of the box, from a nanometre to a millimetre above the floor, by the default method and by final gathering:
// 7 degrees of freedom, 14 values.
TEST(Contacts, TheFootIsAsBrightAsPathsSay)
{
  const MeanAndError truth = PathsInTheRoom().sideOfTheBox(1e-6, 1 << 20);
  EXPECT_LT(truth.standardError, 0.003 * truth.mean);
  Receivers r;
  for (const double h : heights)
  {
    r.points.push_back({2, 2.5, h});
    r.normals.push_back({-1, 0, 0});
  }
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    Settings s;
    s.method = method;
    s.trajectories = 65536;
    const Result result = solve(Scene(roomWithBox(0)), r, s);
    for (std::size_t i = 0; i < r.points.size(); ++i)
    {
      EXPECT_LT(std::abs(result.illuminance[i] - truth.mean),
                allowed(result, 14) * std::hypot(result.standardError[i], truth.standardError))
          << heights[i] << " m: " << result.illuminance[i];
      EXPECT_LT(result.standardError[i], 0.01 * truth.mean) << heights[i] << " m";
    }
    std::printf("foot: %.2f +- %.2f lx by paths, %.2f +- %.2f at a nanometre\n", truth.mean, truth.standardError,
                result.illuminance[0], result.standardError[0]);
  }
}
