// SPDX-License-Identifier: BSD-3-Clause
// Scenes moved, turned, scaled and mirrored: whatever is done to a scene and its receivers together changes no value,
// but for the square of the scale.
#ifndef kalos_tests_Poses_h
#define kalos_tests_Poses_h

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Solver.h"
#include "sampling/Random.h"
#include "statistics/Replicates.h"

namespace poses
{
using namespace kalos;

/// x -> scale R x + shift; R a rotation, or with `mirror` one after a reflection at x = 0.
struct Pose
{
  Frame axes{{0, 0, 1}};
  double scale = 1;
  Vec3 shift{};
  bool mirror = false;

  Vec3 turned(const Vec3& v) const { return this->axes.toWorld({this->mirror ? -v.x : v.x, v.y, v.z}); }
  Vec3 operator()(const Vec3& p) const { return this->scale * this->turned(p) + this->shift; }
};

inline Vec3 randomDirection(RandomStream& random)
{
  const double z = 2 * random.next() - 1, phi = 2 * pi * random.next(), r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A rotation drawn by `number`, about no axis in particular.
inline Frame randomAxes(std::uint64_t number)
{
  RandomStream random(number, 0, Purpose::Selection, 0);
  Frame axes(randomDirection(random));
  const double angle = 2 * pi * random.next();
  const Vec3 s = std::cos(angle) * axes.s + std::sin(angle) * axes.t;
  axes.t = cross(axes.n, s);
  axes.s = s;
  return axes;
}

/// Ten rotations about the middle of the furnished room, of which half are mirrored, each with another scale and
/// another place.
inline std::vector<Pose> tenPoses()
{
  const Vec3 middle{2.5, 2.5, 2.5};
  std::vector<Pose> all;
  const double scales[] = {1, 1e-3, 1e3, 1, 30, 0.02, 1, 300, 1, 0.5};
  const double away[] = {0, 0.1, 1000, 1e6, 0, 0.1, 1000, 1e6, 1, 0};
  for (std::uint64_t i = 0; i < 10; ++i)
  {
    Pose pose;
    pose.axes = randomAxes(i + 1);
    pose.mirror = i % 2;
    pose.scale = scales[i];
    RandomStream random(100 + i, 0, Purpose::Selection, 0);
    pose.shift = away[i] * randomDirection(random) - pose.scale * pose.turned(middle);
    all.push_back(pose);
  }
  return all;
}

/// Averages of independent solves: of each receiver, and of all of them, with the error that they share.
class Average
{
public:
  void add(const Result& one, double factor)
  {
    const auto replicates = static_cast<std::size_t>(one.replicates), receivers = one.illuminance.size();
    this->Values.resize(receivers);
    this->Squares.resize(receivers);
    std::vector<double> means(replicates);
    const std::size_t count = one.replicateIlluminance.size();
    for (std::size_t i = 0; i < count; ++i)
      means[i % replicates] += factor * one.replicateIlluminance[i] * one.replicates / static_cast<double>(count);
    this->Last = summarise(means.data(), means.size());
    this->Sum += this->Last.mean;
    this->SquareSum += this->Last.standardError * this->Last.standardError;
    for (std::size_t r = 0; r < receivers; ++r)
    {
      this->Values[r] += factor * one.illuminance[r];
      this->Squares[r] += factor * factor * one.standardError[r] * one.standardError[r];
    }
    ++this->Count;
    this->Freedom += one.replicates - 1;
  }

  int freedom() const { return this->Freedom; }  ///< of the averages
  const MeanAndError& last() const { return this->Last; }
  MeanAndError mean() const { return {this->Sum / this->Count, std::sqrt(this->SquareSum) / this->Count}; }
  MeanAndError at(std::size_t r) const
  {
    return {this->Values[r] / this->Count, std::sqrt(this->Squares[r]) / this->Count};
  }
  std::size_t size() const { return this->Values.size(); }

private:
  std::vector<double> Values, Squares;
  double Sum = 0, SquareSum = 0;
  MeanAndError Last;
  int Count = 0, Freedom = 0;
};

/// In standard errors of the difference.
inline double apart(const MeanAndError& a, const MeanAndError& b)
{
  return std::abs(a.mean - b.mean) / (std::hypot(a.standardError, b.standardError) + 1e-300);
}

inline SceneDescription posed(SceneDescription d, const Pose& pose)
{
  for (Vec3& p : d.points)
    p = pose(p);
  for (Triangle& t : d.triangles)
    if (pose.mirror)
      std::swap(t[1], t[2]);  // normals stay on their side
  for (Luminaire& l : d.luminaires)
  {
    l.position = pose(l.position);
    l.axis = pose.turned(l.axis);
    l.up = pose.turned(l.up);
    l.sideU = pose.scale * pose.turned(l.sideU);
    l.sideV = pose.scale * pose.turned(l.sideV);
  }
  return d;
}

inline Receivers posed(Receivers r, const Pose& pose)
{
  for (Vec3& p : r.points)
    p = pose(p);
  for (Vec3& n : r.normals)
    n = pose.turned(n);
  return r;
}

inline Camera posed(Camera c, const Pose& pose)
{
  c.position = pose(c.position);
  c.target = pose(c.target);
  c.up = pose.turned(c.up);
  return c;
}

/// Every triangle in four.
inline SceneDescription finer(SceneDescription d)
{
  const std::vector<Triangle> coarse = d.triangles;
  const std::vector<std::uint32_t> material = d.triangleMaterial;
  d.triangles.clear();
  d.triangleMaterial.clear();
  for (std::size_t i = 0; i < coarse.size(); ++i)
  {
    std::uint32_t middle[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      middle[k] = static_cast<std::uint32_t>(d.points.size());
      d.points.push_back(0.5 * (d.points[coarse[i][k]] + d.points[coarse[i][(k + 1) % 3]]));
    }
    const auto [a, b, c] = coarse[i];
    for (const Triangle& t : {Triangle{a, middle[0], middle[2]}, Triangle{middle[0], b, middle[1]},
                              Triangle{middle[2], middle[1], c}, Triangle{middle[0], middle[1], middle[2]}})
      d.triangles.push_back(t);
    d.triangleMaterial.insert(d.triangleMaterial.end(), 4, material[i]);
  }
  return d;
}

/// A black speck outside, so that the centre of coordinates lies at `centre` instead of in the middle of the room.
inline void recentre(SceneDescription& d, const Vec3& centre, const Vec3& low, const Vec3& high)
{
  const auto black = rooms::addMaterial(d, 0);
  for (const Vec3& corner : {low, high})
  {
    const Vec3 across = 2 * centre - corner;
    rooms::addQuad(d, across, {1e-4, 0, 0}, {0, 1e-4, 0}, black);
  }
}

/// A quad about `centre` across the unit vector n.
inline void addPanel(SceneDescription& d, const Vec3& centre, const Vec3& n, double side, std::uint32_t material)
{
  const Frame f(n);
  rooms::addQuad(d, centre - 0.5 * side * (f.s + f.t), side * f.s, side * f.t, material);
}

/// The furnished room with a turned box, a tilted panel in the middle and a second lamp.
inline SceneDescription tiltedRoom(double reflectance)
{
  SceneDescription d = rooms::furnishedRoom(reflectance);
  addPanel(d, {2.5, 2.5, 2.5}, normalized({0.61, 0.47, 0.64}), 0.6, 0);
  addPanel(d, {2.45, 2.55, 2.2}, normalized({-0.3, 0.7, 0.4}), 0.4, 0);
  addPanel(d, {4.2, 0.8, 1.5}, normalized({0.5, -0.6, 0.7}), 0.8, 0);
  Luminaire lamp;
  lamp.position = {3.2, 3.0, 3.3};
  lamp.axis = normalized(Vec3{2.5, 2.5, 2.5} - lamp.position);
  lamp.flux = 4000;
  d.luminaires.push_back(lamp);
  return d;
}

/// Eighteen of its receivers: in the air, on the floor, on walls, on a box, on a panel and two centimetres off edges.
inline Receivers tiltedReceivers()
{
  Receivers r;
  auto add = [&](const Vec3& p, const Vec3& n) {
    r.points.push_back(p);
    r.normals.push_back(n);
  };
  const Vec3 panel = normalized({0.61, 0.47, 0.64});
  for (const double x : {0.4, 2.4, 4.6})
  {
    add({x, 0.7, 0}, {0, 0, 1});
    add({x, 3.1, 0.8}, normalized({0.1, 0.2, 1}));
    add({0, x, 2.2}, {1, 0, 0});
    add({x, 5, 4.1}, {0, -1, 0});
  }
  add({1.7, 1.7, 1.5}, {0, 0, 1});
  add({2.5, 2.5, 2.5}, panel);
  add({2.5, 2.5, 2.5}, -panel);
  add({3.4, 3, 3}, {0, 0, 1});
  add({0.02, 2, 0}, {0, 0, 1});
  add({2.22, 1.7, 0}, {0, 0, 1});
  return r;
}
}  // namespace poses

#endif
