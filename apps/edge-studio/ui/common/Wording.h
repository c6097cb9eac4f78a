// SPDX-License-Identifier: BSD-3-Clause
// Texts of the user interface that depend on values.
#ifndef studio_Wording_h
#define studio_Wording_h

#include <QString>

#include "results/Display.h"
#include "run/Run.h"

namespace studio
{
/// A method in a sentence or two.
QString explain(int method);

QString title(Quantity quantity);

/// What a quantity tells, in a sentence.
QString explain(Quantity quantity);

/// "4.2 s · about 11 s left"; "4.2 s · almost done" in the last second
QString describeTimes(const Run& run);

/// "4096 trajectories at 13 000 points / standard error 1.3 %, largest 9.8 % / 14 points not to be trusted"
QString describeQuality(const Result& result);

/// The name that a user gave a result, else its settings in a line.
QString nameOf(const Result& result);

/// What a picture of a result shows: "compensated · N 4096 · seed 1 · error 1.3 %".
QString describeShown(const Result& result);

/// "13 000"
QString grouped(qint64 number);

/// Two to three significant digits: "0.34 %", "12 %".
QString percent(double fraction);

/// "24 ms", "12 s", "3 min 20 s"
QString duration(double seconds);
}  // namespace studio

#endif
