// SPDX-License-Identifier: BSD-3-Clause
// Also known as: bounding the weak singularity of virtual point lights.
//
// Methods that remove the kernel's singularity by changing it near the receiver.
#ifndef kalos_estimator_kernel_KernelRegularization_h
#define kalos_estimator_kernel_KernelRegularization_h

#include <memory>
#include <string>

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/kernel/Sensor.h"
#include "sampling/Random.h"

namespace kalos
{
class KernelRegularization
{
public:
  virtual ~KernelRegularization() = default;

  /// Vertices farther than this from the receiver (m) keep the plain kernel.
  virtual double reach(std::size_t receiver) const = 0;

  /// The kernel (1/m2) to score instead of `plain` for a vertex y of normal n nearer than reach(). Every method uses
  /// the visibility between the receiver and y, because a neighbourhood may reach through walls.
  virtual double kernel(std::size_t receiver, const Sensor& sensor, const Vec3& y, const Vec3& n, double plain,
                        RandomStream& random) const = 0;

  /// One line for the audit.
  virtual std::string describe() const = 0;
};

/// The lengths of a neighbourhood, m.
struct Neighbourhood
{
  double delta, epsilon;
};

/// delta and epsilon of the settings; 0 is replaced by the automatic value for `vertices` per m2.
///
/// The rule. At distance h from a concave right angle the plain estimate has relative variance 1/(6 pi h^2 n) for n
/// vertices per m2 (E3). Averaging with radius epsilon below delta = epsilon/0.6 keeps it near 1/(6 pi epsilon^2 n)
/// there, so that over a strip of width w along the edge the mean variance is about 2.3/(6 pi n w epsilon); the bias at
/// the edge, a share b of the illuminance over a depth epsilon, adds b^2 epsilon/w. The sum is least at epsilon =
/// 0.35/(b sqrt(n)); with b = 1/4, half of what the other wall sends, epsilon = 1.4/sqrt(n): 1.4 times the mean
/// distance of vertices.
///
/// Throws std::invalid_argument for lengths that are negative, not a number or larger than the scene.
Neighbourhood neighbourhood(const Scene& scene, const Settings& settings, double vertices);
}  // namespace kalos

#endif
