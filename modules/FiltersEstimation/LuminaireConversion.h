// SPDX-License-Identifier: BSD-3-Clause
/// From the luminaires of the data model to those of the kernels.
#ifndef LuminaireConversion_h
#define LuminaireConversion_h

#include "scene/Scene.h"

class vtkPolyData;

/// Adds the luminaires. Throws std::invalid_argument, naming the array and the luminaire.
void AddLuminaires(vtkPolyData* luminaires, kalos::SceneDescription& scene);

#endif
