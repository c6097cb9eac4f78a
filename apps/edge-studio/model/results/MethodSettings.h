// SPDX-License-Identifier: BSD-3-Clause
// What a user asks of a run: the properties of vtkKalosIlluminance, and their JSON.
#ifndef studio_MethodSettings_h
#define studio_MethodSettings_h

#include <QJsonObject>
#include <QString>
#include <QVector>
#include <tuple>

class vtkKalosEstimatorAlgorithm;

namespace studio
{
/// One method as the user meets it.
struct Method
{
  int id;           ///< vtkKalosEstimatorAlgorithm::MethodType
  const char* key;  ///< in files, as the command spells it
  bool usesDelta, usesEpsilon;
};

/// Every method, the default first.
const QVector<Method>& methods();
const Method& methodOf(int id);

enum class Goal
{
  Trajectories,
  Error,
  Time
};

/// "0.1 m"; "auto" for 0.
QString lengthText(double metres);

struct MethodSettings
{
  int method = methods().front().id;
  Goal goal = Goal::Trajectories;
  qint64 trajectories = 16384;  ///< read with Goal::Trajectories
  double relativeError = 0.1;   ///< 95 % half-width at every receiver; read with Goal::Error
  double seconds = 20;          ///< read with Goal::Time
  double delta = 0;             ///< m; 0: automatic
  double epsilon = 0;           ///< m; 0: automatic
  qint64 seed = 1;

  void apply(vtkKalosEstimatorAlgorithm* estimator) const;

  /// One line for a person, without the seed: "sphere-exact, 16384 trajectories, δ 0.1 m, ε auto".
  QString describe() const;

  QJsonObject toJson() const;
  /// Throws Problem for an unknown key, a wrong type or a value out of range; `where` names the object in the file.
  static MethodSettings fromJson(const QJsonObject& object, const QString& where);

  auto members() const
  {
    return std::tie(this->method, this->goal, this->trajectories, this->relativeError, this->seconds, this->delta,
                    this->epsilon, this->seed);
  }
  bool operator==(const MethodSettings& other) const { return this->members() == other.members(); }
  bool operator!=(const MethodSettings& other) const { return !(*this == other); }
};
}  // namespace studio

#endif
