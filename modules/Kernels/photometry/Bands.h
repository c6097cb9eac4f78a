// SPDX-License-Identifier: BSD-3-Clause
// Photometric quantities per band.
//
// One band is photometric. Three bands are linear Rec. 709 red, green and blue. Any other number n is n bands of equal
// luminous share. A band value is scaled so that a neutral quantity has the same value in every band: 1000 lm of white
// light are 1000 in each band, and the photometric total is the weighted mean of the bands.
//
// Units used throughout: luminous flux lm, intensity cd, illuminance lx, exitance lm/m2, luminance cd/m2, lengths m.
#ifndef kalos_photometry_Bands_h
#define kalos_photometry_Bands_h

#include <array>
#include <cstddef>

namespace kalos
{
constexpr int maxBands = 16;

/// One value per band; only the first Scene::bands() entries mean anything.
using Bands = std::array<double, maxBands>;

/// Luminous share of band b of n; the shares of the n bands sum to 1.
inline double bandShare(int b, int n)
{
  constexpr double rec709[3] = {0.2126, 0.7152, 0.0722};
  return n == 3 ? rec709[b] : 1.0 / n;
}

/// Photometric total of n bands, in the unit of the bands.
inline double photometric(const double* bands, int n)
{
  double sum = 0;
  for (int b = 0; b < n; ++b)
    sum += bandShare(b, n) * bands[b];
  return sum;
}
inline double photometric(const Bands& bands, int n)
{
  return photometric(bands.data(), n);
}

inline Bands uniformBands(double value)
{
  Bands bands;
  bands.fill(value);
  return bands;
}
}  // namespace kalos

#endif
