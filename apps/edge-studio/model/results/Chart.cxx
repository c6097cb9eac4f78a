// SPDX-License-Identifier: BSD-3-Clause
#include "results/Chart.h"

#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
Series straight(const QString& name, unsigned colour, bool dashed, const QPointF& from, const QPointF& to)
{
  Series series;
  series.name = name;
  series.colour = colour;
  series.dashed = dashed;
  series.points << from << to;
  return series;
}

QByteArray toCsv(const Chart& chart)
{
  auto number = [](double value) { return QByteArray::number(value, 'g', 9); };
  QByteArray text = "# x: " + chart.xLabel.toUtf8() + "; y: " + chart.yLabel.toUtf8() + "\nseries,x,y,half_width\n";
  for (const Series& series : chart.series)
    for (int i = 0; i < series.points.size(); ++i)
      text += '"' + QString(series.name).replace(QLatin1Char('"'), QStringLiteral("\"\"")).toUtf8() + "\"," +
              number(series.points[i].x()) + ',' + number(series.points[i].y()) + ',' +
              (i < series.halfWidth.size() ? number(series.halfWidth[i]) : QByteArray()) + '\n';
  return text;
}

unsigned methodColour(int method)
{
  using Estimator = vtkKalosEstimatorAlgorithm;
  switch (method)
  {
    case Estimator::COMPENSATED:
      return 0x1b6ca8;
    case Estimator::GATHERED:
      return 0x17a2b8;
    case Estimator::LOCAL:
      return 0xd1495b;
    case Estimator::SPHERE_EXACT:
      return 0x2e8b57;
    case Estimator::SPHERE_PUBLISHED:
      return 0x9ac04f;
    case Estimator::DISC:
      return 0xe39d2b;
    case Estimator::CLAMPED:
      return 0x8a5fbf;
    default:
      return 0x6f7378;
  }
}
}  // namespace studio
