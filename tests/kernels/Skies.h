// SPDX-License-Identifier: BSD-3-Clause
// Rooms under a sky for the tests of kernels, and the integrals to hold them against.
#ifndef kalos_tests_Skies_h
#define kalos_tests_Skies_h

#include "Rooms.h"
#include "sky/Sky.h"

namespace skies
{
using namespace kalos;

inline std::shared_ptr<const Sky> cie(int type, double illuminance = 10000, double ground = 0, Vec3 sun = {0, 0.5, 0},
                                      double sunIlluminance = 0)
{
  SkyDescription d;
  sun.z = std::sqrt(1 - dot(sun, sun));
  d.pattern = type == 16 ? makeTraditionalOvercast() : makeSky(cieSky(type), sun);
  d.horizontalIlluminance = illuminance;
  d.groundReflectance = ground;
  d.sun = sun;
  d.sunIlluminance = sunIlluminance;
  return std::make_shared<const Sky>(d);
}

/// The room [0, 4] x [0, 4] x [0, 3] with a hole in the ceiling, [low, high]^2.
inline SceneDescription skylitRoom(double rho, double low = 1.5, double high = 2.5)
{
  SceneDescription room;
  room.materials.resize(1);
  room.materials[0].reflectance = uniformBands(rho);
  rooms::addQuad(room, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0);
  rooms::addQuad(room, {0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 0);
  rooms::addQuad(room, {0, 4, 0}, {4, 0, 0}, {0, 0, 3}, 0);
  rooms::addQuad(room, {0, 0, 0}, {0, 4, 0}, {0, 0, 3}, 0);
  rooms::addQuad(room, {4, 0, 0}, {0, 4, 0}, {0, 0, 3}, 0);
  rooms::addQuad(room, {0, 0, 3}, {4, 0, 0}, {0, low, 0}, 0);
  rooms::addQuad(room, {0, high, 3}, {4, 0, 0}, {0, 4 - high, 0}, 0);
  rooms::addQuad(room, {0, low, 3}, {low, 0, 0}, {0, high - low, 0}, 0);
  rooms::addQuad(room, {high, low, 3}, {4 - high, 0, 0}, {0, high - low, 0}, 0);
  return room;
}

/// The integral of L cos over a rectangular opening seen from p with normal n, lx: midpoints of n x n cells.
inline double throughOpening(const Sky& sky, const Vec3& p, const Vec3& n, const Vec3& corner, const Vec3& u,
                             const Vec3& v, int cells = 400)
{
  const Vec3 across = cross(u, v);
  double sum = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
    {
      const Vec3 d = corner + ((i + 0.5) / cells) * u + ((j + 0.5) / cells) * v - p;
      const double d2 = dot(d, d);
      const Vec3 way = (1 / std::sqrt(d2)) * d;
      sum += sky.luminance(way) * std::max(0.0, dot(way, n)) * std::abs(dot(way, across)) / d2 / cells / cells;
    }
  return sum;
}
}  // namespace skies

#endif
