// SPDX-License-Identifier: BSD-3-Clause
#include "panels/SpeedPanel.h"

#include <QLabel>
#include <QVBoxLayout>

namespace studio
{
SpeedPanel::SpeedPanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  auto* about =
      new QLabel(tr("Standard error over all points while each method ran. What a biased method averages away "
                    "is not in it."));
  about->setWordWrap(true);
  auto* all = new QPushButton(tr("Run every method"));
  all->setObjectName(QStringLiteral("runAll"));
  this->View = new ChartView;
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(about);
  layout->addWidget(all);
  layout->addWidget(this->View, 1);
  connect(all, &QPushButton::clicked, this, &SpeedPanel::runAll);
  connect(bench, &Workbench::resultsChanged, this, [this] { this->View->setChart(this->chart()); });
  connect(bench, &Workbench::runChanged, this,
          [this, all] { all->setEnabled(this->Bench->scene() && !this->Bench->isBusy()); });
  connect(bench, &Workbench::sceneChanged, this, [this, all] { all->setEnabled(!this->Bench->isBusy()); });
  all->setEnabled(false);
  this->View->setChart(this->chart());
}

void SpeedPanel::runAll()
{
  QVector<MethodSettings> series;
  for (const Method& method : methods())
  {
    MethodSettings settings = this->Bench->settings();
    settings.method = method.id;
    settings.seed += series.size();
    series << settings;
  }
  this->Bench->runSeries(series);
}

Chart SpeedPanel::chart() const
{
  Chart chart;
  chart.xLabel = tr("time, s");
  chart.yLabel = tr("relative standard error, %");
  chart.logX = chart.logY = true;
  chart.empty = tr("Nothing has run yet");
  for (int i = 0; i < this->Bench->tracks().size(); ++i)
  {
    Series series;
    const MethodSettings& settings = this->Bench->results()[i]->settings;
    series.name = QString::fromLatin1(methodOf(settings.method).key);
    series.colour = methodColour(settings.method);
    series.style = Series::Style::LineAndPoints;
    for (const QPointF& point : this->Bench->tracks()[i])
      series.points << QPointF(point.x(), 100 * point.y());
    chart.series << series;
  }
  return chart;
}
}  // namespace studio
