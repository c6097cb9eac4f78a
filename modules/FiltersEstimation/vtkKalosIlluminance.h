// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKalosIlluminance
 * @brief Illuminance at the points or cells of any data set, with a standard error each.
 *
 * Inputs
 * - port 0, receivers: a vtkDataSet with point normals (receivers are its points) or else cell normals (receivers are
 * its cell centres), or a vtkMultiBlockDataSet of such. All receivers share one set of trajectories.
 *   With the arrays EdgeDistance and EdgeAngle of vtkKalosSingularEdges the audit says how many of those that gather
 *   lie at singular edges.
 * - port 1, surfaces: vtkPolyData with the cell array Reflectance and optionally Exitance (lm/m²), Specular,
 *   Roughness and Mirror.
 * - port 2, luminaires (optional): vtkPolyData vertices with the point array LuminousFlux (lm) and optionally
 * Direction, Distribution, SideU and SideV.
 *
 * Output: the receivers, of the same type, with the arrays Illuminance (lx), IlluminanceStandardError (lx),
 * DirectIlluminance (lx), IndirectIlluminanceStandardError (lx, of the rest), LargestScoreShare (largest single score
 * over the sum of all), IntervalTrusted (0 where the standard error cannot be believed: one score dominates, or the
 * surroundings are too near to have been sampled); with RelativeError GoalStatus (1 the value reached it, 2 it is dim
 * and its half-width below ErrorFloor, 0 neither); for a method that alters the kernel KernelCorrection (lx, what the
 * alteration added on the same trajectories); for COMPENSATED GatherRays (rays sent from the receiver; 0 where vertices
 * score everything); when the surfaces have n > 1 bands IlluminanceBands (lx, n components);
 * and the field data of vtkKalosEstimatorAlgorithm.
 *
 * LOCAL is equation (E1): E(r) = E_direct(r) + sum w_i (rho/pi) cos(theta) cos(theta') V / d^2, with spikes at concave
 * edges. SPHERE_PUBLISHED, SPHERE_EXACT, DISC and CLAMPED take the spikes out and are biased there. COMPENSATED is
 * bounded and unbiased. DIRECT counts the flux through a cell. Formulas, bias and sources: modules/Kernels/estimator.
 */
#ifndef vtkKalosIlluminance_h
#define vtkKalosIlluminance_h

#include <vector>  // for MakeOutput

#include "vtkKalosEstimatorAlgorithm.h"
#include "vtkSmartPointer.h"  // for MakeOutput

class VTKKALOSFILTERSESTIMATION_EXPORT vtkKalosIlluminance : public vtkKalosEstimatorAlgorithm
{
public:
  static vtkKalosIlluminance* New();
  vtkTypeMacro(vtkKalosIlluminance, vtkKalosEstimatorAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Put out the estimates of the single replicates too, as IlluminanceReplicates: a mean or a ratio over receivers,
   * which share trajectories, gets its standard error from them. Default off.
   */
  vtkSetMacro(KeepReplicates, bool);
  vtkGetMacro(KeepReplicates, bool);
  vtkBooleanMacro(KeepReplicates, bool);
  ///@}

  ///@{
  /**
   * Recompute replicate ReplayReplicate of a solve without a goal, and tell what it scored at receiver ReplayReceiver,
   * counted over all data sets in their order, instead of an illuminance. The output then has no arrays but the field
   * data array Replay, one tuple a round: first trajectory, trajectories, sum of the scores (lx times trajectories),
   * direct part of that, largest single score so far; and a last tuple: replicates, trajectories of each, estimate of
   * the replicate (lx), part of it that does not fluctuate (lx), 0. The illuminance is the mean of the estimates.
   * Default -1, no replay, and 0.
   */
  vtkSetMacro(ReplayReceiver, vtkIdType);
  vtkGetMacro(ReplayReceiver, vtkIdType);
  vtkSetMacro(ReplayReplicate, int);
  vtkGetMacro(ReplayReplicate, int);
  ///@}

protected:
  vtkKalosIlluminance();
  ~vtkKalosIlluminance() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool KeepReplicates = false;
  vtkIdType ReplayReceiver = -1;
  int ReplayReplicate = 0;

private:
  /// A copy of the receivers that carries a result, and the flag Valid of each receiver.
  vtkSmartPointer<vtkDataObject> MakeOutput(vtkDataObject* receivers, const kalos::Result& result,
                                            const std::vector<char>& valid) const;

  vtkKalosIlluminance(const vtkKalosIlluminance&) = delete;
  void operator=(const vtkKalosIlluminance&) = delete;
};

#endif
