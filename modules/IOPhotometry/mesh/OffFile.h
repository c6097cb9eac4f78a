// SPDX-License-Identifier: BSD-3-Clause
/** Object File Format, text. CGAL's reader keeps doubles but reports no line
 * numbers. */
#ifndef KalosOffFile_h
#define KalosOffFile_h

#include <string>

#include "Mesh.h"

namespace kalos::scene
{
/** Read points and polygons; the header may carry C, N and ST, whose colours, normals and coordinates are passed over.
 */
Mesh readOffFile(const std::string& path);
}  // namespace kalos::scene

#endif
