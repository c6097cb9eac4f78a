// SPDX-License-Identifier: BSD-3-Clause
#include "results/Display.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>

#include "base/DataSets.h"
#include "base/JsonFields.h"
#include "base/Problem.h"
#include "results/Colours.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosArrayNames.h"

namespace studio
{
namespace
{
const QStringList quantityKeys{
    QStringLiteral("illuminance"),    QStringLiteral("direct-illuminance"), QStringLiteral("luminance"),
    QStringLiteral("standard-error"), QStringLiteral("relative-error"),     QStringLiteral("untrusted"),
    QStringLiteral("edge-distance"),  QStringLiteral("gather-rays"),        QStringLiteral("kernel-correction")};

const QStringList scaleKeys{QStringLiteral("linear"), QStringLiteral("logarithmic"), QStringLiteral("photographic")};

}  // namespace

double roundUp(double x)
{
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  for (double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5})
    if (x <= step * decade * (1 + 1e-9))
      return step * decade;
  return 10 * decade;
}

QVector<Quantity> quantities()
{
  QVector<Quantity> all;
  for (int i = 0; i < quantityKeys.size(); ++i)
    all << static_cast<Quantity>(i);
  return all;
}

bool isSigned(Quantity quantity)
{
  return quantity == Quantity::KernelCorrection;
}

bool hasQuantity(const Result& result, Quantity quantity)
{
  const QVector<NamedSet> sets = dataSets(result.data);
  return std::any_of(sets.begin(), sets.end(),
                     [&](const NamedSet& set) { return arrayOf(set.data, arrayName(quantity)) != nullptr; });
}

const char* arrayName(Quantity quantity)
{
  namespace Names = vtkKalosArrayNames;
  switch (quantity)
  {
    case Quantity::DirectIlluminance:
      return Names::DirectIlluminance;
    case Quantity::Luminance:
      return Names::Luminance;
    case Quantity::StandardError:
      return Names::IlluminanceStandardError;
    case Quantity::RelativeError:
      return relativeErrorName;
    case Quantity::Untrusted:
      return untrustedName;
    case Quantity::EdgeDistance:
      return Names::EdgeDistance;
    case Quantity::GatherRays:
      return Names::GatherRays;
    case Quantity::KernelCorrection:
      return Names::KernelCorrection;
    case Quantity::Illuminance:
      break;
  }
  return Names::Illuminance;
}

QString unitOf(Quantity quantity)
{
  switch (quantity)
  {
    case Quantity::Luminance:
      return QStringLiteral("cd/m²");
    case Quantity::RelativeError:
      return QStringLiteral("%");
    case Quantity::EdgeDistance:
      return QStringLiteral("m");
    case Quantity::Untrusted:
    case Quantity::GatherRays:
      return {};
    default:
      return QStringLiteral("lx");
  }
}

QJsonObject Display::toJson() const
{
  return {{QStringLiteral("quantity"), quantityKeys[static_cast<int>(this->quantity)]},
          {QStringLiteral("scale"), scaleKeys[static_cast<int>(this->scale)]},
          {QStringLiteral("automatic_range"), this->automaticRange},
          {QStringLiteral("range"), QJsonArray{this->range[0], this->range[1]}},
          {QStringLiteral("smooth"), this->smooth},
          {QStringLiteral("isolines"), this->isolines},
          {QStringLiteral("values"), this->values},
          {QStringLiteral("colours"), this->colours},
          {QStringLiteral("edges"), this->edges},
          {QStringLiteral("luminaires"), this->luminaires},
          {QStringLiteral("hidden"), QJsonArray::fromStringList(this->hidden)}};
}

Display Display::fromJson(const QJsonObject& object, const QString& where)
{
  Display d;
  JsonFields fields(object, where);
  int quantity = 0, scale = 0;
  fields.choice(QStringLiteral("quantity"), quantity, quantityKeys);
  d.quantity = static_cast<Quantity>(quantity);
  fields.choice(QStringLiteral("scale"), scale, scaleKeys);
  d.scale = static_cast<Scale>(scale);
  fields.flag(QStringLiteral("automatic_range"), d.automaticRange);
  fields.numbers(QStringLiteral("range"), d.range.data(), 2);
  fields.flag(QStringLiteral("smooth"), d.smooth);
  fields.flag(QStringLiteral("isolines"), d.isolines);
  fields.flag(QStringLiteral("values"), d.values);
  int colours = static_cast<int>(colourMaps().indexOf(d.colours));
  fields.choice(QStringLiteral("colours"), colours, colourMaps());
  d.colours = colourMaps()[colours];
  fields.flag(QStringLiteral("edges"), d.edges);
  fields.flag(QStringLiteral("luminaires"), d.luminaires);
  fields.texts(QStringLiteral("hidden"), d.hidden);
  fields.finish();
  if (!d.automaticRange && (!(d.range[0] < d.range[1]) || (d.scale == Scale::Logarithmic && !(d.range[0] > 0))))
    throw Problem(QStringLiteral("%1: is empty or not above 0 on a logarithmic scale, expected two rising numbers")
                      .arg(fields.at(QStringLiteral("range"))));
  return d;
}

std::vector<double> litValues(const QVector<ResultPtr>& results, const Display& display)
{
  std::vector<double> values;
  for (const ResultPtr& result : results)
    for (const NamedSet& set : dataSets(result ? result->data.Get() : nullptr))
      if (vtkDataArray* array =
              display.hidden.contains(set.name) ? nullptr : arrayOf(set.data, arrayName(display.quantity)))
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
          if (const double value = std::abs(array->GetComponent(i, 0)); value > 0 && std::isfinite(value))
            values.push_back(value);
  return values;
}

std::array<double, 2> rangeOf(const QVector<ResultPtr>& results, const Display& display)
{
  if (display.quantity == Quantity::Untrusted)
    return {0, 1};
  if (!display.automaticRange)
    return display.range;
  std::vector<double> values = litValues(results, display);
  const bool logarithmic = display.scale == Scale::Logarithmic;
  if (values.empty())
    return {logarithmic ? 1.0 : 0.0, 1000.0};
  const auto high = values.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), high, values.end());
  const double top = roundUp(*high);
  if (isSigned(display.quantity))
    return {-top, top};
  return {logarithmic ? 1e-3 * top : 0.0, top};
}

QVector<double> roundValues(const std::array<double, 2>& range, bool logarithmic, int count)
{
  QVector<double> values;
  if (logarithmic)
  {
    const double low = std::log10(range[0]), high = std::log10(range[1]);
    for (const bool between : {3 * (high - low) <= count, true})  // decades alone may be too few
    {
      values.clear();
      for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
        for (double step : {1.0, 2.0, 5.0})
          if (const double value = step * std::pow(10.0, decade);
              (step == 1.0 || between) && value >= range[0] * (1 - 1e-9) && value <= range[1] * (1 + 1e-9))
            values << value;
      if (values.size() > 2)
        return values;
    }
    return roundValues(range, false, std::min(count, 4));
  }
  const double raw = (range[1] - range[0]) / std::max(1, count);
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * decade;
  for (double round : {5.0, 2.0, 1.0})
    step = raw <= round * decade ? round * decade : step;
  for (double i = std::ceil(range[0] / step - 1e-9); i * step <= range[1] + 1e-9 * step; ++i)
    values << i * step;
  return values;
}
}  // namespace studio
