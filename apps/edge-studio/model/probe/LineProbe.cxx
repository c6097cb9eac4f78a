// SPDX-License-Identifier: BSD-3-Clause
#include "probe/LineProbe.h"

#include <algorithm>

#include "probe/MethodJobs.h"
#include "probe/Probe.h"

namespace studio
{
LineProbe::LineProbe(QObject* parent) : QObject(parent)
{
  connect(&this->Queue, &RunQueue::refined, this, &LineProbe::changed);
  connect(&this->Queue, &RunQueue::ended, this, &LineProbe::changed);
  connect(&this->Queue, &RunQueue::failed, this, &LineProbe::problem);
}

void LineProbe::start(const ScenePtr& scene, const ProbeLine& line, const MethodSettings& settings)
{
  this->Line = line;
  this->Truth = scene->furnaceIlluminance();
  const auto receivers = pointReceivers(line.points, QVector<Point>(line.points.size(), line.normal));
  this->Queue.start(scene, methodJobs(settings, receivers, !this->Truth));
  emit this->changed();
}

Chart LineProbe::chart() const
{
  Chart chart;
  chart.xLabel = tr("distance from the edge, m");
  chart.yLabel = tr("illuminance, lx");
  chart.logX = true;
  chart.empty = tr("Click near an edge, then measure across it");
  if (!this->Line)
    return chart;
  const QVector<double>& distances = this->Line->distances;
  std::vector<double> all;
  for (int job = 0; job < this->Queue.results().size(); ++job)
  {
    const ResultPtr& result = this->Queue.results()[job];
    if (!result)
      continue;
    const bool reference = !this->Truth && job == 0;
    Series series;
    series.name = reference ? tr("reference") : QString::fromLatin1(methodOf(result->settings.method).key);
    series.colour = reference ? 0x202020 : methodColour(result->settings.method);
    series.dashed = reference;
    for (int i = 0; i < distances.size(); ++i)
    {
      const Estimate estimate = estimateAt(*result, i);
      series.points << QPointF(distances[i], estimate.value);
      series.halfWidth << interval95 * estimate.error;
      all.push_back(estimate.value);
    }
    chart.series << series;
  }
  if (this->Truth)
    chart.series << straight(tr("truth"), 0x202020, true, {distances.first(), *this->Truth},
                             {distances.last(), *this->Truth});
  if (!all.empty())
  {
    // Limit the axis so that spikes do not hide the differences between the other methods.
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    chart.yLimit = 1.8 * std::max(all[all.size() / 2], this->Truth.value_or(0));
  }
  return chart;
}
}  // namespace studio
