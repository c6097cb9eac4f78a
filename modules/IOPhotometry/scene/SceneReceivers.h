// SPDX-License-Identifier: BSD-3-Clause
/** The "receivers" of a scene file. */
#ifndef KalosSceneReceivers_h
#define KalosSceneReceivers_h

#include <set>
#include <string>
#include <vector>

#include "SceneSurfaces.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * Read the array "receivers" into one named block each, in file order. `names` holds the names of result files already
 * given away; the receivers' are added.
 */
vtkSmartPointer<vtkMultiBlockDataSet> ReadReceivers(const Node& scene, const std::vector<Surface>& surfaces,
                                                    const std::string& folder, std::set<std::string>& names);
}  // namespace kalos::scene

#endif
