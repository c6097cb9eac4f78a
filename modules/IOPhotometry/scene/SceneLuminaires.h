// SPDX-License-Identifier: BSD-3-Clause
/** The "luminaires" of a scene file. */
#ifndef KalosSceneLuminaires_h
#define KalosSceneLuminaires_h

#include "../base/JsonCursor.h"
#include "../model/ModelLuminaire.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * All luminaires in one, as vtkKalosLuminaireSource makes them; photometric files are looked for below `folder`. Field
 * data: the candela tables, and PhotometryWarnings. `lights` of models follow, except those that the scene overrides
 * by name; parallel ones cover the sphere `lit`. Files that lie elsewhere are added to `notes` (FilePaths.h).
 */
vtkSmartPointer<vtkPolyData> readLuminaires(const JsonCursor& scene, const std::string& folder,
                                            const std::vector<ModelLight>& lights, const Ball& lit, Notes& notes);
}  // namespace kalos::scene

#endif
