// SPDX-License-Identifier: BSD-3-Clause
/** An OBJ with its material libraries as a model. */
#ifndef KalosObjModel_h
#define KalosObjModel_h

#include <string>

#include "ModelUse.h"

namespace kalos::scene
{
/** A part per object ("o", or "g" where there are none). Throws InputError. */
Model readObjModel(const std::string& path, const ModelUse& use);
}  // namespace kalos::scene

#endif
