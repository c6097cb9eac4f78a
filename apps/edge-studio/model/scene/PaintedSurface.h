// SPDX-License-Identifier: BSD-3-Clause
// Divides surfaces into the cells that are computed and painted.
#ifndef studio_PaintedSurface_h
#define studio_PaintedSurface_h

#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
struct PaintedSurface
{
  vtkSmartPointer<vtkPolyData> receivers;  ///< triangles with cell normals and the material arrays of the surfaces
  vtkSmartPointer<vtkPolyData> shape;      ///< triangles to draw; the receivers themselves where they are not too many
  vtkSmartPointer<vtkIdList> standIns;     ///< for each triangle of the shape its receiver; null: the same
};

/// `cells` triangles and about twice as many more that are small along singular edges. A mesh that has more than
/// `cells` keeps its own, the large ones cut; where these are more than four times as many, one (the largest) stands
/// for those of its material that are near it and face the same of the six directions of the axes.
PaintedSurface paintedSurface(vtkPolyData* surfaces, int cells = 4000);
}  // namespace studio

#endif
