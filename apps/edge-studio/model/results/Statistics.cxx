// SPDX-License-Identifier: BSD-3-Clause
#include "results/Statistics.h"

#include <cmath>

#include "base/DataSets.h"
#include "base/JsonFields.h"
#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosArrayNames.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace studio
{
namespace
{
namespace Names = vtkKalosArrayNames;

double cellArea(vtkDataSet* data, vtkIdType id)
{
  vtkCell* cell = data->GetCell(id);
  Point sum(0, 0, 0), first, from, to;
  cell->GetPoints()->GetPoint(0, first.GetData());
  for (vtkIdType i = 2; i < cell->GetNumberOfPoints(); ++i)
  {
    cell->GetPoints()->GetPoint(i - 1, from.GetData());
    cell->GetPoints()->GetPoint(i, to.GetData());
    sum = sum + 0.5 * (from - first).Cross(to - first);
  }
  return sum.Norm();
}

SetStatistics statisticsOf(const NamedSet& set, vtkDataArray* lux, vtkDataArray* error)
{
  vtkDataArray* valid = arrayOf(set.data, Names::Valid);
  const bool ofPoints = set.data->GetPointData()->HasArray(Names::Illuminance);
  SetStatistics found;
  found.name = set.name;
  double weights = 0;
  for (vtkIdType i = 0; i < lux->GetNumberOfTuples(); ++i)
  {
    if (valid && valid->GetComponent(i, 0) == 0)
    {
      ++found.invalid;
      continue;
    }
    const double value = lux->GetComponent(i, 0), weight = ofPoints ? 1 : cellArea(set.data, i);
    if (found.points == 0 || value < found.least)
    {
      found.least = value;
      found.leastAt = receiverPosition(set.data, i);
    }
    if (found.points == 0 || value > found.largest)
    {
      found.largest = value;
      found.largestAt = receiverPosition(set.data, i);
    }
    found.mean += weight * value;
    found.meanError += weight * error->GetComponent(i, 0);
    weights += weight;
    ++found.points;
  }
  if (weights > 0)
  {
    found.mean /= weights;
    found.meanError /= weights;
  }
  return found;
}
}  // namespace

QVector<SetStatistics> statisticsOf(const Result& result)
{
  QVector<SetStatistics> all;
  for (const NamedSet& set : dataSets(result.data))
  {
    vtkDataArray *lux = arrayOf(set.data, Names::Illuminance),
                 *error = arrayOf(set.data, Names::IlluminanceStandardError);
    if (lux && error)
      all << statisticsOf(set, lux, error);
  }
  return all;
}

QJsonObject Requirement::toJson() const
{
  return {{QStringLiteral("mean"), this->mean}, {QStringLiteral("U0"), this->uniformity}};
}

Requirement Requirement::fromJson(const QJsonObject& object, const QString& where)
{
  Requirement required;
  JsonFields fields(object, where);
  fields.number(QStringLiteral("mean"), required.mean, 0, 1e9);
  fields.number(QStringLiteral("U0"), required.uniformity, 0, 1);
  fields.finish();
  return required;
}

std::optional<Verdict> judge(const SetStatistics& set, const Requirement& required)
{
  if (!(required.mean > 0) && !(required.uniformity > 0))
    return {};
  if (set.points == 0 || set.uniformity() < required.uniformity)
    return Verdict::Fail;
  if (required.mean > 0 && std::abs(set.mean - required.mean) < 2 * set.meanError)
    return Verdict::Undecided;
  return set.mean >= required.mean ? Verdict::Pass : Verdict::Fail;
}
}  // namespace studio
