// SPDX-License-Identifier: BSD-3-Clause
// From the field data of VTK's luminaires to the kernels' sky.
#ifndef SkyConversion_h
#define SkyConversion_h

#include <memory>

namespace kalos
{
class Sky;
}
class vtkPolyData;

/// Null without the field data array Sky. Throws std::invalid_argument for an array of another length, and for values
/// out of range.
std::shared_ptr<const kalos::Sky> MakeSky(vtkPolyData* luminaires);

#endif
