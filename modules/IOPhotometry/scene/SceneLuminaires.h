// SPDX-License-Identifier: BSD-3-Clause
/** The "luminaires" of a scene file. */
#ifndef KalosSceneLuminaires_h
#define KalosSceneLuminaires_h

#include "SceneJson.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * All luminaires in one, as vtkKalosLuminaireSource makes them; photometric files are looked for below `folder`. Field
 * data: the candela tables, and PhotometryWarnings.
 */
vtkSmartPointer<vtkPolyData> ReadLuminaires(const Node& scene, const std::string& folder);
}  // namespace kalos::scene

#endif
