// SPDX-License-Identifier: BSD-3-Clause
/** Stanford PLY, ASCII and binary. VTK's reader rounds doubles to floats and trusts the counts of a damaged file. */
#ifndef KalosPlyFile_h
#define KalosPlyFile_h

#include <string>

#include "Mesh.h"

namespace kalos::scene
{
/** Read the vertices' x, y, z and the faces' vertex_indices (or vertex_index); other elements and properties are passed
 * over. */
Mesh readPlyFile(const std::string& path);
}  // namespace kalos::scene

#endif
