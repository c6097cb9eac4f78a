// SPDX-License-Identifier: BSD-3-Clause
/** Cameras, receivers and notes that a scene takes from its models. */
#ifndef KalosModelScene_h
#define KalosModelScene_h

#include <set>
#include <string>
#include <vector>

#include "../model/ModelLuminaire.h"
#include "SceneSurfaces.h"
#include "vtkMultiBlockDataSet.h"

namespace kalos::scene
{
/** Adds the cameras of models except those that the scene overrides by name; `names` as for the receivers. */
void addModelCameras(const std::vector<Camera>& found, std::set<std::string>& names, std::vector<Camera>& cameras);

/**
 * Receivers for a model that says nothing of them: "workplane" (see WorkPlane.h) on the grid of EN 12464-1, or where no
 * such plane fits "surfaces", all surfaces in triangles no longer than a twentieth of the model. A note says which.
 */
void addUsualReceivers(SceneSurfaces& surfaces, std::set<std::string>& names, vtkMultiBlockDataSet* receivers);

/** The ball about surfaces and receivers. */
Ball litBall(vtkPolyData* surfaces, vtkMultiBlockDataSet* receivers);

/** Say how the kinds of lights are modelled. */
void addLightNotes(const std::vector<ModelLight>& lights, Notes& notes);

/** Field data array SceneNotes. */
void putNotes(const Notes& notes, vtkPolyData* surfaces);
}  // namespace kalos::scene

#endif
