// SPDX-License-Identifier: BSD-3-Clause
#include "probe/MethodJobs.h"

#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
QVector<RunQueue::Job> methodJobs(const MethodSettings& settings, vtkDataObject* receivers, bool reference)
{
  QVector<RunQueue::Job> jobs;
  if (reference)
  {
    MethodSettings best = settings;
    best.method = vtkKalosEstimatorAlgorithm::COMPENSATED;
    best.trajectories *= 8;
    best.seconds *= 8;
    best.relativeError /= 3;
    best.seed = settings.seed + 1000;
    jobs << RunQueue::Job{receivers, best};
  }
  for (const Method& method : methods())
  {
    MethodSettings one = settings;
    one.method = method.id;
    one.seed = settings.seed + jobs.size();
    jobs << RunQueue::Job{receivers, one};
  }
  return jobs;
}
}  // namespace studio
