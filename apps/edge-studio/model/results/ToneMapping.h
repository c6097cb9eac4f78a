// SPDX-License-Identifier: BSD-3-Clause
// From luminance to a photograph: Reinhard, Stark, Shirley, Ferwerda, Photographic tone reproduction for digital
// images, 2002, the global operator, equations (1) to (4).
#ifndef studio_ToneMapping_h
#define studio_ToneMapping_h

#include <array>

#include "results/Display.h"
#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// The exposure of a photograph, in the unit of the values.
struct Exposure
{
  double average = 1;  ///< logarithmic average, which becomes a middle grey of 18 %
  double white = 10;   ///< the least value that is white
};

/// The logarithmic average of the values above 0 of all shown sets, and the upper end of rangeOf().
Exposure exposureOf(const QVector<ResultPtr>& results, const Display& display);

/// Light that the display sends out for a luminance, [0, 1].
double toneMapped(double luminance, const Exposure& exposure);

/// A linear share of light as sRGB encodes it, [0, 1].
double encoded(double light);

/// Greys for values of four decades up to white.
vtkSmartPointer<vtkLookupTable> photographicGreys(const Exposure& exposure);

/// sRGB, 0 to 255, of linear Rec. 709 bands in the unit of the exposure: the hue stays, the luminance is tone-mapped.
std::array<unsigned char, 3> photographicColour(const double bands[3], const Exposure& exposure);
}  // namespace studio

#endif
