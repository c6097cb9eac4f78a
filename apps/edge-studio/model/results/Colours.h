// SPDX-License-Identifier: BSD-3-Clause
// Colour tables for pictures and legends.
#ifndef studio_Colours_h
#define studio_Colours_h

#include <QStringList>
#include <array>

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// Keys of the maps for values from dark to bright; the first is that of vtkKalosFalseColor.
QStringList colourMaps();

/// The colours of a map over a range.
vtkSmartPointer<vtkLookupTable> falseColours(const std::array<double, 2>& range, bool logarithmic,
                                             const QString& map = colourMaps().front());

/// Blue over white to red, for differences from -limit to limit.
vtkSmartPointer<vtkLookupTable> differenceColours(double limit);

/// From faint to vivid cyan for the severity of edges, 0.01 to 10 on a logarithmic scale (0.25 at right angles).
vtkSmartPointer<vtkLookupTable> severityColours();
}  // namespace studio

#endif
