// SPDX-License-Identifier: BSD-3-Clause
// Surfaces cut into cells that are receivers and get painted: small along singular edges, larger elsewhere.
#ifndef studio_PaintedSurface_h
#define studio_PaintedSurface_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// About `cells` triangles with cell normals and the material arrays of `surfaces`. Meshes of more triangles than that,
/// and meshes that can not be remeshed, keep their own.
vtkSmartPointer<vtkPolyData> paintedSurface(vtkPolyData* surfaces, int cells = 4000);
}  // namespace studio

#endif
