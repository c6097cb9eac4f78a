// SPDX-License-Identifier: BSD-3-Clause
// Display settings, and the range of values that a picture of a result needs.
#ifndef studio_Display_h
#define studio_Display_h

#include <QJsonObject>
#include <QStringList>
#include <QVector>
#include <array>
#include <vector>

#include "results/Result.h"

namespace studio
{
enum class Quantity
{
  Illuminance,
  DirectIlluminance,
  Luminance,
  StandardError
};

/// The mapping of values to colours.
enum class Scale
{
  Linear,
  Logarithmic,
  Photographic  ///< tone-mapped, see ToneMapping.h
};

const char* arrayName(Quantity quantity);
QString unitOf(Quantity quantity);

struct Display
{
  Quantity quantity = Quantity::Illuminance;
  Scale scale = Scale::Linear;
  bool automaticRange = true;
  std::array<double, 2> range{0, 1000};  ///< in the quantity's unit; read where automaticRange is off
  bool smooth = true;                    ///< interpolate between receivers of one plane
  bool isolines = false;
  bool edges = true;
  bool luminaires = true;
  QStringList hidden;  ///< receiver sets that are not drawn

  QJsonObject toJson() const;
  /// Throws Problem.
  static Display fromJson(const QJsonObject& object, const QString& where);
  bool operator==(const Display& other) const { return this->toJson() == other.toJson(); }
  bool operator!=(const Display& other) const { return !(*this == other); }
};

/// All values above 0 of the shown quantity, of all sets that are not hidden.
std::vector<double> litValues(const QVector<ResultPtr>& results, const Display& display);

/// From 0 (logarithmic scale: three decades below) to a round number above all but the highest half per cent of the
/// values of these results: a few spikes must not take the colours from everything else.
std::array<double, 2> rangeOf(const QVector<ResultPtr>& results, const Display& display);

/// Round values inside a range for ticks and isolines: about `count`, powers of ten and their double and fivefold on a
/// logarithmic scale that holds three of them.
QVector<double> roundValues(const std::array<double, 2>& range, bool logarithmic, int count);
}  // namespace studio

#endif
