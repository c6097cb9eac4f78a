// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSurfaceRepair
 * @brief   make a triangle soup into surfaces
 *
 * Input, vtkPolyData: polygons and strips in any state. Output port 0, vtkPolyData: triangles with the cell arrays of
 * the cells they come from, and the field data; point data and cell normals are not kept, and vertices and lines are
 * left out. Output port 1, vtkTable (Quantity, Unit, Value): everything that was done, with counts, areas (m²) and
 * bounds (m) before and after. Coordinates are metres.
 *
 * In this order:
 * -# merge points nearer than Tolerance;
 * -# drop degenerate triangles (lower than Tolerance) and triangles on the same corners and of the same material; of
 * those that emit, one stays for each side;
 * -# cut triangles where corners of others lie on their border edges, which stitches T-junctions;
 * -# turn triangles, so that each connected surface has one side: the one that most of its area had. Where triangles
 * emit (Exitance above 0) theirs decides, as light leaves on it;
 * -# give non-manifold edges and vertices a point for each surface (CGAL).
 *
 * Materials are what the material arrays and all integer and string cell arrays say. What cannot be repaired stays as
 * it was and is named in the field data array Unrepaired (strings, 2 components: cell of the input, reason): coincident
 * triangles of different materials, surfaces whose emitting triangles face opposite ways, and polygons whose outline
 * crosses itself, which are cut into a fan. Holes stay; their edges are counted. The areas of what was dropped stand in
 * the report, too.
 *
 * Properties:
 * - Tolerance (0): distance below which points are one, m; 0: 10^-6 of the diagonal, but for each point at most
 *   10^-4 of its shortest edge and at least the rounding of its coordinates, so that gaps stay open on wide sites.
 * - KeepSides (off): turn no triangle. Before a solve triangles keep their sides: where two faces lie in one place,
 * each is seen from its own.
 * - TimeLimit (600): time after which the work is given up, s; 0: none.
 *
 * Progress is reported and AbortExecute obeyed; then the outputs are empty.
 *
 * Errors: no polygons, all degenerate, a point that is missing, NaN or infinite, a Tolerance below 0, the time limit:
 * one error event and empty outputs. A build with this class contains CGAL code and is distributed under
 * GPL-3.0-or-later.
 */
#ifndef vtkKalosSurfaceRepair_h
#define vtkKalosSurfaceRepair_h

#include "vtkKalosFiltersMeshPreparationModule.h"
#include "vtkKalosSurfaceAlgorithm.h"

class VTKKALOSFILTERSMESHPREPARATION_EXPORT vtkKalosSurfaceRepair : public vtkKalosSurfaceAlgorithm
{
public:
  static vtkKalosSurfaceRepair* New();
  vtkTypeMacro(vtkKalosSurfaceRepair, vtkKalosSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Distance below which points are one, m; 0 for a millionth of the diagonal. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Turn no triangle. */
  vtkSetMacro(KeepSides, bool);
  vtkGetMacro(KeepSides, bool);
  vtkBooleanMacro(KeepSides, bool);
  ///@}

  /** Name of the field data array of what could not be repaired. */
  static const char* UnrepairedArrayName() { return "Unrepaired"; }

protected:
  vtkKalosSurfaceRepair() = default;
  ~vtkKalosSurfaceRepair() override = default;

  void Work(vtkPolyData* input, kalos::ConvertedMesh& converted, vtkPolyData* output, vtkTable* report) override;

  double Tolerance = 0.0;
  bool KeepSides = false;

private:
  vtkKalosSurfaceRepair(const vtkKalosSurfaceRepair&) = delete;
  void operator=(const vtkKalosSurfaceRepair&) = delete;
};

#endif
