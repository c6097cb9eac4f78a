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
  StandardError,
  RelativeError,
  Untrusted,
  EdgeDistance,
  GatherRays,
  KernelCorrection
};

/// All of them, in the order in which they are offered.
QVector<Quantity> quantities();

/// The mapping of values to colours.
enum class Scale
{
  Linear,
  Logarithmic,
  Photographic  ///< tone-mapped, see ToneMapping.h
};

const char* arrayName(Quantity quantity);
QString unitOf(Quantity quantity);

/// Whether values may be below 0: they are shown about 0, on a linear scale.
bool isSigned(Quantity quantity);

/// Whether some set of the result has it: not every method sends gather rays or alters the kernel.
bool hasQuantity(const Result& result, Quantity quantity);

struct Display
{
  Quantity quantity = Quantity::Illuminance;
  Scale scale = Scale::Linear;
  bool automaticRange = true;
  std::array<double, 2> range{0, 1000};  ///< in the quantity's unit; read where automaticRange is off
  bool smooth = true;                    ///< interpolate between receivers of one plane
  bool isolines = false;
  bool values = false;                        ///< written on planes
  QString colours = QStringLiteral("kalos");  ///< one of colourMaps(), see Colours.h
  bool edges = true;
  bool luminaires = true;
  QStringList hidden;  ///< receiver sets that are not drawn

  QJsonObject toJson() const;
  /// Throws Problem.
  static Display fromJson(const QJsonObject& object, const QString& where);
  bool operator==(const Display& other) const { return this->toJson() == other.toJson(); }
  bool operator!=(const Display& other) const { return !(*this == other); }
};

/// The round number (1, 1.5, 2, 3, 5, 7.5 times a power of ten) at or above x > 0.
double roundUp(double x);

/// All values of the shown quantity that are not 0, without their signs, of all sets that are not hidden.
std::vector<double> litValues(const QVector<ResultPtr>& results, const Display& display);

/// From 0 (logarithmic scale: three decades below; signed quantities: minus the other end) to a round number above all
/// but the highest half per cent of the values of these results: a few spikes must not take the colours from everything
/// else.
std::array<double, 2> rangeOf(const QVector<ResultPtr>& results, const Display& display);

/// Round values inside a range for ticks and isolines: about `count`, powers of ten and their double and fivefold on a
/// logarithmic scale that holds three of them.
QVector<double> roundValues(const std::array<double, 2>& range, bool logarithmic, int count);
}  // namespace studio

#endif
