// SPDX-License-Identifier: BSD-3-Clause
// Reads the members of a JSON object and refuses what it does not know.
#ifndef studio_JsonFields_h
#define studio_JsonFields_h

#include <QJsonObject>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QVector>

namespace studio
{
/// Every member is optional: what is absent keeps its value. Each reader throws Problem, naming `where`, the key, what
/// is wrong and what is expected.
class JsonFields
{
public:
  JsonFields(QJsonObject object, QString where) : Object(std::move(object)), Where(std::move(where)) {}

  void number(const QString& key, double& value, double least, double most);
  void integer(const QString& key, qint64& value, qint64 least);
  void flag(const QString& key, bool& value);
  void text(const QString& key, QString& value);
  /// An index into `choices`.
  void choice(const QString& key, int& value, const QStringList& choices);
  /// `count` finite numbers.
  void numbers(const QString& key, double* values, int count);
  /// Numbers from `least`, at least one.
  void list(const QString& key, QVector<double>& values, double least);
  void texts(const QString& key, QStringList& values);
  /// A member that is read by the fromJson() of its class.
  template <class Value>
  void read(const QString& key, Value& value)
  {
    value = Value::fromJson(this->object(key), this->at(key));
  }
  QJsonObject object(const QString& key);
  QJsonArray array(const QString& key);

  /// Refuses members that none of the above has asked for.
  void finish() const;

  QString at(const QString& key) const { return this->Where + QLatin1Char('/') + key; }

private:
  QJsonValue take(const QString& key);
  [[noreturn]] void refuse(const QString& key, const QString& expected) const;

  QJsonObject Object;
  QString Where;
  QSet<QString> Known;
};
}  // namespace studio

#endif
