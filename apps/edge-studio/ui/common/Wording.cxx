// SPDX-License-Identifier: BSD-3-Clause
#include "common/Wording.h"

#include <QCoreApplication>
#include <cmath>

#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
namespace
{
QString tr(const char* text)
{
  return QCoreApplication::translate("studio", text);
}

}  // namespace

QString grouped(qint64 number)
{
  QString text = QString::number(number);
  for (int i = static_cast<int>(text.size()) - 3; i > 0 && number >= 10000; i -= 3)
    text.insert(i, QChar(0x202F));
  return text;
}

QString explain(int method)
{
  using Estimator = vtkKalosEstimatorAlgorithm;
  switch (method)
  {
    case Estimator::GATHERED:
      return tr("Rays gather the light of a cache over the surfaces: fast; its bias shrinks with the cells");
    case Estimator::LOCAL:
      return tr("Plain local estimation: unbiased, with spikes along concave edges and contacts");
    case Estimator::SPHERE_EXACT:
      return tr("Within δ the kernel is averaged over a ball of radius ε with its exact weight; biased at edges");
    case Estimator::SPHERE_PUBLISHED:
      return tr("Within δ the kernel is averaged over a ball of radius ε with the weight as published; biased low");
    case Estimator::DISC:
      return tr("The kernel is averaged over a disc of radius ε about the point, as a meter head does");
    case Estimator::CLAMPED:
      return tr("Within δ the kernel is clamped; biased low");
    case Estimator::DIRECT:
      return tr("Direct simulation: the flux that crosses a cell, over its area");
    default:
      return tr("Bounded and unbiased: what vertices nearby would spike is gathered with rays");
  }
}

QString title(Quantity quantity)
{
  switch (quantity)
  {
    case Quantity::DirectIlluminance:
      return tr("Direct light");
    case Quantity::Luminance:
      return tr("Luminance");
    case Quantity::StandardError:
      return tr("Std. error");
    case Quantity::RelativeError:
      return tr("Relative error");
    case Quantity::Untrusted:
      return tr("Untrusted");
    case Quantity::EdgeDistance:
      return tr("Edge distance");
    case Quantity::GatherRays:
      return tr("Gather rays");
    case Quantity::KernelCorrection:
      return tr("Kernel change");
    case Quantity::Illuminance:
      break;
  }
  return tr("Illuminance");
}

QString explain(Quantity quantity)
{
  switch (quantity)
  {
    case Quantity::DirectIlluminance:
      return tr("Light straight from the luminaires");
    case Quantity::Luminance:
      return tr("What surfaces send out diffusely, (ρE + M)/π; gloss and mirrors are in the image");
    case Quantity::StandardError:
      return tr("Standard error of the illuminance");
    case Quantity::RelativeError:
      return tr("Standard error in per cent of the illuminance");
    case Quantity::Untrusted:
      return tr("1 where the standard error cannot be believed, because a few scores dominate");
    case Quantity::EdgeDistance:
      return tr("Distance to the nearest singular edge");
    case Quantity::GatherRays:
      return tr("Rays that compensated has sent from each point");
    case Quantity::KernelCorrection:
      return tr("What a method changes by averaging or clamping the kernel, on the same trajectories");
    case Quantity::Illuminance:
      break;
  }
  return tr("Direct and reflected light");
}

QString duration(double seconds)
{
  if (seconds < 0.1)
    return tr("%1 ms").arg(1000 * seconds, 0, 'g', 2);
  if (seconds < 10)
    return tr("%1 s").arg(seconds, 0, 'f', 1);
  if (seconds < 100)
    return tr("%1 s").arg(std::lround(seconds));
  return tr("%1 min %2 s").arg(static_cast<int>(seconds) / 60).arg(static_cast<int>(seconds) % 60);
}

QString percent(double fraction)
{
  return tr("%1 %").arg(QString::number(100 * fraction, 'g', fraction < 0.1 ? 2 : 3));
}

QString describeTimes(const Run& run)
{
  const QString elapsed = duration(run.elapsed());
  switch (run.state())
  {
    case Run::State::Running:
      if (const auto left = run.remaining())
        return *left < 1 ? tr("%1 · almost done").arg(elapsed) : tr("%1 · about %2 left").arg(elapsed, duration(*left));
      return elapsed;
    case Run::State::Paused:
      return tr("%1 · paused").arg(elapsed);
    case Run::State::Cancelled:
      return tr("%1 · cancelled").arg(elapsed);
    case Run::State::Failed:
      return tr("failed");
    case Run::State::Finished:
      break;
  }
  return tr("%1 · finished").arg(elapsed);
}

QString nameOf(const Result& result)
{
  return result.name.isEmpty() ? result.settings.describe() : result.name;
}

QString describeShown(const Result& result)
{
  const Method& method = methodOf(result.settings.method);
  QStringList parts{result.name.isEmpty() ? QString::fromLatin1(method.key) : result.name};
  if (method.usesDelta)
    parts << tr("δ %1").arg(lengthText(result.settings.delta));
  if (method.usesEpsilon)
    parts << tr("ε %1").arg(lengthText(result.settings.epsilon));
  parts << tr("N %1").arg(grouped(result.trajectories)) << tr("seed %1").arg(result.settings.seed);
  if (result.preview)
    parts << tr("first colours");
  else
    parts << tr("error %1").arg(percent(result.quality.typical));
  return parts.join(QStringLiteral(" · "));
}

QString describeQuality(const Result& result)
{
  if (result.preview)
    return tr("first colours: a few points stand for all");
  const Quality& quality = result.quality;
  QString text = tr("%1 trajectories at %2 points\nstandard error %3, largest %4")
                     .arg(grouped(result.trajectories), grouped(quality.receivers), percent(quality.typical),
                          percent(quality.largest));
  if (quality.untrusted > 0)
    text += QLatin1Char('\n') + tr("%1 points not to be trusted").arg(grouped(quality.untrusted));
  if (quality.invalid > 0)
    text += QLatin1Char('\n') + tr("%1 points inside solids or outside left out").arg(grouped(quality.invalid));
  return text;
}
}  // namespace studio
