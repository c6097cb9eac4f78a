// SPDX-License-Identifier: BSD-3-Clause
// Also known as: many-light sampling; importance sampling of light sources (light sampler).
//
// Chooses a luminaire where many shine, in proportion to a cheap approximation of its light at the sensor.
//
// The stand-in of a point is its intensity or, for a measured one, a bound of it (photometry/CandelaBound.h), times
// cos / d^2: no angle, no table of candela. A rectangle that is not near is the point in its middle, but shines as soon
// as any of it is above the horizon. So the stand-in is positive wherever light may come from, and sampling by it is
// unbiased. Vector code (Highway) gives the same bits on every instruction set. On an AMD EPYC (AVX2) it takes 4 to 5
// ns for each measured luminaire; a look-up in its table takes 100 ns.
#ifndef kalos_estimator_direct_LightSampler_h
#define kalos_estimator_direct_LightSampler_h

#include "estimator/kernel/Sensor.h"

namespace kalos
{
/// One weight per luminaire, and a draw in proportion to them.
class LuminaireWeights
{
public:
  static constexpr int lanes = 16;  ///< luminaires that are weighed side by side

  std::vector<float> weight;  ///< >= 0; filled up with zeros to whole groups of `lanes`

  /// Call when all weights are set.
  void sum();
  double total() const { return this->Total; }
  double share(std::size_t i) const { return static_cast<double>(this->weight[i]) / this->Total; }
  /// Drawn in proportion to the weights, for u in [0,1); only when total() > 0.
  std::size_t draw(double u) const;

private:
  double Lane[lanes] = {}, Total = 0;
};

class LightSampler
{
public:
  explicit LightSampler(const Scene& scene);

  /// Stand-ins for the unshadowed illuminance of the luminaires at the sensor, lx. Negative for
  /// rectangles and openings that are near, or nearly so: the caller must weigh these by their true size. Returns
  /// whether there are any.
  bool weigh(const Sensor& sensor, LuminaireWeights& weights) const;

private:
  struct Lamps
  {
    std::vector<float> x, y, z;                      // m
    std::vector<float> px, py, pz;                   // unit: photometric axis, or pole of the table
    std::vector<float> zx, zy, zz;                   // unit, to the table's plane 0
    std::vector<float> radius;                       // m, what it reaches beyond its position
    std::vector<float> near2;                        // m2, squared distance below which it is near; 0: never
    std::vector<float> isotropic, cosine, measured;  // cd: constant, times cos(gamma), times the bound's value
    std::vector<std::int32_t> bound;                 // where its bound begins
  };

  void add(const Luminaire& luminaire, double leastRadius);
  std::int32_t boundOf(const Luminaire& luminaire);

  Lamps All;
  std::size_t Count = 0;
  std::vector<float> Bounds;
  std::vector<const CandelaTable*> Tables;  // one per bound
};
}  // namespace kalos

#endif
