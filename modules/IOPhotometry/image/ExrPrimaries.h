// SPDX-License-Identifier: BSD-3-Clause
/** The primaries of an OpenEXR image. */
#ifndef KalosExrPrimaries_h
#define KalosExrPrimaries_h

#include <OpenEXR/ImfHeader.h>

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

namespace kalos
{
/** From the attribute chromaticities; Rec. 709 without it. */
struct ExrPrimaries
{
  bool isRec709 = true;
  double luminance[3] = {0.2126, 0.7152, 0.0722};  ///< Y of each
  double toRec709[3][3] = {};  ///< matrix to linear Rec. 709, without white adaptation, so that Y is kept
};

ExrPrimaries primariesOf(const Imf::Header& header);

/** Converts three-component colours from these primaries to linear Rec. 709. */
void toRec709(vtkFloatArray* bands, const ExrPrimaries& primaries);

/** The array Luminance of colours in these primaries. */
vtkSmartPointer<vtkFloatArray> luminanceOf(vtkFloatArray* bands, const ExrPrimaries& primaries);
}  // namespace kalos

#endif
