// SPDX-License-Identifier: BSD-3-Clause
// The figures that lighting standards ask for, of each set of a result.
#ifndef studio_Statistics_h
#define studio_Statistics_h

#include <QJsonObject>
#include <QString>
#include <QVector>
#include <optional>

#include "results/Result.h"

namespace studio
{
/// Of the valid receivers of a set: those inside solids, below a surface or outside are left out.
struct SetStatistics
{
  QString name;
  qint64 points = 0, invalid = 0;
  double mean = 0;       ///< lx, weighted by the cells' areas
  double meanError = 0;  ///< lx, at most: values share trajectories
  double least = 0, largest = 0;
  Point leastAt, largestAt;  ///< m

  double uniformity() const { return this->mean > 0 ? this->least / this->mean : 0; }       ///< U0
  double diversity() const { return this->largest > 0 ? this->least / this->largest : 0; }  ///< Ud
};

QVector<SetStatistics> statisticsOf(const Result& result);

/// What a task, as of EN 12464-1, requires of a set.
struct Requirement
{
  double mean = 0;        ///< lx, at least; 0: nothing
  double uniformity = 0;  ///< U0, at least; 0: nothing

  QJsonObject toJson() const;
  /// Throws Problem.
  static Requirement fromJson(const QJsonObject& object, const QString& where);
};

enum class Verdict
{
  Pass,
  Fail,
  Undecided  ///< the mean is less than two standard errors away from what is required
};

/// Nothing where nothing is required.
std::optional<Verdict> judge(const SetStatistics& set, const Requirement& required);
}  // namespace studio

#endif
