// SPDX-License-Identifier: BSD-3-Clause
// Singular edges as lines to draw: contacts apart, and in dashes.
#ifndef studio_EdgeLines_h
#define studio_EdgeLines_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
struct EdgeLines
{
  vtkSmartPointer<vtkPolyData> edges, contacts;  ///< with the cell array Severity
};

/// `dash` in m. Edges whose sides do not see each other are left out.
EdgeLines edgeLines(vtkPolyData* singularEdges, double dash);
}  // namespace studio

#endif
