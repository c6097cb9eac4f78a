// SPDX-License-Identifier: BSD-3-Clause
#include "results/MethodSettings.h"

#include <QCoreApplication>
#include <limits>

#include "base/JsonFields.h"
#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
namespace
{
using Estimator = vtkKalosEstimatorAlgorithm;

const QStringList goalKeys{QStringLiteral("trajectories"), QStringLiteral("error"), QStringLiteral("time")};
}  // namespace

QString lengthText(double metres)
{
  return metres > 0 ? QCoreApplication::translate("MethodSettings", "%1 m").arg(metres)
                    : QCoreApplication::translate("MethodSettings", "auto");
}

const QVector<Method>& methods()
{
  static const QVector<Method> all{
      {Estimator::COMPENSATED, "compensated", false, false},
      {Estimator::GATHERED, "gathered", false, false},
      {Estimator::LOCAL, "local", false, false},
      {Estimator::SPHERE_EXACT, "sphere-exact", true, true},
      {Estimator::SPHERE_PUBLISHED, "sphere-published", true, true},
      {Estimator::DISC, "disc", false, true},
      {Estimator::CLAMPED, "clamped", true, false},
      {Estimator::DIRECT, "direct", false, true},
      {Estimator::PATHS, "paths", false, false},
      {Estimator::PHOTON_MAP, "photon-map", false, true},
  };
  return all;
}

const Method& methodOf(int id)
{
  for (const Method& method : methods())
    if (method.id == id)
      return method;
  return methods().front();
}

void MethodSettings::apply(Estimator* estimator) const
{
  estimator->SetMethod(this->method);
  estimator->SetTrajectories(this->goal == Goal::Trajectories ? this->trajectories : 0);
  estimator->SetRelativeError(this->goal == Goal::Error ? this->relativeError : 0);
  estimator->SetSeconds(this->goal == Goal::Time ? this->seconds : 0);
  estimator->SetDelta(this->delta);
  estimator->SetEpsilon(this->epsilon);
  estimator->SetSeed(this->seed);
}

QString MethodSettings::describe() const
{
  const Method& chosen = methodOf(this->method);
  QStringList parts{QString::fromLatin1(chosen.key)};
  switch (this->goal)
  {
    case Goal::Trajectories:
      parts << QCoreApplication::translate("MethodSettings", "%1 trajectories").arg(this->trajectories);
      break;
    case Goal::Error:
      parts << QCoreApplication::translate("MethodSettings", "to ±%1 %").arg(100 * this->relativeError);
      break;
    case Goal::Time:
      parts << QCoreApplication::translate("MethodSettings", "%1 s").arg(this->seconds);
      break;
  }
  if (chosen.usesDelta)
    parts << QStringLiteral("δ ") + lengthText(this->delta);
  if (chosen.usesEpsilon)
    parts << QStringLiteral("ε ") + lengthText(this->epsilon);
  return parts.join(QStringLiteral(", "));
}

QJsonObject MethodSettings::toJson() const
{
  return {{QStringLiteral("method"), QString::fromLatin1(methodOf(this->method).key)},
          {QStringLiteral("goal"), goalKeys[static_cast<int>(this->goal)]},
          {QStringLiteral("trajectories"), this->trajectories},
          {QStringLiteral("error"), this->relativeError},
          {QStringLiteral("seconds"), this->seconds},
          {QStringLiteral("delta"), this->delta},
          {QStringLiteral("epsilon"), this->epsilon},
          {QStringLiteral("seed"), this->seed}};
}

MethodSettings MethodSettings::fromJson(const QJsonObject& object, const QString& where)
{
  MethodSettings s;
  JsonFields fields(object, where);
  QStringList keys;
  for (const Method& method : methods())
    keys << QString::fromLatin1(method.key);
  int method = 0, goal = static_cast<int>(s.goal);
  fields.choice(QStringLiteral("method"), method, keys);
  fields.choice(QStringLiteral("goal"), goal, goalKeys);
  fields.integer(QStringLiteral("trajectories"), s.trajectories, 1);
  fields.number(QStringLiteral("error"), s.relativeError, 1e-6, 0.999);
  fields.number(QStringLiteral("seconds"), s.seconds, 1e-3, 1e6);
  fields.number(QStringLiteral("delta"), s.delta, 0, 1e6);
  fields.number(QStringLiteral("epsilon"), s.epsilon, 0, 1e6);
  fields.integer(QStringLiteral("seed"), s.seed, 0);
  fields.finish();
  s.method = methods()[method].id;
  s.goal = static_cast<Goal>(goal);
  return s;
}
}  // namespace studio
