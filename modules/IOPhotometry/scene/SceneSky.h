// SPDX-License-Identifier: BSD-3-Clause
/** The sections `sky`, `north_deg` and `ground` of a scene file. */
#ifndef KalosSceneSky_h
#define KalosSceneSky_h

#include <string>

#include "../base/FilePaths.h"
#include "../base/JsonCursor.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace kalos::scene
{
/** The luminaires with the scene's sky, or as they are where there is none. */
vtkSmartPointer<vtkPolyData> addSky(const JsonCursor& scene, const std::string& folder, vtkPolyData* luminaires,
                                    Notes& notes);
}  // namespace kalos::scene

#endif
