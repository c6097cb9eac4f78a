// SPDX-License-Identifier: BSD-3-Clause
/** What red, green and blue of an OpenEXR image are. */
#ifndef KalosExrPrimaries_h
#define KalosExrPrimaries_h

#include <OpenEXR/ImfHeader.h>

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

namespace kalos
{
/** By the attribute chromaticities, Rec. 709 without it. */
struct ExrPrimaries
{
  bool isRec709 = true;
  double luminance[3] = {0.2126, 0.7152, 0.0722};  ///< Y of each
  double toRec709[3][3] = {};  ///< rows that make linear Rec. 709; without adaptation to the white, so that Y stays
};

ExrPrimaries primariesOf(const Imf::Header& header);

/** Colours in these primaries, three components, become linear Rec. 709. */
void toRec709(vtkFloatArray* bands, const ExrPrimaries& primaries);

/** The array Luminance of colours in these primaries. */
vtkSmartPointer<vtkFloatArray> luminanceOf(vtkFloatArray* bands, const ExrPrimaries& primaries);
}  // namespace kalos

#endif
