// SPDX-License-Identifier: BSD-3-Clause
/** Material libraries of OBJ files. */
#ifndef KalosMtlFile_h
#define KalosMtlFile_h

#include <string>

#include "../base/Notes.h"
#include "Material.h"

namespace kalos::scene
{
/**
 * Read the library at `path`: Kd is the diffuse reflectance, map_Kd multiplies it by its mean colour; Ke is a luminance
 * in cd/m², 1 beside a map_Ke without Ke, and map_Ke multiplies it; Pm and Pr are metallic and roughness of glTF's
 * model. Ks counts where illum asks for reflections (3, 5, 7, 8): a lobe of the width of Phong's exponent Ns,
 * roughness^4 = 2/(Ns + 2). A highlight (illum 2) is no reflectance. Keywords may be in any case; only values that
 * are used are checked. Approximations and omissions are added to `notes`. Throws InputError.
 */
Materials readMtlFile(const std::string& path, Notes& notes);
}  // namespace kalos::scene

#endif
