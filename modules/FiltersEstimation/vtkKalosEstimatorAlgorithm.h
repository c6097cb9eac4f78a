// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKalosEstimatorAlgorithm
 * @brief Settings that every estimating filter shares.
 *
 * The method, its effort and its goals. Without a goal the filter runs Trajectories; with one, until the first of:
 * every value's 95 % half-width is within RelativeError of it or below ErrorFloor, Seconds have passed, Trajectories
 * are used up. Every filter attaches to its output the field data arrays Audit (what was modelled and why),
 * Trajectories, Rays, SolveSeconds, SolveCpuSeconds, Seed and KalosVersion. It reports progress and obeys AbortExecute:
 * the output then holds the rounds that were complete, and the audit says so; it is empty when there was none. The same
 * seed gives the same numbers, bit by bit, for any number of threads.
 *
 * The audit says what became of the light, emitted = absorbed + escaped, and has lines `warning` for surfaces that seem
 * to leak or to emit to the wrong side. A score that is infinite, negative or not a number ends the solve with an
 * ErrorEvent that names receiver, trajectory and vertex, and the ErrorCode UnknownError.
 *
 * Errors: settings out of range, surfaces without the array Reflectance, arrays shorter or longer than what they are
 * of, values out of range or not finite give an ErrorEvent and no output.
 */
#ifndef vtkKalosEstimatorAlgorithm_h
#define vtkKalosEstimatorAlgorithm_h

#include <memory>  // for MakeCheckpoint and Kept

#include "vtkDataObjectAlgorithm.h"
#include "vtkKalosFiltersEstimationModule.h"  // for export macro

class vtkFieldData;
class vtkMultiProcessController;
class vtkPolyData;

namespace kalos
{
class CheckpointStore;
class Ranks;
struct Result;
class Scene;
struct Settings;
}  // namespace kalos

class VTKKALOSFILTERSESTIMATION_EXPORT vtkKalosEstimatorAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkKalosEstimatorAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    LOCAL = 0,
    SPHERE_PUBLISHED = 1,
    SPHERE_EXACT = 2,
    DISC = 3,
    CLAMPED = 4,
    COMPENSATED = 5,
    GATHERED = 6,
    DIRECT = 7
  };

  ///@{
  /**
   * The estimator, a MethodType. Default COMPENSATED.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Upper limit of trajectories over all replicates. Default 0: 10 000 without a goal, no limit with one.
   */
  vtkSetMacro(Trajectories, vtkIdType);
  vtkGetMacro(Trajectories, vtkIdType);
  ///@}

  ///@{
  /**
   * Goal: relative 95 % half-width at every receiver, in [0,1). Default 0: no such goal.
   */
  vtkSetMacro(RelativeError, double);
  vtkGetMacro(RelativeError, double);
  ///@}

  ///@{
  /**
   * Half-width that is small enough for any value, whatever RelativeError says, lx; of an image that of the illuminance
   * on what the pixels see. Default -1, or any negative number: RelativeError of a hundredth of the mean over all
   * values.
   */
  vtkSetMacro(ErrorFloor, double);
  vtkGetMacro(ErrorFloor, double);
  ///@}

  ///@{
  /**
   * Goal: time of the solve, s. Default 0: no such goal.
   */
  vtkSetMacro(Seconds, double);
  vtkGetMacro(Seconds, double);
  ///@}

  ///@{
  /**
   * Seed of the random numbers. Default 1.
   */
  vtkSetMacro(Seed, vtkIdType);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

  ///@{
  /**
   * Threads. Default 0: all processors.
   */
  vtkSetMacro(Threads, int);
  vtkGetMacro(Threads, int);
  ///@}

  ///@{
  /**
   * Distance below which the sphere methods average and CLAMPED clamps, m; at most the size of the scene. Default 0:
   * automatic.
   */
  vtkSetMacro(Delta, double);
  vtkGetMacro(Delta, double);
  ///@}

  ///@{
  /**
   * Radius of the averaging sphere or disc, half side of a point's cell for DIRECT, m; at most the size of the scene.
   * Default 0: automatic.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * File that the state of the solve is kept in, and that it goes on from when it is there: a solve that was killed and
   * is run again gives bitwise the numbers of one that was not. Written whole or not at all, every CheckpointInterval
   * and when the solve ends, also by AbortExecute; by the first process only. It stays when the solve is complete; a
   * later update with the same input then has its numbers at once. A file of another scene, set of receivers, version
   * or setting (but for Threads and processes), or a damaged one, is an error and left as it is; one that can not be
   * written for want of space is a warning. Takes the size of receivers x 32 replicates x (2 bands + 2) x 8 bytes, and
   * twice that in memory. Default: none.
   */
  vtkSetFilePathMacro(CheckpointFile);
  vtkGetFilePathMacro(CheckpointFile);
  ///@}

  ///@{
  /**
   * Show the result while it is refined: after each round of trajectories vtkCommand::UpdateDataEvent is invoked with
   * the result so far, a data object of the output's type that the observer may keep. Rounds then begin with one
   * trajectory a replicate and grow by half of what is done. Default off.
   */
  vtkSetMacro(IntermediateResults, bool);
  vtkGetMacro(IntermediateResults, bool);
  vtkBooleanMacro(IntermediateResults, bool);
  ///@}

  ///@{
  /**
   * Time between checkpoints, s, >= 0; they are taken between rounds of trajectories. Default 10.
   */
  vtkSetMacro(CheckpointInterval, double);
  vtkGetMacro(CheckpointInterval, double);
  ///@}

  ///@{
  /**
   * Keep the scene as it is prepared for rays, for further updates with the same surfaces and luminaires (none of which
   * was modified): other receivers, methods and cameras then begin at once. Takes memory between updates, some 400
   * bytes a triangle. Default off.
   */
  vtkSetMacro(KeepScene, bool);
  vtkGetMacro(KeepScene, bool);
  vtkBooleanMacro(KeepScene, bool);
  ///@}

  ///@{
  /**
   * Savings to do without, names separated by commas: stratified (walks stratified by Sobol' points), picked (shadow
   * rays only to vertices picked by their scores), convex (no shadow rays in an empty convex room), near (gather rays
   * only where a surface is near), paths (no vertices where luminous surfaces are all around and paths from the
   * receivers alone win a trial), neighbours (gather rays of `gathered` light all receivers of a group), effort
   * (receivers rest that have enough for the goal), highlights (lamps in glossy planes sampled about their mirror
   * images), exact-direct (area emitters in closed form). None moves a mean; for those who measure what they save.
   * Default empty.
   */
  vtkSetStringMacro(Without);
  vtkGetStringMacro(Without);
  ///@}

  ///@{
  /**
   * The processes that share the work. Default: the global controller at construction; null or a single process works
   * alone. With several, all of them must update the filter. Each asks its inputs for the whole, whatever piece it is
   * asked for itself, works on its share of the replicates, and knows the result, bit by bit that of one process. A
   * request for pieces is answered by piece 0, of an image by its extent; the others are empty.
   */
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkKalosEstimatorAlgorithm();
  ~vtkKalosEstimatorAlgorithm() override;

  /// The store of CheckpointFile; null when none is wanted.
  std::unique_ptr<kalos::CheckpointStore> MakeCheckpoint();

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// The settings, for a solve by `ranks` that is kept in `checkpoint`.
  kalos::Settings MakeSettings(const kalos::Ranks& ranks, kalos::CheckpointStore* checkpoint) const;

  /// The kernels' scene of these inputs. Throws std::invalid_argument as MakeSceneDescription() does.
  std::shared_ptr<const kalos::Scene> MakeScene(vtkPolyData* surfaces, vtkPolyData* luminaires);

  /// Reports progress to VTK and returns false when the user aborts.
  bool ReportProgress(double fraction);

  /// Attaches the field data of the class comment.
  void Describe(const kalos::Result& result, vtkFieldData* fieldData) const;

  int Method = COMPENSATED;
  vtkIdType Trajectories = 0;
  double RelativeError = 0;
  double ErrorFloor = -1;
  double Seconds = 0;
  vtkIdType Seed = 1;
  int Threads = 0;
  double Delta = 0;
  double Epsilon = 0;
  char* CheckpointFile = nullptr;
  double CheckpointInterval = 10;
  bool IntermediateResults = false;
  bool KeepScene = false;
  char* Without = nullptr;
  vtkMultiProcessController* Controller = nullptr;

private:
  struct KeptScene;
  std::unique_ptr<KeptScene> Kept;

  vtkKalosEstimatorAlgorithm(const vtkKalosEstimatorAlgorithm&) = delete;
  void operator=(const vtkKalosEstimatorAlgorithm&) = delete;
};

#endif
