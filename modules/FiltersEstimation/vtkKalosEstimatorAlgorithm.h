// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKalosEstimatorAlgorithm
 * @brief Settings that every estimating filter shares.
 *
 * The method, its effort and its goals. Without a goal the filter runs Trajectories. With a goal it stops as soon as
 * every value's 95 % half-width is within RelativeError of the value or below ErrorFloor, Seconds have passed, or
 * Trajectories are used up. The output gets the field data arrays Audit (what was modelled and why), Trajectories,
 * Rays, SolveSeconds, SolveCpuSeconds, Seed and KalosVersion. The filter reports progress and obeys AbortExecute: the
 * output then holds the rounds that were complete, if any, and the audit says so. The same seed gives bitwise the same
 * numbers for any number of threads.
 *
 * The audit balances the light (emitted = absorbed + escaped) and has lines `warning` for surfaces that seem to leak or
 * to emit to the wrong side. A score that is infinite, negative or not a number ends the solve with an ErrorEvent,
 * which names receiver, trajectory and vertex, and the ErrorCode UnknownError.
 *
 * Errors: settings out of range, surfaces without the array Reflectance, arrays of the wrong length, and values that
 * are out of range or not finite give an ErrorEvent and no output.
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
    DIRECT = 7,
    PATHS = 8,
    PHOTON_MAP = 9,
    RADIOSITY = 10,
    BIDIRECTIONAL = 11
  };

  ///@{
  /**
   * The estimator, a MethodType. Default COMPENSATED. The first eight share trajectories of light among all receivers;
   * PATHS starts a path at each receiver per trajectory; PHOTON_MAP counts the photons that trajectories leave about
   * each receiver; RADIOSITY solves for finite elements; BIDIRECTIONAL joins trajectories and paths. A method that can
   * not serve a scene gives an error that says why.
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
   * Half-width that is small enough for any value, lx, whatever RelativeError says; for an image, of the illuminance on
   * the surfaces that the pixels see. A negative number, such as the default -1, stands for RelativeError times a
   * hundredth of the mean over all values.
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
   * Whether the warnings of the audit are warning events as well, which VTK shows in its output window. Default: on.
   */
  vtkSetMacro(TellWarnings, bool);
  vtkGetMacro(TellWarnings, bool);
  vtkBooleanMacro(TellWarnings, bool);
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
   * Radius of the averaging sphere or disc, half side of a point's cell for DIRECT, radius of PHOTON_MAP, which then
   * does not shrink, longest edge of an element of RADIOSITY, m; at most the size of the scene. Default 0: automatic.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * What single methods let one choose. Photons of PHOTON_MAP: count the nearest so many; default 0, those within a
   * radius. ConeFilter of PHOTON_MAP: photons count less the farther they are; default off. FinalGather of PHOTON_MAP
   * and RADIOSITY: read the map or the elements where rays from the receivers end; default off. LinearElements of
   * RADIOSITY, else constant ones; default on. Connections of BIDIRECTIONAL: 1 local estimates only, 2 double ones, 3
   * triple ones, ...; default 0, all, weighed by the balance heuristic.
   */
  vtkSetMacro(Photons, int);
  vtkGetMacro(Photons, int);
  vtkSetMacro(ConeFilter, bool);
  vtkGetMacro(ConeFilter, bool);
  vtkBooleanMacro(ConeFilter, bool);
  vtkSetMacro(FinalGather, bool);
  vtkGetMacro(FinalGather, bool);
  vtkBooleanMacro(FinalGather, bool);
  vtkSetMacro(LinearElements, bool);
  vtkGetMacro(LinearElements, bool);
  vtkBooleanMacro(LinearElements, bool);
  vtkSetMacro(Connections, int);
  vtkGetMacro(Connections, int);
  ///@}

  ///@{
  /**
   * File for the state of the solve. If it exists, the solve resumes from it: a solve that was killed and is run again
   * gives bitwise the numbers of an uninterrupted one. The first process replaces the file atomically every
   * CheckpointInterval and when the solve ends or is aborted. The file stays when the solve is complete; a later update
   * with the same input then has its numbers at once. A damaged file, or one of another scene, set of receivers,
   * version or setting (Threads and processes apart), is an error and is not changed; a full disk is a warning. The
   * file takes receivers x 32 replicates x (2 bands + 2) x 8 bytes, the solve twice that in memory. Default: none.
   */
  vtkSetFilePathMacro(CheckpointFile);
  vtkGetFilePathMacro(CheckpointFile);
  ///@}

  ///@{
  /**
   * Show the result while it is refined: after each round of trajectories the filter invokes
   * vtkCommand::UpdateDataEvent with the result so far, a data object of the output's type that the observer may keep.
   * The first round then has one trajectory a replicate, and later rounds half of what is done. Default off.
   */
  vtkSetMacro(IntermediateResults, bool);
  vtkGetMacro(IntermediateResults, bool);
  vtkBooleanMacro(IntermediateResults, bool);
  ///@}

  ///@{
  /**
   * Time between checkpoints, s, >= 0. They are saved after complete rounds of trajectories. Default 10.
   */
  vtkSetMacro(CheckpointInterval, double);
  vtkGetMacro(CheckpointInterval, double);
  ///@}

  ///@{
  /**
   * Keep the scene that was prepared for rays: as long as surfaces and luminaires are not modified, updates with other
   * receivers, methods and cameras then begin at once. It takes some 400 bytes a triangle between updates. Default off.
   */
  vtkSetMacro(KeepScene, bool);
  vtkGetMacro(KeepScene, bool);
  vtkBooleanMacro(KeepScene, bool);
  ///@}

  ///@{
  /**
   * Techniques to do without, names separated by commas: stratified (walks stratified by Sobol' points), picked (shadow
   * rays only to vertices picked by their scores), convex (no shadow rays in an empty convex room), near (gather rays
   * only where a surface is near), paths (no vertices where luminous surfaces are all around and paths from the
   * receivers alone win a trial), neighbours (gather rays of `gathered` light all receivers of a group), effort
   * (receivers that reached the goal are skipped), highlights (lamps in glossy planes sampled about their mirror
   * images), exact-direct (area emitters in closed form). None adds bias; disable them to measure what they save.
   * Default empty.
   */
  vtkSetStringMacro(DisabledTechniques);
  vtkGetStringMacro(DisabledTechniques);
  ///@}

  ///@{
  /**
   * The processes that share the work. Default: the global controller at construction. With null or a single process
   * the filter works alone. With several, all of them must update the filter. Each process reads the whole input,
   * whatever piece is requested, works on its share of the replicates and gets the whole result, bitwise that of a
   * single process. Of a request for pieces, piece 0 holds everything and the others are empty; an image is divided by
   * its extent.
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

  /// Warning events for the warnings of the audit.
  void Tell(const kalos::Result& result);

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
  int Photons = 0;
  bool ConeFilter = false;
  bool FinalGather = false;
  bool LinearElements = true;
  int Connections = 0;
  char* CheckpointFile = nullptr;
  double CheckpointInterval = 10;
  bool IntermediateResults = false;
  bool TellWarnings = true;
  bool KeepScene = false;
  char* DisabledTechniques = nullptr;
  vtkMultiProcessController* Controller = nullptr;

private:
  struct KeptScene;
  std::unique_ptr<KeptScene> Kept;

  vtkKalosEstimatorAlgorithm(const vtkKalosEstimatorAlgorithm&) = delete;
  void operator=(const vtkKalosEstimatorAlgorithm&) = delete;
};

#endif
