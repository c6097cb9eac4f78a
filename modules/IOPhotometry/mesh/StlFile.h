// SPDX-License-Identifier: BSD-3-Clause
/** STL, ASCII and binary. VTK's reader trusts the count of a damaged file and drops degenerate facets without a word.
 */
#ifndef KalosStlFile_h
#define KalosStlFile_h

#include <string>

#include "Mesh.h"

namespace kalos::scene
{
/** Read the facets, three points each; the file's normals are passed over, as the order of the corners tells the side.
 */
Mesh readStlFile(const std::string& path);
}  // namespace kalos::scene

#endif
