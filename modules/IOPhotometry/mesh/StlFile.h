// SPDX-License-Identifier: BSD-3-Clause
/** STL, ASCII and binary. VTK's and CGAL's readers trust the count of a damaged file and report no line numbers. */
#ifndef KalosStlFile_h
#define KalosStlFile_h

#include <string>

#include "../base/Notes.h"
#include "Mesh.h"

namespace kalos::scene
{
/**
 * Read the facets, three points each; the file's normals are passed over, as the order of the corners tells the side.
 *
 * Text may begin with blanks or a mark of UTF-8, be in capitals, write "end loop", and lack its endsolid after a
 * complete facet; a binary file may have bytes after its facets. `notes` gets the last two.
 */
Mesh readStlFile(const std::string& path, Notes& notes);
}  // namespace kalos::scene

#endif
