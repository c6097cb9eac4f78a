// SPDX-License-Identifier: BSD-3-Clause
/** Lights (KHR_lights_punctual) and cameras that hang on the nodes of a glTF. */
#ifndef KalosGltfLights_h
#define KalosGltfLights_h

#include <optional>

#include "../base/Camera.h"
#include "../base/NoteCounter.h"
#include "../mesh/Transform.h"
#include "GltfFile.h"
#include "ModelLight.h"

namespace kalos::scene
{
/** The light of a node that lies at `world`, if it has one. It shines along -z of the node. */
std::optional<ModelLight> readGltfLight(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                        NoteCounter& found);

/** The camera of a node, if it has one in perspective. It looks along -z of the node. */
std::optional<Camera> readGltfCamera(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                     NoteCounter& found);
}  // namespace kalos::scene

#endif
