// SPDX-License-Identifier: BSD-3-Clause
#include "base/JsonFields.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>

#include "base/Problem.h"

namespace studio
{
QJsonValue JsonFields::take(const QString& key)
{
  this->Known.insert(key);
  return this->Object.value(key);
}

void JsonFields::refuse(const QString& key, const QString& expected) const
{
  const QJsonValue value = this->Object.value(key);
  QString found = QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
  found = found.mid(1, found.size() - 2).left(60);
  throw Problem(QStringLiteral("%1: is %2, expected %3").arg(this->at(key), found, expected));
}

void JsonFields::number(const QString& key, double& value, double least, double most)
{
  const QJsonValue found = this->take(key);
  if (found.isUndefined())
    return;
  const double number = found.toDouble(NAN);
  if (!(number >= least && number <= most))
    this->refuse(key, QStringLiteral("a number from %1 to %2").arg(least).arg(most));
  value = number;
}

void JsonFields::integer(const QString& key, qint64& value, qint64 least)
{
  const QJsonValue found = this->take(key);
  if (found.isUndefined())
    return;
  const double number = found.toDouble(NAN);
  if (!(number >= static_cast<double>(least) && number <= 0x1p53 && number == std::floor(number)))
    this->refuse(key, QStringLiteral("a whole number from %1").arg(least));
  value = static_cast<qint64>(number);
}

void JsonFields::flag(const QString& key, bool& value)
{
  const QJsonValue found = this->take(key);
  if (!found.isUndefined() && !found.isBool())
    this->refuse(key, QStringLiteral("true or false"));
  value = found.toBool(value);
}

void JsonFields::text(const QString& key, QString& value)
{
  const QJsonValue found = this->take(key);
  if (!found.isUndefined() && !found.isString())
    this->refuse(key, QStringLiteral("a text"));
  value = found.toString(value);
}

void JsonFields::choice(const QString& key, int& value, const QStringList& choices)
{
  const QJsonValue found = this->take(key);
  if (found.isUndefined())
    return;
  const int index = static_cast<int>(choices.indexOf(found.toString()));
  if (!found.isString() || index < 0)
    this->refuse(key, QStringLiteral("one of ") + choices.join(QStringLiteral(", ")));
  value = index;
}

void JsonFields::numbers(const QString& key, double* values, int count)
{
  const QJsonValue found = this->take(key);
  if (found.isUndefined())
    return;
  const QJsonArray array = found.toArray();
  bool good = array.size() == count;
  for (const QJsonValue& item : array)
    good = good && item.isDouble();
  if (!good)
    this->refuse(key, QStringLiteral("an array of %1 numbers").arg(count));
  for (int i = 0; i < count; ++i)
    values[i] = array[i].toDouble();
}

void JsonFields::list(const QString& key, QVector<double>& values, double least)
{
  QVector<double> found;
  for (const QJsonValue& item : this->array(key))
    found << item.toDouble(NAN);
  if (found.isEmpty() || !std::all_of(found.begin(), found.end(), [&](double number) { return number >= least; }))
    this->refuse(key, QStringLiteral("an array of numbers from %1").arg(least));
  values = found;
}

void JsonFields::texts(const QString& key, QStringList& values)
{
  const QJsonArray array = this->array(key);
  if (!std::all_of(array.begin(), array.end(), [](const QJsonValue& item) { return item.isString(); }))
    this->refuse(key, QStringLiteral("an array of texts"));
  for (const QJsonValue& item : array)
    values << item.toString();
}

QJsonObject JsonFields::object(const QString& key)
{
  const QJsonValue found = this->take(key);
  if (!found.isUndefined() && !found.isObject())
    this->refuse(key, QStringLiteral("an object"));
  return found.toObject();
}

QJsonArray JsonFields::array(const QString& key)
{
  const QJsonValue found = this->take(key);
  if (!found.isUndefined() && !found.isArray())
    this->refuse(key, QStringLiteral("an array"));
  return found.toArray();
}

void JsonFields::finish() const
{
  for (const QString& key : this->Object.keys())
    if (!this->Known.contains(key))
      throw Problem(QStringLiteral("%1: unknown, expected one of %2")
                        .arg(this->at(key), QStringList(this->Known.values()).join(QStringLiteral(", "))));
}
}  // namespace studio
