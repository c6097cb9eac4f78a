// SPDX-License-Identifier: BSD-3-Clause
#include "probe/EdgeLens.h"

#include <cmath>

#include "probe/MethodJobs.h"
#include "probe/Probe.h"

namespace studio
{
double LensGrid::distance(int column)
{
  return 1e-4 * std::pow(10.0, column / 10.0);
}

std::optional<LensGrid> lensGrid(const ScenePtr& scene, const EdgePiece& edge)
{
  const auto flanks = flanksOf(*scene, edge);
  if (!flanks)
    return {};
  LensGrid grid{edge, *flanks, {}, {}, {}};
  const Picking surfaces(scene, {SceneDocument::paintedName()});
  for (const Flank& flank : *flanks)
    for (int row = 0; row < LensGrid::rows; ++row)
      for (int column = 0; column < LensGrid::columns; ++column)
      {
        const double along = (row + 0.5) / LensGrid::rows, distance = LensGrid::distance(column);
        const Point point = edge.from + along * (edge.to - edge.from) + distance * flank.away,
                    lift = 1e-3 * scene->size() * flank.normal;
        const bool held = distance < 0.01 * scene->size() || surfaces.first(point + lift, point - lift);
        grid.index << (held ? static_cast<int>(grid.points.size()) : -1);
        if (held)
        {
          grid.points << point;
          grid.normals << flank.normal;
        }
      }
  return grid;
}

EdgeLens::EdgeLens(QObject* parent) : QObject(parent)
{
  connect(&this->Queue, &RunQueue::refined, this, &EdgeLens::changed);
  connect(&this->Queue, &RunQueue::ended, this, &EdgeLens::changed);
  connect(&this->Queue, &RunQueue::failed, this, &EdgeLens::problem);
}

void EdgeLens::start(const ScenePtr& scene, const LensGrid& grid, const MethodSettings& settings)
{
  this->Grid = grid;
  this->Truth = scene->furnaceIlluminance();
  this->Queue.start(scene, methodJobs(settings, pointReceivers(grid.points, grid.normals), !this->Truth));
  emit this->changed();
}

void EdgeLens::forget()
{
  this->Queue.forget();
  this->Grid.reset();
}

QVector<double> EdgeLens::errors(int method) const
{
  const QVector<ResultPtr>& results = this->Queue.results();
  const int first = this->Truth ? 0 : 1;  // before it the reference
  const ResultPtr reference = first == 1 ? results.value(0) : nullptr;
  QVector<double> errors;
  for (int job = first; job < results.size(); ++job)
    if (this->Queue.jobs()[job].settings.method == method && results[job] && (this->Truth || reference))
      for (int i = 0; i < this->Grid->points.size(); ++i)
      {
        const double truth = this->Truth ? *this->Truth : estimateAt(*reference, i).value;
        errors << (truth > 0 ? estimateAt(*results[job], i).value / truth - 1 : 0);
      }
  return errors;
}
}  // namespace studio
