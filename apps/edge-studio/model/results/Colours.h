// SPDX-License-Identifier: BSD-3-Clause
// Colour tables for pictures and legends.
#ifndef studio_Colours_h
#define studio_Colours_h

#include <array>

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// The colours of vtkKalosFalseColor over a range.
vtkSmartPointer<vtkLookupTable> falseColours(const std::array<double, 2>& range, bool logarithmic);

/// Blue over white to red, for differences from -limit to limit.
vtkSmartPointer<vtkLookupTable> differenceColours(double limit);

/// From faint to vivid cyan for the severity of edges, 0.01 to 10 on a logarithmic scale (0.25 at right angles).
vtkSmartPointer<vtkLookupTable> severityColours();
}  // namespace studio

#endif
