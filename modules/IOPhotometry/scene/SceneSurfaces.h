// SPDX-License-Identifier: BSD-3-Clause
/** The "surfaces" of a scene file. */
#ifndef KalosSceneSurfaces_h
#define KalosSceneSurfaces_h

#include <string>
#include <vector>

#include "../base/JsonCursor.h"
#include "../mesh/Mesh.h"
#include "../model/Model.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
struct Surface
{
  std::string name;
  std::string where;  ///< for messages
  Mesh polygons;
};

/** The "surfaces" of a scene, and what else the models among them bring. */
struct SceneSurfaces
{
  std::vector<Surface> all;
  std::vector<ModelLight> lights;
  std::vector<Camera> cameras;
  Notes approximations;
  bool hasModel = false;  ///< a file without a name of its own: its parts, lights and cameras keep theirs
};

/** Read the array "surfaces"; `folder` is that of the scene file. */
SceneSurfaces readSurfaces(const JsonCursor& scene, const Materials& materials, const std::string& folder);

/** All surfaces in one, with the cell arrays of vtkKalosArrayNames.h; materials of 1 band are spread over all bands. */
vtkSmartPointer<vtkPolyData> makeSurfaceData(const std::vector<Surface>& surfaces);
}  // namespace kalos::scene

#endif
