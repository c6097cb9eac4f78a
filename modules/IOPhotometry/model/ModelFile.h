// SPDX-License-Identifier: BSD-3-Clause
/** Files that hold a whole model: .gltf, .glb and .obj. */
#ifndef KalosModelFile_h
#define KalosModelFile_h

#include <string>

#include "../base/JsonCursor.h"
#include "ModelUse.h"

namespace kalos::scene
{
/** By the suffix of the name. */
bool isModelFile(const std::string& path);
bool isGltfFile(const std::string& path);

/** The map from a file's metres times `scale`, with z or (`yUp`) y up, to metres with z up. */
Transform uprightPlace(double scale, bool yUp);

/**
 * Read a model and check it; polygons without area are left out and counted. `place` is the scene file's value that
 * names it. Throws InputError.
 */
Model readModelFile(const JsonCursor& place, const std::string& path, const ModelUse& use);
}  // namespace kalos::scene

#endif
