// SPDX-License-Identifier: BSD-3-Clause
#include "probe/Probe.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/DataSets.h"
#include "vtkDataArray.h"
#include "vtkKalosArrayNames.h"

namespace studio
{
namespace
{
constexpr qint64 batchTrajectories = 32;  // one in each replicate
}

Estimate estimateAt(const Result& result, vtkIdType receiver)
{
  namespace Names = vtkKalosArrayNames;
  vtkDataSet* data = dataSets(result.data).front().data;
  return {arrayOf(data, Names::Illuminance)->GetComponent(receiver, 0),
          arrayOf(data, Names::IlluminanceStandardError)->GetComponent(receiver, 0),
          arrayOf(data, Names::IntervalTrusted)->GetComponent(receiver, 0) != 0};
}

Probe::Probe(QObject* parent) : QObject(parent)
{
  connect(&this->Queue, &RunQueue::refined, this, &Probe::take);
  connect(&this->Queue, &RunQueue::ended, this, &Probe::changed);
  connect(&this->Queue, &RunQueue::failed, this, &Probe::problem);
}

void Probe::start(const ScenePtr& scene, const Pick& pick, const MethodSettings& settings, int batches)
{
  this->Picked = pick;
  this->Edge = nearestEdge(*scene, pick.position);
  this->Truth = scene->furnaceIlluminance();
  this->Settings = settings;
  this->Steps.clear();
  this->Contributions.clear();
  const auto receiver = pointReceivers({pick.position}, {pick.normal});
  QVector<RunQueue::Job> jobs;
  jobs << RunQueue::Job{receiver, settings};
  for (int i = 1; i <= batches; ++i)
  {
    MethodSettings batch = settings;
    batch.goal = Goal::Trajectories;
    batch.trajectories = batchTrajectories;
    batch.seed = settings.seed + 1000003LL * i;  // far from the seeds that a user counts through
    jobs << RunQueue::Job{receiver, batch};
  }
  this->Queue.start(scene, jobs);
  emit this->changed();
}

void Probe::forget()
{
  this->Queue.forget();
  this->Picked.reset();
  this->Edge.reset();
  this->Steps.clear();
  this->Contributions.clear();
}

void Probe::take(int job)
{
  const ResultPtr& result = this->Queue.results()[job];
  const Estimate now = estimateAt(*result, 0);
  if (job > 0)
  {
    if (!result->complete)
      return;
    vtkDataArray* single = arrayOf(dataSets(result->data).front().data, vtkKalosArrayNames::IlluminanceReplicates);
    for (int i = 0; single && i < single->GetNumberOfComponents(); ++i)
      this->Contributions << single->GetComponent(0, i);
    if (job % 16 != 0)
      return;
  }
  else if (this->Steps.empty() || this->Steps.back().trajectories != result->trajectories)
    this->Steps.push_back({result->trajectories, now});
  emit this->changed();
}

std::optional<Estimate> Probe::estimate() const
{
  return this->Steps.empty() ? std::optional<Estimate>() : this->Steps.back().estimate;
}

qint64 Probe::trajectories() const
{
  return this->Steps.empty() ? 0 : this->Steps.back().trajectories;
}

Chart Probe::convergence() const
{
  Chart chart;
  chart.title = tr("Convergence");
  chart.xLabel = tr("trajectories");
  chart.yLabel = tr("illuminance, lx");
  chart.logX = true;
  chart.yFromZero = false;
  chart.empty = tr("Click a point of the picture: here its estimate converges");
  if (this->Steps.empty())
    return chart;
  Series estimate;
  estimate.name = QString::fromLatin1(methodOf(this->Settings.method).key);
  estimate.colour = methodColour(this->Settings.method);
  estimate.style = Series::Style::LineAndPoints;
  for (const Step& step : this->Steps)
  {
    estimate.points << QPointF(static_cast<double>(step.trajectories), step.estimate.value);
    estimate.halfWidth << interval95 * step.estimate.error;
  }
  chart.series << estimate;
  if (this->Truth)
    chart.series << straight(tr("truth"), 0x202020, true, {estimate.points.first().x(), *this->Truth},
                             {estimate.points.last().x(), *this->Truth});
  return chart;
}

Chart Probe::histogram() const
{
  Chart chart;
  chart.title = tr("Single trajectories");
  chart.xLabel = tr("illuminance that one gives, lx");
  chart.yLabel = tr("trajectories");
  chart.logX = chart.logY = true;
  chart.empty = tr("and here stands what single trajectories contribute");
  QVector<double> values;
  std::copy_if(this->Contributions.begin(), this->Contributions.end(), std::back_inserter(values),
               [](double v) { return v > 0; });
  if (values.size() < 8)
    return chart;
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double low = std::log10(*least) - 1e-6, high = std::log10(*largest) + 1e-6;
  constexpr int bins = 24;
  std::vector<int> counts(bins);
  for (double value : values)
    ++counts[std::min(bins - 1, static_cast<int>(bins * (std::log10(value) - low) / (high - low)))];
  Series bars;
  bars.name = QString::fromLatin1(methodOf(this->Settings.method).key);
  if (const int dark = static_cast<int>(this->Contributions.size() - values.size()))
    bars.name += tr(", %1 more without light").arg(dark);
  bars.colour = methodColour(this->Settings.method);
  bars.style = Series::Style::Bars;
  for (int i = 0; i <= bins; ++i)
    bars.points << QPointF(std::pow(10.0, low + (high - low) * i / bins), i < bins ? counts[i] : 0);
  const double tallest = *std::max_element(counts.begin(), counts.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0),
               mean = sum / static_cast<double>(this->Contributions.size());
  const QString share = QString::number(100 * *largest / sum, 'g', 2);
  chart.series << bars << straight(tr("mean"), 0x202020, true, {mean, 1}, {mean, tallest})
               << straight(tr("largest, %1 % of the sum").arg(share), 0xd1495b, false, {*largest, 1},
                           {*largest, std::sqrt(tallest)});
  return chart;
}
}  // namespace studio
