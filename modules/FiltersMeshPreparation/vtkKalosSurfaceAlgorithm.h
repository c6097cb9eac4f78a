// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkKalosSurfaceAlgorithm
 * @brief   what repair and remeshing of surfaces have in common
 *
 * Input, vtkPolyData: polygons and strips. Output port 0, vtkPolyData: triangles with the cell arrays of the cells they
 * come from, and the field data. Output port 1, vtkTable (Quantity, Unit, Value): what was done.
 *
 * Property: TimeLimit (600), s; 0: none. Work that takes longer is given up: on badly damaged
 * meshes remeshing may never end.
 *
 * Progress is reported and AbortExecute obeyed; then the outputs are empty. So they are after an error, which is one
 * error event: no polygons, a cell array of another length than the cells, a point that is missing, NaN or infinite,
 * the time limit, and what subclasses add.
 */
#ifndef vtkKalosSurfaceAlgorithm_h
#define vtkKalosSurfaceAlgorithm_h

#include "vtkKalosFiltersMeshPreparationModule.h"
#include "vtkPolyDataAlgorithm.h"

class vtkTable;
namespace kalos
{
struct ConvertedMesh;
}

class VTKKALOSFILTERSMESHPREPARATION_EXPORT vtkKalosSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkKalosSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Time after which the work is given up, s; 0: none. */
  vtkSetMacro(TimeLimit, double);
  vtkGetMacro(TimeLimit, double);
  ///@}

  /** What was done, output port 1. */
  vtkTable* GetReport();

protected:
  vtkKalosSurfaceAlgorithm();
  ~vtkKalosSurfaceAlgorithm() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** Changes the mesh of `input` and fills the outputs; throws what is to become an error event. */
  virtual void Work(vtkPolyData* input, kalos::ConvertedMesh& converted, vtkPolyData* output, vtkTable* report) = 0;

  double TimeLimit = 600.0;

private:
  vtkKalosSurfaceAlgorithm(const vtkKalosSurfaceAlgorithm&) = delete;
  void operator=(const vtkKalosSurfaceAlgorithm&) = delete;
};

#endif
