// SPDX-License-Identifier: BSD-3-Clause
// Two results of the same receivers, receiver by receiver.
#ifndef studio_Comparison_h
#define studio_Comparison_h

#include "results/Result.h"

namespace studio
{
struct Comparison
{
  static constexpr const char* inErrors = "DifferenceInErrors";    ///< (a - b) / (standard error of a - b)
  static constexpr const char* inLux = "DifferenceInLux";          ///< a - b, lx
  static constexpr const char* inPercent = "DifferenceInPercent";  ///< of b; 0 where b is dark

  vtkSmartPointer<vtkDataObject> data;  ///< the sets that both have, with these arrays
  qint64 receivers = 0;
  double beyondTwo = 0;       ///< share of receivers that differ by more than two standard errors; 5 % by chance
  double meanDifference = 0;  ///< of the means over all receivers, relative to that of b
  bool independent = true;    ///< false: the seeds are the same, so the errors are not independent
};

/// A limit for the colours of one of the arrays: round, and above all but the highest hundredth of its values.
double colourLimit(const Comparison& comparison, const char* array);

/// The difference a - b. Sets that only one of the two has are left out.
Comparison compare(const Result& a, const Result& b);

/// How far a result is from the truth, over all receivers.
struct Deviation
{
  double typical = 0;  ///< root mean square, relative to the mean of the truth
  double bias = 0;     ///< mean, relative to the mean of the truth; noise is in it too
};
Deviation deviationFrom(double truth, const Result& result);
Deviation deviationFrom(const Result& reference, const Result& result);
}  // namespace studio

#endif
