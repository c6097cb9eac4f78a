// SPDX-License-Identifier: BSD-3-Clause
// The result of a run, complete or not.
#ifndef studio_Result_h
#define studio_Result_h

#include <memory>

#include "base/Point.h"
#include "results/MethodSettings.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkDataSet;

namespace studio
{
/// Relative standard errors over all receivers of a result.
struct Quality
{
  double largest = 0;  ///< of receivers that are not dark
  double typical = 0;  ///< root mean square
  qint64 receivers = 0, untrusted = 0;
  qint64 invalid = 0;  ///< receivers inside a solid, below a surface or outside, which the others leave out
};

struct Result
{
  MethodSettings settings;
  QString name;                         ///< that a user gave it; may be empty
  vtkSmartPointer<vtkDataObject> data;  ///< as the estimator gives it, and Luminance where the material is known
  Quality quality;
  qint64 trajectories = 0;
  double seconds = 0, cpuSeconds = 0;  ///< of the solve, pauses and set-up apart
  bool complete = false;               ///< reached its goal
  bool preview = false;                ///< only some receivers were solved, the others take their neighbours' values

  /// The data set of this name (or the only one); null if there is none.
  vtkDataSet* set(const QString& wanted) const;
};

using ResultPtr = std::shared_ptr<const Result>;

/// Arrays that makeResult() adds to every set with illuminances.
constexpr const char* relativeErrorName = "RelativeStandardError";  ///< %, of the illuminance; 0 where it is dark
constexpr const char* untrustedName = "Untrusted";                  ///< 1 where the standard error cannot be believed

/// Takes over the output of vtkKalosIlluminance; nobody else may change it afterwards.
Result makeResult(const MethodSettings& settings, vtkDataObject* data);

/// An array of a data set, from its points where they have it, else from its cells; null if there is none.
vtkDataArray* arrayOf(vtkDataSet* dataSet, const char* name);

/// Where a receiver of a data set is, m: its points where they carry the results, else its cell centres.
Point receiverPosition(vtkDataSet* dataSet, vtkIdType receiver);
}  // namespace studio

#endif
