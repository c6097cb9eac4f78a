// SPDX-License-Identifier: BSD-3-Clause
// Triangles of large meshes: cut where they are large, one for many where they are small.
#ifndef studio_Triangles_h
#define studio_Triangles_h

#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// The total area, m2.
double areaOf(vtkPolyData* triangles);

/// Gives `to`, cell by cell, the cell data of these cells of `from`.
void copyCellData(vtkPolyData* from, vtkIdList* cells, vtkPolyData* to);

/// The triangles, halved at their longest edge until none is longer than `longest` m, with their cell data.
vtkSmartPointer<vtkPolyData> cutLong(vtkPolyData* triangles, double longest);

/// Which of the six directions of the axes a cell's normal is nearest to, 0 to 5.
int facing(vtkDataArray* normals, vtkIdType cell);

/// For each triangle the one that stands for it, itself or another: the largest of those in its cube of side `cube` m
/// that have its reflectance and face the same way. The triangles have cell normals.
vtkSmartPointer<vtkIdList> largestNearby(vtkPolyData* triangles, double cube);
}  // namespace studio

#endif
