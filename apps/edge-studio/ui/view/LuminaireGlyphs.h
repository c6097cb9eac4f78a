// SPDX-License-Identifier: BSD-3-Clause
// Shows luminaires: their positions, sizes, and photometric solids.
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
