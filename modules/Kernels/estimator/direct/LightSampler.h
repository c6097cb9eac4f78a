// SPDX-License-Identifier: BSD-3-Clause
// Which luminaire to ask, where many shine: drawn by a cheap stand-in for what each sends.
//
// The stand-in of a point is its intensity or, for a measured one, a bound of it (photometry/CandelaBound.h), times
// cos / d^2: no angle, no table of candela. A rectangle that is not near is the point in its middle, but shines as soon
// as any of it is above the horizon. So the stand-in is positive wherever light may come from, and what is drawn by it
// and weighed by the chance of that is unbiased. Vector code (Highway) of the same bits on every instruction set: on an
// AMD EPYC (AVX2) 4 to 5 ns for each measured luminaire, beside 100 for a look-up in its table.
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

  /// To be called when all weights are known.
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

  /// Stand-ins for the illuminance that luminaires would give at the sensor, lx, were nothing in between. Negative for
  /// rectangles and openings that are near, or nearly so: these must be weighed by their true size. Returns whether
  /// there are such.
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
