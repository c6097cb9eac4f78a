// SPDX-License-Identifier: BSD-3-Clause
// Luminaires as what one looks for: where they are, how large, and where their light goes.
#ifndef studio_LuminaireGlyphs_h
#define studio_LuminaireGlyphs_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// Photometric solids, the distance from the luminaire in each direction being in proportion to the intensity, `size` m
/// at the largest; for tables that are not about the photometric axis an arrow along it. Rectangles have their outline
/// too.
vtkSmartPointer<vtkPolyData> luminaireGlyphs(vtkPolyData* luminaires, double size);
}  // namespace studio

#endif
