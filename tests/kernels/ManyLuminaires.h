// SPDX-License-Identifier: BSD-3-Clause
// A room with luminaires of all kinds.
#ifndef kalos_tests_ManyLuminaires_h
#define kalos_tests_ManyLuminaires_h

#include "Rooms.h"
#include "sampling/Random.h"
#include "sampling/Warp.h"

namespace kalos
{
// Intensities that differ from entry to entry, some of them 0.
inline std::shared_ptr<const CandelaTable> roughTable(CandelaTable::Pole pole, double firstPlane, double lastPlane,
                                                      double lastAngle)
{
  std::vector<double> planes, angles, candela;
  for (int p = 0; p <= 12; ++p)
    planes.push_back(firstPlane + p / 12.0 * (lastPlane - firstPlane));
  for (int a = 0; a <= 18; ++a)
    angles.push_back(a / 18.0 * lastAngle);
  for (int p = 0; p <= 12; ++p)
    for (int a = 0; a <= 18; ++a)
      candela.push_back((p % 12 * 7 + a * 5) % 11 < 3 ? 0 : 10 + (p % 12 * 5 + a * 3) % 13);
  return std::make_shared<CandelaTable>(planes, angles, candela, pole);
}

// As of a downlight: cos(gamma) below the axis, wider across than along.
inline std::shared_ptr<const CandelaTable> smoothTable()
{
  std::vector<double> planes, angles, candela;
  for (int p = 0; p <= 24; ++p)
    planes.push_back(15 * p);
  for (int a = 0; a <= 36; ++a)
    angles.push_back(2.5 * a);
  for (const double p : planes)
    for (const double a : angles)
      candela.push_back(std::max(0.0, std::cos(a * pi / 180)) *
                        (1 + 0.3 * std::pow(std::sin(a * pi / 180), 2) * std::cos(p * pi / 90)));
  return std::make_shared<CandelaTable>(planes, angles, candela, CandelaTable::Pole::Axis);
}

inline Vec3 randomVector(RandomStream& random, double scale)
{
  const double x = random.next(), y = random.next();
  return scale * Vec3{x, y, random.next()};
}

inline Luminaire lamp(RandomStream& random, Distribution distribution)
{
  Luminaire l;
  l.position = randomVector(random, 5);
  const double u = random.next();
  l.axis = uniformSphere(u, random.next());
  l.up = Frame(l.axis).s;
  l.flux = 100 + 900 * random.next();
  l.distribution = distribution;
  return l;
}

// Points of all kinds, rectangles, openings: `count` of each.
inline SceneDescription lit(int count)
{
  SceneDescription scene;
  rooms::addBox(scene, {0, 0, 0}, {5, 5, 5}, rooms::addMaterial(scene, 0), true);
  const std::shared_ptr<const CandelaTable> tables[] = {
      smoothTable(), roughTable(CandelaTable::Pole::Axis, 0, 360, 180),
      roughTable(CandelaTable::Pole::Axis, -30, 230, 130), roughTable(CandelaTable::Pole::Side, -90, 90, 180)};
  RandomStream random(11, 0, Purpose::Trajectory, 0);
  for (int i = 0; i < count; ++i)
  {
    scene.luminaires.push_back(lamp(random, Distribution::Isotropic));
    scene.luminaires.push_back(lamp(random, Distribution::Lambertian));
    for (const auto& table : tables)
    {
      scene.luminaires.push_back(lamp(random, Distribution::Measured));
      scene.luminaires.back().table = table;
    }
    for (const Distribution distribution : {Distribution::Lambertian, Distribution::Measured})
    {
      Luminaire l = lamp(random, distribution);
      l.sideU = 0.4 * l.up;
      l.sideV = 0.3 * cross(l.axis, l.up);
      l.table = tables[0];
      scene.luminaires.push_back(l);
    }
  }
  return scene;
}
}  // namespace kalos

#endif
