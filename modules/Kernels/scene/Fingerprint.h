// SPDX-License-Identifier: BSD-3-Clause
// A 64-bit hash of scenes and bytes.
#ifndef kalos_scene_Fingerprint_h
#define kalos_scene_Fingerprint_h

#include "sampling/Random.h"
#include "scene/Scene.h"

namespace kalos
{
/// Collects values into 64 bits; two different collections agree with a probability of 2^-64.
class Fingerprint
{
public:
  void add(std::uint64_t word) { this->State = mixBits(this->State + 0x9e3779b97f4a7c15ull) ^ mixBits(word + 1); }
  void add(double value);
  void add(const Vec3& v);
  void add(const void* bytes, std::size_t size);
  void add(const SceneDescription& scene);

  std::uint64_t value() const { return mixBits(this->State); }

private:
  std::uint64_t State = 0;
};
}  // namespace kalos

#endif
