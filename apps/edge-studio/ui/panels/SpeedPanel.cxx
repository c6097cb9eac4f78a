// SPDX-License-Identifier: BSD-3-Clause
#include "panels/SpeedPanel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "common/Wording.h"

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
  all->setToolTip(tr("Runs the methods one after the other, with the settings of the panel Method"));
  this->Base = new QComboBox;
  this->Base->setObjectName(QStringLiteral("speedBase"));
  this->Base->setToolTip(tr("Draws the time that each run takes for the same error as a multiple of this one's"));
  this->View = new ChartView;
  this->Ratios = new QLabel;
  this->Ratios->setObjectName(QStringLiteral("speedRatios"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(about);
  layout->addWidget(all);
  layout->addWidget(this->View, 1);
  auto* ratio = new QHBoxLayout;
  ratio->addWidget(new QLabel(tr("Time relative to")));
  ratio->addWidget(this->Base, 1);
  layout->addLayout(ratio);
  layout->addWidget(this->Ratios);
  connect(all, &QPushButton::clicked, this, &SpeedPanel::runAll);
  connect(bench, &Workbench::resultsChanged, this, &SpeedPanel::show);
  connect(this->Base, qOverload<int>(&QComboBox::activated), this, &SpeedPanel::showRatios);
  connect(bench, &Workbench::runChanged, this,
          [this, all] { all->setEnabled(this->Bench->scene() && !this->Bench->isBusy()); });
  connect(bench, &Workbench::sceneChanged, this, [this, all] { all->setEnabled(!this->Bench->isBusy()); });
  all->setEnabled(false);
  this->show();
}

void SpeedPanel::show()
{
  this->View->setChart(this->chart());
  const int chosen = std::max(0, this->Base->currentIndex());
  this->Base->clear();
  for (const ResultPtr& result : this->Bench->results())
    this->Base->addItem(result ? nameOf(*result) : QString());
  this->Base->setCurrentIndex(std::min(chosen, this->Base->count() - 1));
  this->showRatios();
}

// The variance falls as one over the time, so error² × time does not depend on how long a run was.
void SpeedPanel::showRatios()
{
  const auto cost = [](const ResultPtr& result) {
    return result ? result->quality.typical * result->quality.typical * result->cpuSeconds : 0;
  };
  const double base = cost(this->Bench->results().value(this->Base->currentIndex()));
  QStringList lines;
  for (const ResultPtr& result : this->Bench->results())
    if (base > 0 && cost(result) > 0)
      lines << tr("%1: %2").arg(nameOf(*result)).arg(cost(result) / base, 0, 'g', 2);
  this->Ratios->setText(lines.join(QLatin1Char('\n')));
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
