// SPDX-License-Identifier: BSD-3-Clause
// Every method on the same points, for comparison.
#ifndef studio_MethodJobs_h
#define studio_MethodJobs_h

#include "run/RunQueue.h"

namespace studio
{
/// A job for every method with the effort, delta and epsilon of `settings`; before them, with `reference`, compensated
/// with eight times the effort. Seeds differ, so that errors are independent.
QVector<RunQueue::Job> methodJobs(const MethodSettings& settings, vtkDataObject* receivers, bool reference);
}  // namespace studio

#endif
