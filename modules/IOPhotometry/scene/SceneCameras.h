// SPDX-License-Identifier: BSD-3-Clause
/** The "cameras" of a scene file. */
#ifndef KalosSceneCameras_h
#define KalosSceneCameras_h

#include <array>
#include <set>
#include <string>
#include <vector>

#include "../base/Camera.h"
#include "../base/JsonCursor.h"

namespace kalos::scene
{
/** The keys position, target and up of a camera or an observer. */
Sight readSight(const JsonCursor& node);

/** Read the array "cameras"; `names` as for the receivers. */
std::vector<Camera> readCameras(const JsonCursor& scene, std::set<std::string>& names);
}  // namespace kalos::scene

#endif
