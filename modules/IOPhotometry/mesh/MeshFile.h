// SPDX-License-Identifier: BSD-3-Clause
/** OBJ, PLY, STL, OFF and VTP surfaces of a scene. */
#ifndef KalosMeshFile_h
#define KalosMeshFile_h

#include <string>

#include "../base/JsonCursor.h"
#include "../base/Notes.h"
#include "Mesh.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * Read and check the mesh at `path`; `place` is the scene file's value that names it.
 *
 * Material of a polygon, first that applies: the one that the OBJ's usemtl names in `materials` or in a library of the
 * file; `fallback`, if given; the VTP's own cell arrays (Reflectance, Exitance, Specular, Roughness, Mirror). None of
 * them is an error. Polygons without area are left out, and `notes` told.
 */
Mesh readMeshFile(const JsonCursor& place, const std::string& path, const Materials& materials,
                  const Material* fallback, Notes& notes);
/** The whole of a VTP file. */
vtkSmartPointer<vtkPolyData> readVtpFile(const std::string& path);
}  // namespace kalos::scene

#endif
