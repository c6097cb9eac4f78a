// SPDX-License-Identifier: BSD-3-Clause
/** The scene of a glTF 2.0 file. */
#ifndef KalosGltfModel_h
#define KalosGltfModel_h

#include <string>

#include "ModelUse.h"

namespace kalos::scene
{
/** Read the default scene: a part per node with a mesh, lights and cameras. Throws InputError. */
Model readGltfModel(const std::string& path, const ModelUse& use);
}  // namespace kalos::scene

#endif
