// SPDX-License-Identifier: BSD-3-Clause
// Methods that take the singularity out of the kernel by altering it near the receiver.
#ifndef kalos_estimator_KernelAlteration_h
#define kalos_estimator_KernelAlteration_h

#include <memory>
#include <string>

#include "estimator/Sensor.h"
#include "estimator/Settings.h"
#include "sampling/Random.h"

namespace kalos
{
class KernelAlteration
{
public:
  virtual ~KernelAlteration() = default;

  /// Vertices farther than this from the receiver (m) keep the plain kernel.
  virtual double reach(std::size_t receiver) const = 0;

  /// The kernel (1/m2) to score instead of `plain` for a vertex y of normal n nearer than reach(). Visibility is that
  /// between the receiver and y for every method: a neighbourhood reaches through walls, the receiver does not.
  virtual double kernel(std::size_t receiver, const Sensor& sensor, const Vec3& y, const Vec3& n, double plain,
                        RandomStream& random) const = 0;

  /// One line for the audit.
  virtual std::string describe() const = 0;
};

/// delta and epsilon of the settings with automatic ones filled in. Throws std::invalid_argument for lengths that are
/// negative or larger than the scene.
struct Neighbourhood
{
  double delta, epsilon;  ///< m
};
Neighbourhood neighbourhood(const Scene& scene, const Settings& settings);

/// Null for the methods that keep the plain kernel.
std::unique_ptr<KernelAlteration> makeAlteration(const Scene& scene, const Receivers& receivers,
                                                 const Settings& settings);
}  // namespace kalos

#endif
