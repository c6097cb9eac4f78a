// SPDX-License-Identifier: BSD-3-Clause
// From VTK's surfaces and luminaires to the kernels' scene.
#ifndef SceneConversion_h
#define SceneConversion_h

#include "scene/Scene.h"

class vtkDataObject;
class vtkPolyData;

/// Surfaces are joined (SurfaceJoining.h) and triangulated; cell arrays become materials. `luminaires` may be null.
/// Throws std::invalid_argument, naming the array and the cell or point, for missing arrays and values out of range.
kalos::SceneDescription MakeSceneDescription(vtkDataObject* surfaces, vtkPolyData* luminaires);

#endif
