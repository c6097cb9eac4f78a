// SPDX-License-Identifier: BSD-3-Clause
// Whether the illuminance in a scene is known in closed form.
#ifndef studio_Furnace_h
#define studio_Furnace_h

#include <optional>

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

namespace studio
{
/// The illuminance at every surface point of a white furnace, E = M0/(1 - rho), lx: a closed scene without luminaires,
/// of one reflectance and one exitance, whose fronts see nothing but fronts. Nothing where this does not hold.
std::optional<double> furnaceIlluminance(vtkPolyData* surfaces, vtkPolyData* luminaires);

/// Whether a closed surface has its fronts outside: rays from its backs meet only backs.
bool facesOutward(vtkPolyData* surfaces);

/// The same surfaces with front and back exchanged.
vtkSmartPointer<vtkPolyData> turned(vtkPolyData* surfaces);

/// Output 0 of vtkKalosSingularEdges; the receivers, if there are any, get its array EdgeDistance.
vtkSmartPointer<vtkPolyData> singularEdges(vtkPolyData* surfaces, bool borders,
                                           vtkMultiBlockDataSet* receivers = nullptr);
}  // namespace studio

#endif
