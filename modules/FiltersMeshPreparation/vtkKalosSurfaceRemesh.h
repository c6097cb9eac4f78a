// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSurfaceRemesh
 * @brief   triangles of a wanted size and good shape on the same surfaces
 *
 * Input, vtkPolyData: surfaces without degenerate or duplicate polygons, such as the output of vtkKalosSurfaceRepair.
 * Output port 0, vtkPolyData: triangles with the cell arrays of the nearest cell of the same part of the surface, and
 * the field data; point data and cell normals are not kept. Output port 1, vtkTable (Quantity, Unit, Value): triangles,
 * areas (m²), angles (degrees) and lengths of edges (m), with a histogram over the wanted length.
 *
 * Method: CGAL's isotropic remeshing (split, collapse, flip, smooth). Borders, creases sharper than FeatureAngle and
 * the edges between materials stay, with every bend they have; so flat faces stay in their planes and keep their areas.
 * Surfaces that are smooth within FeatureAngle are approximated, second order in the edge length. Triangles face as the
 * input does. Materials are what the material arrays and all integer and string cell arrays say.
 *
 * Properties:
 * - EdgeLength (0.1): wanted length of edges, m, above 0.
 * - SmallestEdgeLength (0): wanted length at concave edges and contacts, m; 0: no grading.
 * - Grading (0.3): growth of the wanted length with the distance from them, m per m, above 0.
 * - SizeArrayName (empty): cell array of the lengths that cells want, m.
 * - ResultArrayName (empty): cell array of a previous result, such as Illuminance; finer where it is steep, or where
 * its standard error (the array of that name followed by StandardError, if there) is large: L c m / (L |g| + s), with L
 * the EdgeLength, c the ResultChange, m the mean of the result, g its slope towards a neighbour and s the error; at
 * most L, at least L/8.
 * - ResultChange (0.1): change along an edge to aim at, relative to the mean, above 0.
 * - FeatureAngle (1): creases that deviate more from flat stay, degrees, above 0 to 180.
 * - Iterations (5): 1 to 100.
 * - MaximumTriangles (5000000): a length that needs more, or more memory than this machine has, is refused before the
 * work begins.
 * - TimeLimit (600): time after which the work is given up, s; 0: none.
 *
 * Where wanted lengths differ they go down in steps of a half. Progress is reported and AbortExecute and TimeLimit
 * obeyed at any time; then the outputs are empty.
 *
 * Errors: no polygons, a bad point, a property out of range, no such array, an edge length that needs more than
 * MaximumTriangles or the memory, the time limit: one error event and empty outputs. A build with this class contains
 * CGAL code and is distributed under GPL-3.0-or-later.
 */
#ifndef vtkKalosSurfaceRemesh_h
#define vtkKalosSurfaceRemesh_h

#include <string>  // for SizeArrayName

#include "vtkKalosFiltersMeshPreparationModule.h"
#include "vtkKalosSurfaceAlgorithm.h"

class VTKKALOSFILTERSMESHPREPARATION_EXPORT vtkKalosSurfaceRemesh : public vtkKalosSurfaceAlgorithm
{
public:
  static vtkKalosSurfaceRemesh* New();
  vtkTypeMacro(vtkKalosSurfaceRemesh, vtkKalosSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Wanted length of edges, m, above 0. */
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /** Wanted length of edges at concave edges and contacts, m; 0: the same everywhere. */
  vtkSetMacro(SmallestEdgeLength, double);
  vtkGetMacro(SmallestEdgeLength, double);
  ///@}

  ///@{
  /** Growth of the wanted length with the distance from concave edges and contacts, m per m. */
  vtkSetMacro(Grading, double);
  vtkGetMacro(Grading, double);
  ///@}

  ///@{
  /** Cell array of 1 component with the lengths that cells want, m; those above EdgeLength have no effect. */
  vtkSetMacro(SizeArrayName, std::string);
  vtkGetMacro(SizeArrayName, std::string);
  ///@}

  ///@{
  /** Cell array of a previous result, to be finer where it is steep or its standard error is large; empty: none. */
  vtkSetMacro(ResultArrayName, std::string);
  vtkGetMacro(ResultArrayName, std::string);
  ///@}

  ///@{
  /** Change of the result along an edge to aim at, relative to its mean, above 0. */
  vtkSetMacro(ResultChange, double);
  vtkGetMacro(ResultChange, double);
  ///@}

  ///@{
  /** Creases that deviate more from flat stay, degrees, above 0 to 180. */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /** Rounds of splitting, collapsing, flipping and smoothing. */
  vtkSetClampMacro(Iterations, int, 1, 100);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /** An edge length that needs more triangles is refused. */
  vtkSetMacro(MaximumTriangles, vtkIdType);
  vtkGetMacro(MaximumTriangles, vtkIdType);
  ///@}

protected:
  vtkKalosSurfaceRemesh() = default;
  ~vtkKalosSurfaceRemesh() override = default;

  void Work(vtkPolyData* input, kalos::ConvertedMesh& converted, vtkPolyData* output, vtkTable* report) override;

  double EdgeLength = 0.1;
  double SmallestEdgeLength = 0.0;
  double Grading = 0.3;
  std::string SizeArrayName;
  std::string ResultArrayName;
  double ResultChange = 0.1;
  double FeatureAngle = 1.0;
  int Iterations = 5;
  vtkIdType MaximumTriangles = 5000000;

private:
  vtkKalosSurfaceRemesh(const vtkKalosSurfaceRemesh&) = delete;
  void operator=(const vtkKalosSurfaceRemesh&) = delete;
};

#endif
