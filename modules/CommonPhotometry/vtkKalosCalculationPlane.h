// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosCalculationPlane
 * @brief   the grid of receivers on which a lighting engineer wants lux
 *
 * A parallelogram from Origin along U and V, cut into Resolution[0] x Resolution[1] equal quads. The receivers are the
 * cell centres, row by row along U: cell j * Resolution[0] + i has its centre at
 * Origin + (i + 1/2) / Resolution[0] U + (j + 1/2) / Resolution[1] V.
 *
 * Output: vtkPolyData of quads with points of OutputPointsPrecision and the active cell normals "Normals": U x V
 * normalised, or its opposite with Flip on (the quads are then wound the other way too).
 *
 * - Origin (m, default (0, 0, 0)): finite
 * - U, V (m, default x and y unit): finite, not parallel, not zero
 * - Resolution (default 64 x 64): each at least 1, product at most MaximumNumberOfCells()
 * - Flip (default off): on or off
 * - OutputPointsPrecision (default DOUBLE_PRECISION): SINGLE_PRECISION or DOUBLE_PRECISION of vtkAlgorithm
 *
 * Errors: a parallelogram without area, a value that is not finite, or a resolution out of range give an error event
 * and an empty output.
 */
#ifndef vtkKalosCalculationPlane_h
#define vtkKalosCalculationPlane_h

#include "vtkKalosCommonPhotometryModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKKALOSCOMMONPHOTOMETRY_EXPORT vtkKalosCalculationPlane : public vtkPolyDataAlgorithm
{
public:
  static vtkKalosCalculationPlane* New();
  vtkTypeMacro(vtkKalosCalculationPlane, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Corner from which both sides start, m. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /** Full side along which the rows run, m. */
  vtkSetVector3Macro(U, double);
  vtkGetVector3Macro(U, double);
  ///@}

  ///@{
  /** The other full side, m. */
  vtkSetVector3Macro(V, double);
  vtkGetVector3Macro(V, double);
  ///@}

  ///@{
  /** Number of receivers along U and along V. */
  vtkSetVector2Macro(Resolution, int);
  vtkGetVector2Macro(Resolution, int);
  ///@}

  ///@{
  /** Turn the normals to -(U x V). */
  vtkSetMacro(Flip, bool);
  vtkGetMacro(Flip, bool);
  vtkBooleanMacro(Flip, bool);
  ///@}

  ///@{
  /**
   * vtkAlgorithm::DOUBLE_PRECISION or SINGLE_PRECISION. Filters that make points of their own in single precision, as
   * ParaView's Plot Over Line does, find a plane at 0.8 m only in single precision, too.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /** Largest number of receivers that one plane may have. */
  static vtkIdType MaximumNumberOfCells() { return 100000000; }

protected:
  vtkKalosCalculationPlane();
  ~vtkKalosCalculationPlane() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Origin[3] = {0.0, 0.0, 0.0};
  double U[3] = {1.0, 0.0, 0.0};
  double V[3] = {0.0, 1.0, 0.0};
  int Resolution[2] = {64, 64};
  bool Flip = false;
  int OutputPointsPrecision = DOUBLE_PRECISION;

private:
  vtkKalosCalculationPlane(const vtkKalosCalculationPlane&) = delete;
  void operator=(const vtkKalosCalculationPlane&) = delete;
};

#endif
