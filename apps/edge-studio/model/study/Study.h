// SPDX-License-Identifier: BSD-3-Clause
// One method over trajectories, delta and epsilon, arranged as Table 1 of Budak et al. 2023: a row for
// each number of trajectories, a column for each delta and epsilon.
#ifndef studio_Study_h
#define studio_Study_h

#include <optional>

#include "results/Comparison.h"
#include "scene/SceneDocument.h"

namespace studio
{
struct Study
{
  MethodSettings base;  ///< method and seed of every cell
  QVector<double> trajectories;
  QVector<double> deltas, epsilons;  ///< m; 0: automatic

  int rows() const { return static_cast<int>(this->trajectories.size()); }
  int columns() const { return static_cast<int>(this->deltas.size() * this->epsilons.size()); }
  MethodSettings at(int row, int column) const;
  QString rowName(int row) const;
  QString columnName(int column) const;

  /// Row by row; before it the reference, where the truth is not known and `results` have none as good.
  QVector<MethodSettings> series(const SceneDocument& scene, const QVector<ResultPtr>& results) const;

  /// The newest of the results with the settings of each cell, row by row; null where there is none.
  QVector<ResultPtr> cells(const QVector<ResultPtr>& results) const;

  QJsonObject toJson() const;
  /// Throws Problem.
  static Study fromJson(const QJsonObject& object, const QString& where);
};

/// What the cells of a study are measured against: the one illuminance of a furnace, or of `results` the complete one
/// of the method without bias that has the most trajectories.
struct Reference
{
  std::optional<double> truth;  ///< lx
  ResultPtr result;
  QString describe() const;  ///< empty where there is neither
};
Reference referenceOf(const SceneDocument& scene, const QVector<ResultPtr>& results);

/// How far a result is from the reference; nothing where there is none, or where it is the result itself.
std::optional<Deviation> deviationFrom(const Reference& reference, const ResultPtr& result);
}  // namespace studio

#endif
