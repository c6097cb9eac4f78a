// SPDX-License-Identifier: BSD-3-Clause
#include "study/Study.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "base/JsonFields.h"
#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
namespace
{
constexpr int unbiased = vtkKalosEstimatorAlgorithm::COMPENSATED;

QString tr(const char* text)
{
  return QCoreApplication::translate("Study", text);
}

QJsonArray array(const QVector<double>& numbers)
{
  QJsonArray values;
  for (double number : numbers)
    values.append(number);
  return values;
}
}  // namespace

MethodSettings Study::at(int row, int column) const
{
  const auto across = static_cast<int>(this->epsilons.size());
  MethodSettings settings = this->base;
  settings.goal = Goal::Trajectories;
  settings.trajectories = std::llround(this->trajectories[row]);
  settings.delta = this->deltas[column / across];
  settings.epsilon = this->epsilons[column % across];
  return settings;
}

QString Study::rowName(int row) const
{
  return tr("N = %1").arg(this->at(row, 0).trajectories);
}

QString Study::columnName(int column) const
{
  const MethodSettings settings = this->at(0, column);
  return tr("δ %1\nε %2").arg(lengthText(settings.delta), lengthText(settings.epsilon));
}

QVector<MethodSettings> Study::series(const SceneDocument& scene, const QVector<ResultPtr>& results) const
{
  QVector<MethodSettings> series;
  MethodSettings reference = this->base;
  reference.method = unbiased;
  reference.goal = Goal::Trajectories;
  reference.trajectories = 8 * std::llround(*std::max_element(this->trajectories.begin(), this->trajectories.end()));
  reference.seed += 1000;  // its errors are independent of theirs
  const Reference known = referenceOf(scene, results);
  if (!known.truth && !(known.result && known.result->trajectories >= reference.trajectories))
    series << reference;
  for (int row = 0; row < this->rows(); ++row)
    for (int column = 0; column < this->columns(); ++column)
      series << this->at(row, column);
  return series;
}

QVector<ResultPtr> Study::cells(const QVector<ResultPtr>& results) const
{
  QVector<ResultPtr> found;
  for (int row = 0; row < this->rows(); ++row)
    for (int column = 0; column < this->columns(); ++column)
    {
      const MethodSettings wanted = this->at(row, column);
      const auto newest = std::find_if(results.rbegin(), results.rend(),
                                       [&](const ResultPtr& result) { return result && result->settings == wanted; });
      found << (newest == results.rend() ? nullptr : *newest);
    }
  return found;
}

QJsonObject Study::toJson() const
{
  return {{QStringLiteral("settings"), this->base.toJson()},
          {QStringLiteral("trajectories"), array(this->trajectories)},
          {QStringLiteral("delta"), array(this->deltas)},
          {QStringLiteral("epsilon"), array(this->epsilons)}};
}

Study Study::fromJson(const QJsonObject& object, const QString& where)
{
  Study study;
  JsonFields fields(object, where);
  fields.read(QStringLiteral("settings"), study.base);
  fields.list(QStringLiteral("trajectories"), study.trajectories, 1);
  fields.list(QStringLiteral("delta"), study.deltas, 0);
  fields.list(QStringLiteral("epsilon"), study.epsilons, 0);
  fields.finish();
  return study;
}

QString Reference::describe() const
{
  if (this->truth)
    return tr("the known %1 lx").arg(*this->truth);
  return this->result ? this->result->settings.describe() : QString();
}

Reference referenceOf(const SceneDocument& scene, const QVector<ResultPtr>& results)
{
  Reference reference{scene.furnaceIlluminance(), nullptr};
  for (const ResultPtr& result : results)
    if (result && result->complete && result->settings.method == unbiased &&
        (!reference.result || result->trajectories > reference.result->trajectories))
      reference.result = result;
  return reference;
}

std::optional<Deviation> deviationFrom(const Reference& reference, const ResultPtr& result)
{
  if (reference.truth)
    return deviationFrom(*reference.truth, *result);
  if (!reference.result || reference.result == result)
    return {};
  return deviationFrom(*reference.result, *result);
}
}  // namespace studio
