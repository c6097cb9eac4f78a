// SPDX-License-Identifier: BSD-3-Clause
// Point luminaires seen in plane mirrors. A gather ray cannot hit a point, but its mirror images have a closed form.
#ifndef kalos_estimator_direct_MirrorImages_h
#define kalos_estimator_direct_MirrorImages_h

#include <vector>

#include "estimator/kernel/Sensor.h"

namespace kalos
{
/// E = m1 m2 .. I(omega) cos(theta) V / d^2 for every point luminaire and every chain of plane mirrors in which the
/// sensor sees it, d being the way over the mirrors. Chains are followed until their mirrors reflect less than
/// `leastReflectance` in all, or until there are `mostImages` (many planes that face each other, or a curved mirror of
/// many triangles; first reflections are never left out); the audit says what is left out. Trajectories handle light
/// that reaches the sensor after a diffuse reflection; they follow any number of mirrors.
class MirrorImages
{
public:
  explicit MirrorImages(const Scene& scene);

  bool any() const { return !this->Images.empty(); }
  std::size_t size() const { return this->Images.size(); }

  /// Largest product of the reflectances of a chain that is left out; 0: none is.
  double leftOut() const { return this->LeftOut; }

  /// Whether chains are left out because there are too many of them, not because they are dim: values are too low then,
  /// by an amount that nobody knows.
  bool truncated() const { return this->Truncated; }

  /// Illuminance, or weighted by the response of a glossy sensor, lx per band; shadows of the whole way included.
  Bands illuminance(const Sensor& sensor) const;

  static constexpr double leastReflectance = 1e-4;
  static constexpr std::size_t mostImages = 4096;

private:
  struct Plane
  {
    Vec3 point, normal;
    std::vector<std::uint32_t> triangles;
    double reflectance;  // the largest of them
  };
  struct Image
  {
    std::size_t luminaire;
    std::size_t plane;  // that makes it
    int parent;         // index of the image that it reflects; -1: the luminaire itself
    Vec3 position;
    double reflectance;  // of the whole chain, at most
  };
  void findPlanes();
  void addImage(std::size_t luminaire, std::size_t plane, int parent);
  // What a ray along `direction` meets at p; null: p is beside the mirror, or another face covers it there.
  const std::uint32_t* triangleAt(const Plane& plane, const Vec3& p, const Vec3& direction) const;
  bool covers(std::uint32_t triangle, const Vec3& p) const;
  double follow(const Image& image, const Sensor& sensor) const;  // m1 m2 .. I V

  const Scene& Scene_;
  std::vector<Plane> Planes;
  std::vector<Image> Images;
  double LeftOut = 0;
  bool Truncated = false;
};
}  // namespace kalos

#endif
