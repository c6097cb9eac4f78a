// SPDX-License-Identifier: BSD-3-Clause
// One surface of whatever a pipeline has: polygons, a grid, or blocks of these.
#ifndef SurfaceJoining_h
#define SurfaceJoining_h

#include <vector>

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;
class vtkDataSet;
class vtkInformation;
class vtkPolyData;

/// Lets a port take any data set, or any composite one as a whole; returns 1.
int AcceptAnyData(vtkInformation* port);

/// The data sets of a data object (itself, or the leaves of any composite one), in order.
std::vector<vtkDataSet*> LeavesOf(vtkDataObject* object);

/// When the object or one of its leaves was modified last.
vtkMTimeType ModifiedTime(vtkDataObject* object);

/// Polygons are taken as they are. Other data sets give their outer faces, whose normals are outwards. Blocks become
/// one surface: each has the arrays of vtkKalosArrayNames for its cells, or for all of them as field data of one tuple;
/// what only others have is 0 there, but for Reflectance; and a block is a surface of its name. Throws
/// std::invalid_argument for a block without Reflectance.
vtkSmartPointer<vtkPolyData> JoinSurfaces(vtkDataObject* surfaces);

#endif
