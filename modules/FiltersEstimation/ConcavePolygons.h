// SPDX-License-Identifier: BSD-3-Clause
/** Concave polygons, and those with holes, as triangles: VTK's own triangulation fills the holes. */
#ifndef KalosConcavePolygons_h
#define KalosConcavePolygons_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/**
 * `input`, or if it has concave polygons a copy with these cut into triangles in their place, each with the cell data
 * of its polygon. Throws std::invalid_argument for a polygon that crosses itself.
 */
vtkSmartPointer<vtkPolyData> CutConcavePolygons(vtkPolyData* input);

#endif
