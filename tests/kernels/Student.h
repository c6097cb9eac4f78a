// SPDX-License-Identifier: BSD-3-Clause
// How far estimates may lie from the truth in tests.
#ifndef kalos_tests_Student_h
#define kalos_tests_Student_h

#include <algorithm>
#include <cmath>

#include "estimator/control/Result.h"
#include "estimator/solve/Solver.h"
#include "statistics/Replicates.h"

namespace kalos
{
/// In standard errors: `comparisons` of them raise one false alarm in a thousand seeds (Student, with as many degrees
/// of freedom as the replicates leave, and Sidak).
inline double allowed(const Result& result, int comparisons)
{
  return studentQuantile(std::pow(1 - 1e-3, 1.0 / comparisons), result.replicates - 1);
}

/// The same of differences between two results, and more cautious: with the fewer degrees of freedom of the two.
inline double allowed(const Result& a, const Result& b, int comparisons)
{
  return std::max(allowed(a, comparisons), allowed(b, comparisons));
}
}  // namespace kalos

#endif
