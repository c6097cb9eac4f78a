// SPDX-License-Identifier: BSD-3-Clause
/** Surfaces between vtkPolyData and the meshing library. */
#ifndef KalosMeshConversion_h
#define KalosMeshConversion_h

#include <functional>
#include <initializer_list>
#include <vector>

#include "mesh/TriangleMesh.h"
#include "vtkType.h"

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace kalos
{
struct ConvertedMesh
{
  meshing::TriangleMesh mesh;
  vtkIdType polygons = 0;           ///< polygons and strips taken
  vtkIdType ignored = 0;            ///< vertices and lines, which are no surface
  vtkIdType degenerate = 0;         ///< polygons of fewer than three corners
  std::vector<vtkIdType> crossing;  ///< polygons that no triangulation was found for and that became fans
};

/**
 * The polygons and strips as triangles. Throws std::invalid_argument without any, if one has a bad point, or if a cell
 * array has another length than there are cells.
 *
 * Triangles have the same material number if their cells agree in every array that says what a surface is: the material
 * arrays of vtkKalosArrayNames.h, and all integer and string arrays.
 */
ConvertedMesh convertMesh(vtkPolyData* input);

/** The mesh as polygons of three corners with the cell arrays of `input`, each triangle those of its origin. */
void fillPolyData(const meshing::TriangleMesh& mesh, vtkPolyData* input, vtkPolyData* output);

/** Reports to the algorithm and stops when it is to abort; throws when it has taken `seconds`, unless 0. */
meshing::Progress progressOf(vtkAlgorithm* algorithm, double seconds = 0.0);

/** Throws std::invalid_argument unless it is 0 or more seconds. */
void checkTimeLimit(double seconds);

/** Runs `work`; an exception empties the outputs and becomes an error event, except after an abort. Returns VTK's 1 or
 * 0. */
int guarded(vtkAlgorithm* algorithm, std::initializer_list<vtkDataObject*> outputs, const std::function<void()>& work);
}  // namespace kalos

#endif
