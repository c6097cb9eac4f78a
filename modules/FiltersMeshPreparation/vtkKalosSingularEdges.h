// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSingularEdges
 * @brief   where local estimates turn singular: concave edges, contacts, and how far receivers are from them
 *
 * The geometric kernel cosθ cosθ'/(π d²) between two surfaces is unbounded where they meet at an angle below a straight
 * one: at concave edges, and at contact curves where a surface touches or crosses another without a common edge (a box
 * on a floor, corners that do not match along an edge). Input may be any soup of polygons and strips.
 *
 * Input ports:
 * - 0, vtkPolyData: the surfaces. Vertices and lines are ignored.
 * - 1, optional, vtkDataSet or vtkMultiBlockDataSet: receivers.
 *
 * Output ports:
 * - 0, vtkPolyData: a polyline for each straight run of edges of one kind, with the cell arrays
 *   - EdgeClass (int): CONCAVE, CONVEX, COPLANAR (within FlatAngle), BORDER (one triangle), NON_MANIFOLD (three or
 * more), CONTACT;
 *   - DihedralAngle, degrees, 0 to 360: the angle on the side of the normals; where several surfaces meet, the smallest
 *     between two that face each other; where fronts face backs only, the smallest; 360 at borders;
 *   - DihedralAngleBack, degrees: the same on the other side. NaN where there is none;
 *   - Severity: cot²(α/2)/4, that is cosθ cosθ'/d² of two points on either side, both at unit distance from the edge;
 * at distance s (m) it is 1/s² times as much. 0.25 at right angles, 0 where the surfaces do not see each other.
 * - 1: a copy of the receivers with EdgeDistance (m) to the nearest curve of a Severity above 0 and EdgeAngle
 * (degrees), the angle there that Severity is of; in point data where there are point normals or no normals at all,
 * else in cell data, from the cell's centre. Without such a curve they are infinite and NaN. Empty vtkPolyData without
 * receivers.
 * - 2, vtkTable: counts of edges by class, of contact pieces, and of what was left out (Quantity, Unit, Value).
 *
 * Properties:
 * - ConcaveEdges, ContactEdges, NonManifoldEdges (on), ConvexEdges, CoplanarEdges, BorderEdges (off): classes to
 * return.
 * - FlatAngle (0.5): deviation from a straight angle that counts as none, degrees, above 0 to 45.
 * - BothSides (off): judge an edge by the narrower of its two sides, not by the side of the normals.
 * - Tolerance (0): distance below which points are one and surfaces touch, m; 0: as vtkKalosSurfaceRepair. Contacts
 * shorter than four of it count as points; where edges cross at an angle, the ends of a contact are right to a few
 * tolerances over its sine.
 * - TimeLimit (600): time after which the search is given up, as on heaps of triangles that all cross, s; 0: none.
 *
 * Method: neighbours by OpenMesh half-edges, by a sorted list of edges where half-edges cannot store them; contacts by
 * CGAL's intersection of bounding boxes and a test of each pair of triangles; distances by CGAL's tree of segments.
 * Time is O(n log n) in the triangles. Progress is reported and AbortExecute obeyed; then the outputs are empty.
 *
 * Errors: no polygons, a point that is missing, NaN or infinite, a property out of range, the time limit: one error
 * event and empty outputs. A build with this class contains CGAL code and is distributed under GPL-3.0-or-later.
 */
#ifndef vtkKalosSingularEdges_h
#define vtkKalosSingularEdges_h

#include "vtkKalosFiltersMeshPreparationModule.h"
#include "vtkPolyDataAlgorithm.h"

class vtkTable;

class VTKKALOSFILTERSMESHPREPARATION_EXPORT vtkKalosSingularEdges : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosSingularEdges* New();
  vtkTypeMacro(vtkKalosSingularEdges, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of the array EdgeClass. */
  enum EdgeClasses
  {
    CONCAVE = 0,
    CONVEX = 1,
    COPLANAR = 2,
    BORDER = 3,
    NON_MANIFOLD = 4,
    CONTACT = 5
  };

  ///@{
  /** Which classes of edges to return. */
  vtkSetMacro(ConcaveEdges, bool);
  vtkGetMacro(ConcaveEdges, bool);
  vtkBooleanMacro(ConcaveEdges, bool);
  vtkSetMacro(ConvexEdges, bool);
  vtkGetMacro(ConvexEdges, bool);
  vtkBooleanMacro(ConvexEdges, bool);
  vtkSetMacro(CoplanarEdges, bool);
  vtkGetMacro(CoplanarEdges, bool);
  vtkBooleanMacro(CoplanarEdges, bool);
  vtkSetMacro(BorderEdges, bool);
  vtkGetMacro(BorderEdges, bool);
  vtkBooleanMacro(BorderEdges, bool);
  vtkSetMacro(NonManifoldEdges, bool);
  vtkGetMacro(NonManifoldEdges, bool);
  vtkBooleanMacro(NonManifoldEdges, bool);
  vtkSetMacro(ContactEdges, bool);
  vtkGetMacro(ContactEdges, bool);
  vtkBooleanMacro(ContactEdges, bool);
  ///@}

  ///@{
  /** Deviation from a straight angle that counts as none, degrees, above 0 to 45. */
  vtkSetMacro(FlatAngle, double);
  vtkGetMacro(FlatAngle, double);
  ///@}

  ///@{
  /** Judge an edge by the narrower of its two sides: for thin sheets that are lit from both. */
  vtkSetMacro(BothSides, bool);
  vtkGetMacro(BothSides, bool);
  vtkBooleanMacro(BothSides, bool);
  ///@}

  ///@{
  /** Distance below which points are one and surfaces touch, m; 0 for a millionth of the diagonal. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Time after which the search is given up, s; 0: none. */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  ///@}

  /** The counts, output port 2. */
  vtkTable* GetReport();

  ///@{
  /** Names of the arrays. */
  static const char* EdgeClassArrayName() { return "EdgeClass"; }
  static const char* DihedralAngleArrayName() { return "DihedralAngle"; }
  static const char* DihedralAngleBackArrayName() { return "DihedralAngleBack"; }
  static const char* SeverityArrayName() { return "Severity"; }
  static const char* EdgeDistanceArrayName();
  static const char* EdgeAngleArrayName();
  ///@}

  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkKalosSingularEdges();
  ~vtkKalosSingularEdges() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs);
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  bool ConcaveEdges = true;
  bool ConvexEdges = false;
  bool CoplanarEdges = false;
  bool BorderEdges = false;
  bool NonManifoldEdges = true;
  bool ContactEdges = true;
  double FlatAngle = 0.5;
  bool BothSides = false;
  double Tolerance = 0.0;
  double TimeLimit = 600.0;

private:
  vtkKalosSingularEdges(const vtkKalosSingularEdges&) = delete;
  void operator=(const vtkKalosSingularEdges&) = delete;
};

#endif
