// SPDX-License-Identifier: BSD-3-Clause
/**
 * Stanford PLY, ASCII and binary. VTK's reader rounds doubles to floats and trusts the counts of a damaged file;
 * CGAL's
 * reports no place and accepts corners that name no point.
 */
#ifndef KalosPlyFile_h
#define KalosPlyFile_h

#include <string>

#include "Mesh.h"

namespace kalos::scene
{
/**
 * Read the vertices' x, y, z, the faces' vertex_indices (or vertex_index) and the strips of the element tristrips,
 * which -1 parts; other elements and properties are passed over. An empty mesh without faces and strips. Colours are
 * told to `notes`.
 */
Mesh readPlyFile(const std::string& path, Notes& notes);
}  // namespace kalos::scene

#endif
