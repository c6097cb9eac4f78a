// SPDX-License-Identifier: BSD-3-Clause
/** Mesh files in any state, to be repaired. */
#ifndef KalosLooseMesh_h
#define KalosLooseMesh_h

#include <string>

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/** Read as vtkKalosMeshReader.h says; throws InputError. */
vtkSmartPointer<vtkPolyData> readLooseMesh(const std::string& path);
}  // namespace kalos::scene

#endif
